//! Squares of nodes around a cell, from the nearest to those that reach everything.

/// Texels up to which squares grow one by one, and nodes of any size.
pub const NEAR: usize = 32;

/// What is new in squares that have grown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// How many nodes they reach beyond the first, 1..=[`NEAR`].
    pub reach: usize,
    /// One over the least distance of what is new in them, in texels.
    pub share: f32,
    /// One over twice the distance of the middle of the diagonal of the cell that is new at their corner; 0 for rings of nodes,
    /// whose `share` counts half a texel for it.
    pub middle: f32,
}

/// The rings of each level of nodes by which everything on a map is reached. Those of level 0 are texel by texel.
#[must_use]
pub fn rings(wrap: bool, size: [u32; 2]) -> Vec<Vec<Ring>> {
    let size = size.map(|side| side as usize);
    let farthest = size[0].max(size[1]) - 1;
    let mut levels = vec![(1..=NEAR.min(farthest)).map(near).collect()];
    let mut covered = NEAR;
    while covered < farthest {
        let node = 1 << levels.len();
        // The last node of a map that wraps may be a part of one: beyond it everything is nearer by what is missing.
        let lack = size.map(|side| if wrap { side.next_multiple_of(node) - side } else { 0 });
        let lack = lack[0].max(lack[1]);
        let reaches = (covered + lack) / node + 1..=NEAR.min((farthest + lack).div_ceil(node));
        covered = reaches.end() * node - lack;
        // Half a texel for the middles of diagonals.
        let share = |reach: usize| 1.0 / (((reach - 1) * node - lack) as f32 - 0.5);
        levels.push(reaches.map(|reach| Ring { reach, share: share(reach), middle: 0.0 }).collect());
    }
    levels
}

fn near(reach: usize) -> Ring {
    Ring { reach, share: 1.0 / reach as f32, middle: 1.0 / (2 * reach - 1) as f32 }
}
