//! Which leaves a camera asks for.

use glam::DVec3;

use super::bounds::{Bounds, CELLS};
use super::tile::Tile;
use crate::render::height_field::HeightField;

/// What lies beyond the two outer sides of a leaf on one axis, in the height map's own directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Leaves of the same level or finer, or the end of the land.
    Same,
    /// A coarser leaf on the side of smaller texels.
    LowCoarser,
    /// A coarser leaf on the side of larger texels.
    HighCoarser,
}

/// A leaf of the quadtree: a grid of 33 × 33 vertices with `1 << level` texels between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patch {
    /// The copy of the terrain that it belongs to.
    pub tile: Tile,
    /// Texel of the first corner in the height map.
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

    /// Whether its triangles turn the other way: mirrored on one axis.
    #[must_use]
    pub fn flipped(&self) -> bool {
        self.tile.mirror().iter().product::<i32>() < 0
    }
}

/// Leaves that cover the terrain and `rings` of its copies around it, so that no texel is displaced by more than
/// `tolerance` radians as seen from `eye` (metres), with neighbours that differ by one level at most.
#[must_use]
pub fn select(field: &HeightField, bounds: &Bounds, eye: DVec3, tolerance: f64, rings: u32) -> Vec<Patch> {
    let mut forest = Forest::new(bounds, rings);
    let roots: Vec<Node> = Tile::around(rings).map(|tile| Node { tile, level: forest.top(), x: 0, z: 0 }).collect();
    roots.iter().for_each(|&root| forest.split_where_needed(field, eye, tolerance, root));
    forest.balance();
    let mut leaves = Vec::new();
    roots.iter().for_each(|&root| forest.collect(root, &mut leaves));
    leaves
}

/// A node of one copy's tree.
#[derive(Clone, Copy)]
struct Node {
    tile: Tile,
    level: u32,
    x: u32,
    z: u32,
}

impl Node {
    fn parent(self) -> Self {
        Self { level: self.level + 1, x: self.x / 2, z: self.z / 2, ..self }
    }
}

/// A tree per copy: for each node of each level whether it is split.
struct Forest<'a> {
    bounds: &'a Bounds,
    rings: i32,
    split: Vec<Vec<Vec<bool>>>,
}

impl<'a> Forest<'a> {
    fn new(bounds: &'a Bounds, rings: u32) -> Self {
        let nodes = |level| bounds.nodes(level).iter().product::<u32>() as usize;
        let tree: Vec<Vec<bool>> = (0..bounds.levels()).map(|level| vec![false; nodes(level)]).collect();
        Self { bounds, rings: rings as i32, split: Tile::around(rings).map(|_| tree.clone()).collect() }
    }

    fn top(&self) -> u32 {
        self.bounds.levels() - 1
    }

    fn place(&self, node: Node) -> [usize; 3] {
        let [x, z] = node.tile.0.map(|place| place + self.rings);
        let tree = z * (2 * self.rings + 1) + x;
        [tree as usize, node.level as usize, (node.z * self.bounds.nodes(node.level)[0] + node.x) as usize]
    }

    fn is_split(&self, node: Node) -> bool {
        let [tree, level, index] = self.place(node);
        self.split[tree][level][index]
    }

    fn set_split(&mut self, node: Node) {
        let [tree, level, index] = self.place(node);
        self.split[tree][level][index] = true;
    }

