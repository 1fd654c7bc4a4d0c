//! Where water runs: every cell hands its water to one neighbour, through lakes as well, until it leaves the land.
//! Source: Barnes, Lehman and Mulla, "Priority-flood", 2014, with buckets of equal height in place of a heap.

use super::super::hash::{hash, unit};
use super::land::Land;

/// Routes of all water.
#[derive(Clone, Debug)]
pub struct Flow {
    /// Cells, each after the one that it drains to.
    pub order: Vec<u32>,
    /// The cell that takes the water; an outlet takes its own.
    pub receiver: Vec<u32>,
    /// Square metres of land that drain through each cell.
    pub area: Vec<f32>,
}

/// Metres of height that share a bucket.
const BUCKET: f32 = 0.04;

/// Finds the routes. `outlet` says where water leaves; among the neighbours below, steep ones are taken more often than
/// gentle ones: a fixed choice of eight directions would show in the valleys.
pub fn route(land: &Land, outlet: &[bool], seed: u32) -> Flow {
    let count = land.height.len();
    let low = land.height.iter().copied().fold(f32::MAX, f32::min);
    let high = land.height.iter().copied().fold(f32::MIN, f32::max);
    let mut buckets = vec![Vec::new(); ((high - low) / BUCKET) as usize + 2];
    let level = |index: usize| ((land.height[index] - low) / BUCKET) as usize;
    let mut flow = Flow { order: Vec::with_capacity(count), receiver: vec![u32::MAX; count], area: Vec::new() };
    let mut done = vec![false; count];
    for index in (0..count).filter(|&index| outlet[index]) {
        flow.receiver[index] = index as u32;
        buckets[level(index)].push(index as u32);
    }
    for current in 0..buckets.len() {
        let mut next = 0;
        while next < buckets[current].len() {
            let index = buckets[current][next] as usize;
            next += 1;
            flow.order.push(index as u32);
            done[index] = true;
            descend(land, &mut flow, &done, seed, index);
            for (_, other, _) in land.around(index) {
                if flow.receiver[other] == u32::MAX {
                    flow.receiver[other] = index as u32;
                    buckets[level(other).max(current)].push(other as u32);
                }
            }
        }
        buckets[current] = Vec::new();
    }
    flow.area = gather(land, &flow);
    flow
}

/// Takes a steep way down among the cells that are already routed.
fn descend(land: &Land, flow: &mut Flow, done: &[bool], seed: u32, index: usize) {
    if flow.receiver[index] == index as u32 {
        return;
    }
    let mut best = 0.0;
    for (direction, other, distance) in land.around(index).filter(|&(_, other, _)| done[other]) {
        let chance = 0.3 + unit(hash(seed, index as u32, direction as u32));
        let score = (land.height[index] - land.height[other]) / distance * chance;
        if score > best {
            best = score;
            flow.receiver[index] = other as u32;
        }
    }
}

fn gather(land: &Land, flow: &Flow) -> Vec<f32> {
    let mut area = vec![land.cell * land.cell; land.height.len()];
    for &index in flow.order.iter().rev() {
        let receiver = flow.receiver[index as usize] as usize;
        if receiver != index as usize {
            area[receiver] += area[index as usize];
        }
    }
    area
}

/// Metres between the centres of a cell and its receiver.
pub fn run(land: &Land, index: usize, receiver: usize) -> f32 {
    let apart = index.abs_diff(receiver);
    let straight = apart == 1 || apart == land.size;
    land.cell * if straight { 1.0 } else { std::f32::consts::SQRT_2 }
}
