//! Valley floors: ice and wandering rivers widen what a river alone would leave as a notch.

use rayon::prelude::*;

use super::flow::Flow;
use super::land::Land;

/// How valleys are widened.
#[derive(Clone, Copy, Debug)]
pub struct Valley {
    /// Square metres of drained land from which on a valley has a floor.
    pub area: f32,
    /// Half width of the floor in metres where a square kilometre drains.
    pub width: f32,
    /// Rise over run of the floor towards its sides.
    pub rise: f32,
    /// Metres beyond the floor over which its side steepens to 45 degrees.
    pub bend: f32,
}

/// The nearest river that shapes a cell.
#[derive(Clone, Copy)]
struct Bank {
    /// The river's cell.
    river: u32,
    /// Metres to the border of its floor; negative on the floor.
    beyond: f32,
}

/// Lowers the land beside rivers to their floors.
pub fn widen(land: &mut Land, flow: &Flow, valley: &Valley) {
    let banks = banks(land, flow, valley);
    let old = land.height.clone();
    land.height.par_iter_mut().zip(&banks).for_each(|(height, bank)| {
        if let Some(bank) = bank {
            let side = bank.beyond.max(0.0);
            let near = width(flow, valley, bank.river as usize) + bank.beyond;
            let top = old[bank.river as usize] + valley.rise * near.max(0.0) + 0.5 * side * side / valley.bend;
            *height = soft_min(*height, top, 12.0);
        }
    });
}

fn width(flow: &Flow, valley: &Valley, river: usize) -> f32 {
    valley.width * libm::powf(flow.area[river] * 1e-6, 0.4)
}

/// Spreads rivers over the land: two sweeps there, two back, each cell looking at four that were seen before it.
fn banks(land: &Land, flow: &Flow, valley: &Valley) -> Vec<Option<Bank>> {
    let river = |index: usize| {
        let beyond = -width(flow, valley, index);
        (flow.area[index] > valley.area).then_some(Bank { river: index as u32, beyond })
    };
    let mut banks: Vec<Option<Bank>> = (0..land.height.len()).map(river).collect();
    let n = land.size as i32;
    for _ in 0..2 {
        for y in 0..n {
            for x in 0..n {
                look(land, flow, valley, &mut banks, (x, y), [(-1, 0), (-1, -1), (0, -1), (1, -1)]);
            }
            for x in (0..n).rev() {
                look(land, flow, valley, &mut banks, (x, y), [(1, 0), (-1, -1), (0, -1), (1, -1)]);
            }
        }
        for y in (0..n).rev() {
            for x in (0..n).rev() {
                look(land, flow, valley, &mut banks, (x, y), [(1, 0), (1, 1), (0, 1), (-1, 1)]);
            }
            for x in 0..n {
                look(land, flow, valley, &mut banks, (x, y), [(-1, 0), (1, 1), (0, 1), (-1, 1)]);
            }
        }
    }
    banks
}

fn look(
    land: &Land,
    flow: &Flow,
    valley: &Valley,
    banks: &mut [Option<Bank>],
    (x, y): (i32, i32),
    steps: [(i32, i32); 4],
) {
    let n = land.size as i32;
    let here = (y * n + x) as usize;
    for (dx, dy) in steps {
        let Some(Bank { river, .. }) = land.neighbour((x, y), dx, dy).and_then(|other| banks[other]) else { continue };
        let (rx, ry) = (river as i32 % n, river as i32 / n);
        let distance = (((rx - x) * (rx - x) + (ry - y) * (ry - y)) as f32).sqrt() * land.cell;
        let beyond = distance - width(flow, valley, river as usize);
        if banks[here].is_none_or(|bank| beyond < bank.beyond) {
            banks[here] = Some(Bank { river, beyond });
        }
    }
}

/// The smaller of two, rounded where they meet over a length.
fn soft_min(a: f32, b: f32, round: f32) -> f32 {
    let h = (round - (a - b).abs()).max(0.0) / round;
    a.min(b) - h * h * round * 0.25
}
