//! What is known of every node of the quadtree before a camera exists: heights and geometric error.

use rayon::prelude::*;

use crate::render::height_field::HeightField;

/// Cells on a side of a leaf's grid.
pub const CELLS: u32 = 32;

/// A node's heights and error in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Lowest texel.
    pub low: f32,
    /// Highest texel.
    pub high: f32,
    /// Largest vertical distance between the node's own grid and the texels under it; never below its children's.
    pub error: f32,
}

/// One level: nodes of `CELLS << level` texel steps on a side.
#[derive(Clone, Debug)]
struct Level {
    nodes: [u32; 2],
    values: Vec<Node>,
}

/// The quadtree over a height field, finest level first; the last level is one node.
#[derive(Clone, Debug)]
pub struct Bounds {
    cells: [u32; 2],
    levels: Vec<Level>,
}

impl Bounds {
    /// Measures every node on every level; O(texels × levels), on all cores.
    #[must_use]
    pub fn new(field: &HeightField) -> Self {
        let mut levels: Vec<Level> = Vec::new();
        loop {
            let finer = levels.last();
            if finer.is_some_and(|level| level.nodes == [1, 1]) {
                return Self { cells: field.size().map(|side| side - 1), levels };
            }
            let level = Level::new(field, levels.len() as u32, finer);
            levels.push(level);
        }
    }

    /// Cells of the height map on x and z.
    #[must_use]
    pub fn cells(&self) -> [u32; 2] {
        self.cells
    }

    /// Number of levels; the root is on the last.
    #[must_use]
    pub fn levels(&self) -> u32 {
        self.levels.len() as u32
    }

    /// Nodes of a level on x and z.
    #[must_use]
    pub fn nodes(&self, level: u32) -> [u32; 2] {
        self.levels[level as usize].nodes
    }

    /// A node of a level.
    #[must_use]
    pub fn node(&self, level: u32, x: u32, z: u32) -> Node {
        let level = &self.levels[level as usize];
        level.values[(z * level.nodes[0] + x) as usize]
    }
}

impl Level {
    fn new(field: &HeightField, level: u32, finer: Option<&Level>) -> Self {
        let nodes = field.size().map(|side| (side - 1).div_ceil(CELLS << level));
        let values = (0..nodes[0] * nodes[1])
            .into_par_iter()
            .map(|index| {
                let (x, z) = (index % nodes[0], index / nodes[0]);
                match finer {
                    None => measure_leaf(field, x, z),
                    Some(finer) => finer.join(x, z, measure_error(field, level, x, z)),
                }
            })
            .collect();
        Self { nodes, values }
    }

    /// The parent of up to four nodes of this level.
    fn join(&self, x: u32, z: u32, error: f32) -> Node {
        let mut joined = Node { low: f32::INFINITY, high: f32::NEG_INFINITY, error };
        for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let (x, z) = (2 * x + i, 2 * z + j);
            if x < self.nodes[0] && z < self.nodes[1] {
                let child = self.values[(z * self.nodes[0] + x) as usize];
                joined.low = joined.low.min(child.low);
                joined.high = joined.high.max(child.high);
                joined.error = joined.error.max(child.error);
            }
        }
        joined
    }
}

fn measure_leaf(field: &HeightField, x: u32, z: u32) -> Node {
    let (column, row) = (i64::from(x * CELLS), i64::from(z * CELLS));
    let mut node = Node { low: f32::INFINITY, high: f32::NEG_INFINITY, error: 0.0 };
    for j in 0..=i64::from(CELLS) {
        for i in 0..=i64::from(CELLS) {
            let height = field.at(column + i, row + j);
            node.low = node.low.min(height);
            node.high = node.high.max(height);
        }
    }
    node
}

/// How far the texels of a node stand off its grid of `1 << level` texel steps.
fn measure_error(field: &HeightField, level: u32, x: u32, z: u32) -> f32 {
    let step = 1_i64 << level;
    let origin = [x, z].map(|node| i64::from(node) * i64::from(CELLS) * step);
    let mut error = 0.0_f32;
    for cell_z in 0..i64::from(CELLS) {
        for cell_x in 0..i64::from(CELLS) {
            let corner = [origin[0] + cell_x * step, origin[1] + cell_z * step];
            if corner[0] < i64::from(field.size()[0]) && corner[1] < i64::from(field.size()[1]) {
                error = error.max(cell_error(field, corner, step, (cell_x ^ cell_z) & 1 == 0));
            }
        }
    }
    error
}

/// Largest distance of a texel from the cell's two triangles; `main` says that their diagonal runs from north-west.
fn cell_error(field: &HeightField, corner: [i64; 2], step: i64, main: bool) -> f32 {
    let at = |i, j| field.at(corner[0] + i, corner[1] + j);
    let [nw, ne, sw, se] = [at(0, 0), at(step, 0), at(0, step), at(step, step)];
    let scale = 1.0 / step as f32;
    let mut error = 0.0_f32;
    for j in 0..=step {
        for i in 0..=step {
            let (s, t) = (i as f32 * scale, j as f32 * scale);
            let flat = match main {
                true if s >= t => nw + (ne - nw) * s + (se - ne) * t,
                true => nw + (se - sw) * s + (sw - nw) * t,
                false if s + t <= 1.0 => nw + (ne - nw) * s + (sw - nw) * t,
                false => se + (sw - se) * (1.0 - s) + (ne - se) * (1.0 - t),
            };
            error = error.max((at(i, j) - flat).abs());
        }
    }
    error
}