    /// The children of a node that lie on the terrain.
    fn children(&self, node: Node) -> impl Iterator<Item = Node> + use<> {
        let level = node.level - 1;
        let [columns, rows] = self.bounds.nodes(level);
        let all = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| (2 * node.x + i, 2 * node.z + j));
        let inside = all.into_iter().filter(move |&(x, z)| x < columns && z < rows);
        inside.map(move |(x, z)| Node { tile: node.tile, level, x, z })
    }

    fn split_where_needed(&mut self, field: &HeightField, eye: DVec3, tolerance: f64, node: Node) {
        let error = f64::from(self.bounds.node(node.level, node.x, node.z).error);
        let near = distance_to_box(eye, node_box(field, self.bounds, node.tile, node.level, [node.x, node.z]));
        if node.level == 0 || error <= tolerance * near {
            return;
        }
        self.set_split(node);
        for child in self.children(node) {
            self.split_where_needed(field, eye, tolerance, child);
        }
    }

    /// A split node's neighbours must exist on its own level, so that its children meet leaves one level coarser at most.
    /// From fine to coarse, once: what a level adds is only above it, or on it in an image of the same node.
    fn balance(&mut self) {
        for level in 0..=self.top() {
            let split = |forest: &Self| forest.nodes(level).filter(|&node| forest.is_split(node)).collect::<Vec<_>>();
            // Twice, for an image of an image.
            for _ in 0..2 {
                split(self).into_iter().for_each(|node| self.ensure_images(node));
            }
            if level < self.top() {
                split(self).into_iter().for_each(|node| self.ensure_neighbours(node));
            }
        }
    }

    fn nodes(&self, level: u32) -> impl Iterator<Item = Node> + use<> {
        let [columns, rows] = self.bounds.nodes(level);
        Tile::around(self.rings as u32).flat_map(move |tile| {
            (0..columns * rows).map(move |index| Node { tile, level, x: index % columns, z: index / columns })
        })
    }

    /// Where a node's children do not end at the border, or have no sibling there, they meet their images with a side that
    /// cannot leave out vertices: the node and its image must be split alike.
    fn ensure_images(&mut self, node: Node) {
        for axis in [0, 1] {
            let child = (CELLS << node.level) / 2;
            let even = self.bounds.cells()[axis].is_multiple_of(2 * child);
            let last = [node.x, node.z][axis] == self.bounds.nodes(node.level)[axis] - 1;
            if let Some(image) = self.beside(node, axis, 1).filter(|_| last && !even) {
                self.set_split(image);
            }
        }
    }

    fn ensure_neighbours(&mut self, node: Node) {
        self.set_split(node.parent());
        for (axis, step) in [(0, -1), (0, 1), (1, -1), (1, 1)] {
            if let Some(beside) = self.beside(node, axis, step) {
                self.set_split(beside.parent());
            }
        }
    }

    /// The next node in the height map's own direction; beyond the border it is the node's mirror image.
    fn beside(&self, node: Node, axis: usize, step: i32) -> Option<Node> {
        let mut place = [node.x, node.z];
        if let Some(next) = place[axis].checked_add_signed(step).filter(|&at| at < self.bounds.nodes(node.level)[axis])
        {
            place[axis] = next;
            return Some(Node { x: place[0], z: place[1], ..node });
        }
        let mut tile = node.tile;
        tile.0[axis] += step * node.tile.mirror()[axis];
        (tile.0[axis].abs() <= self.rings).then_some(Node { tile, ..node })
    }

    fn collect(&self, node: Node, leaves: &mut Vec<Patch>) {
        if self.is_split(node) {
            self.children(node).for_each(|child| self.collect(child, leaves));
            return;
        }
        let texel = [node.x, node.z].map(|place| (place * (CELLS << node.level)) as i32);
        leaves.push(Patch {
            tile: node.tile,
            texel,
            level: node.level,
            sides: [self.side(node, 0), self.side(node, 1)],
        });
    }

    /// The outer side on an axis is the one that does not touch a sibling.
    fn side(&self, node: Node, axis: usize) -> Side {
        let (outward, side) = match [node.x, node.z][axis] & 1 {
            0 => (-1, Side::LowCoarser),
            _ => (1, Side::HighCoarser),
        };
        match self.beside(node, axis, outward) {
            Some(beside) if node.level < self.top() && !self.is_split(beside.parent()) => side,
            _ => Side::Same,
        }
    }
}

/// Low and high corner of a node in metres.
pub(super) fn node_box(field: &HeightField, bounds: &Bounds, tile: Tile, level: u32, [x, z]: [u32; 2]) -> [DVec3; 2] {
    let node = bounds.node(level, x, z);
    let side = CELLS << level;
    let texel =
        |x: u32, z: u32| [(x * side).min(field.size()[0] - 1) as i32, (z * side).min(field.size()[1] - 1) as i32];
    tile.bounding_box(field, [texel(x, z), texel(x + 1, z + 1)], [node.low, node.high])
}

fn distance_to_box(point: DVec3, [low, high]: [DVec3; 2]) -> f64 {
    point.distance(point.clamp(low, high))
}
