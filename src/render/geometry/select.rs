//! Which leaves a camera asks for.

use glam::DVec3;

use super::bounds::{Bounds, CELLS};
use crate::render::height_field::HeightField;

/// What lies beyond the two outer sides of a leaf on one axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Leaves of the same level or finer, or the end of the terrain.
    Same,
    /// A coarser leaf to the west or north.
    LowCoarser,
    /// A coarser leaf to the east or south.
    HighCoarser,
}

/// A leaf of the quadtree: a grid of 33 × 33 vertices with `1 << level` texels between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patch {
    /// Texel of the north-west corner.
    pub texel: [i32; 2],
    /// log2 of the texels between vertices.
    pub level: u32,
    /// Neighbours on x and z.
    pub sides: [Side; 2],
}

impl Patch {
    /// Position in [`super::Grid::indices`].
    #[must_use]
    pub fn permutation(&self) -> usize {
        self.sides[0] as usize * 3 + self.sides[1] as usize
    }

    /// Its node on its level.
    #[must_use]
    pub fn node(&self) -> [u32; 2] {
        self.texel.map(|texel| texel as u32 / (CELLS << self.level))
    }
}

/// Leaves that cover the whole terrain so that no texel is displaced by more than `tolerance` radians as seen from `eye`
/// (metres), with neighbours that differ by one level at most. From north to south within each quarter.
#[must_use]
pub fn select(field: &HeightField, bounds: &Bounds, eye: DVec3, tolerance: f64) -> Vec<Patch> {
    let mut tree = Tree::new(bounds);
    tree.split_where_needed(field, eye, tolerance, tree.root(), 0, 0);
    tree.balance();
    let mut leaves = Vec::new();
    tree.collect(tree.root(), 0, 0, &mut leaves);
    leaves
}

/// The quadtree's choice: for each node of each level whether it is split.
struct Tree<'a> {
    bounds: &'a Bounds,
    split: Vec<Vec<bool>>,
}

impl<'a> Tree<'a> {
    fn new(bounds: &'a Bounds) -> Self {
        let nodes = |level| bounds.nodes(level).iter().product::<u32>() as usize;
        Self { bounds, split: (0..bounds.levels()).map(|level| vec![false; nodes(level)]).collect() }
    }

    fn root(&self) -> u32 {
        self.bounds.levels() - 1
    }

    fn is_split(&self, level: u32, x: u32, z: u32) -> bool {
        self.split[level as usize][(z * self.bounds.nodes(level)[0] + x) as usize]
    }

    fn set_split(&mut self, level: u32, x: u32, z: u32) {
        self.split[level as usize][(z * self.bounds.nodes(level)[0] + x) as usize] = true;
    }

    /// The children of a node that lie on the terrain.
    fn children(&self, level: u32, x: u32, z: u32) -> impl Iterator<Item = (u32, u32)> + use<> {
        let nodes = self.bounds.nodes(level - 1);
        let all = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| (2 * x + i, 2 * z + j));
        all.into_iter().filter(move |&(x, z)| x < nodes[0] && z < nodes[1])
    }

    fn split_where_needed(&mut self, field: &HeightField, eye: DVec3, tolerance: f64, level: u32, x: u32, z: u32) {
        let node = self.bounds.node(level, x, z);
        let near = distance_to_box(eye, node_box(field, self.bounds, level, x, z));
        if level == 0 || f64::from(node.error) <= tolerance * near {
            return;
        }
        self.set_split(level, x, z);
        for (x, z) in self.children(level, x, z) {
            self.split_where_needed(field, eye, tolerance, level - 1, x, z);
        }
    }

    /// A split node's neighbours must exist on its own level, so that its children meet leaves one level coarser at most.
    /// From fine to coarse, once: what a level adds is only above it.
    fn balance(&mut self) {
        for level in 0..self.root() {
            let [columns, rows] = self.bounds.nodes(level);
            for z in 0..rows {
                for x in 0..columns {
                    if self.is_split(level, x, z) {
                        self.ensure_neighbours(level, x, z);
                    }
                }
            }
        }
    }

    fn ensure_neighbours(&mut self, level: u32, x: u32, z: u32) {
        for [dx, dz] in [[0, 0], [-1, 0], [1, 0], [0, -1], [0, 1]] {
            if let Some([x, z]) = self.beside(level, x, z, dx, dz) {
                self.set_split(level + 1, x / 2, z / 2);
            }
        }
    }

    fn beside(&self, level: u32, x: u32, z: u32, dx: i32, dz: i32) -> Option<[u32; 2]> {
        let [columns, rows] = self.bounds.nodes(level);
        let (x, z) = (x.checked_add_signed(dx)?, z.checked_add_signed(dz)?);
        (x < columns && z < rows).then_some([x, z])
    }

    fn collect(&self, level: u32, x: u32, z: u32, leaves: &mut Vec<Patch>) {
        if self.is_split(level, x, z) {
            for (x, z) in self.children(level, x, z) {
                self.collect(level - 1, x, z, leaves);
            }
            return;
        }
        let texel = [x, z].map(|node| (node * (CELLS << level)) as i32);
        leaves.push(Patch { texel, level, sides: [self.side(level, x, z, 0), self.side(level, x, z, 1)] });
    }

    /// The outer side on an axis is the one that does not touch a sibling.
    fn side(&self, level: u32, x: u32, z: u32, axis: usize) -> Side {
        let (outward, side) = match [x, z][axis] & 1 {
            0 => (-1, Side::LowCoarser),
            _ => (1, Side::HighCoarser),
        };
        let [dx, dz] = if axis == 0 { [outward, 0] } else { [0, outward] };
        match self.beside(level, x, z, dx, dz) {
            Some([x, z]) if !self.is_split(level + 1, x / 2, z / 2) => side,
            _ => Side::Same,
        }
    }
}

/// Low and high corner of a node in metres.
pub(super) fn node_box(field: &HeightField, bounds: &Bounds, level: u32, x: u32, z: u32) -> [DVec3; 2] {
    let node = bounds.node(level, x, z);
    let metres = |texel: u32, axis: usize| (f64::from(texel.min(field.size()[axis] - 1)) + 0.5) * field.spacing()[axis];
    let side = CELLS << level;
    [
        DVec3::new(metres(x * side, 0), f64::from(node.low), metres(z * side, 1)),
        DVec3::new(metres((x + 1) * side, 0), f64::from(node.high), metres((z + 1) * side, 1)),
    ]
}

fn distance_to_box(point: DVec3, [low, high]: [DVec3; 2]) -> f64 {
    point.distance(point.clamp(low, high))
}
