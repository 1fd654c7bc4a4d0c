//! The grid that every leaf shares: 33 × 33 vertices and 9 lists of triangles.

use super::bounds::CELLS;
use super::select::Side;

/// Vertices on a side.
pub const VERTICES: u32 = CELLS + 1;

/// The vertices and the triangles for every combination of coarser neighbours.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Column and row of each vertex, 0..=32.
    pub vertices: Vec<[u16; 2]>,
    /// For each of the 9 permutations, in the order of [`super::Patch::permutation`]: three indices per triangle,
    /// counter-clockwise seen from above.
    pub indices: [Vec<u16>; 9],
}

impl Grid {
    /// Builds the lists; they do not depend on the terrain.
    #[must_use]
    pub fn new() -> Self {
        let vertices = (0..VERTICES * VERTICES).map(|i| [(i % VERTICES) as u16, (i / VERTICES) as u16]).collect();
        let sides = [Side::Same, Side::LowCoarser, Side::HighCoarser];
        let indices = std::array::from_fn(|permutation| triangles(sides[permutation / 3], sides[permutation % 3]));
        Self { vertices, indices }
    }
}

impl Default for Grid {
    fn default() -> Self {
        Self::new()
    }
}

/// Fans around the middles of 2 × 2 cells. A fan on a side with a coarser neighbour leaves out the vertex in the middle of
/// that side, which the neighbour does not have.
fn triangles(x: Side, z: Side) -> Vec<u16> {
    let last = CELLS / 2 - 1;
    let mut indices = Vec::with_capacity((CELLS * CELLS * 6) as usize);
    for block_z in 0..=last {
        for block_x in 0..=last {
            let west = x == Side::LowCoarser && block_x == 0;
            let east = x == Side::HighCoarser && block_x == last;
            let north = z == Side::LowCoarser && block_z == 0;
            let south = z == Side::HighCoarser && block_z == last;
            fan(&mut indices, 2 * block_x, 2 * block_z, [north, west, south, east]);
        }
    }
    indices
}

/// `coarse`: whether the middle of the north, west, south, east side is left out.
fn fan(indices: &mut Vec<u16>, column: u32, row: u32, coarse: [bool; 4]) {
    let index = |i: u32, j: u32| ((row + j) * VERTICES + column + i) as u16;
    // From the north-east corner against the clock as seen from above (z is south): north, west, south, east sides.
    let ring = [(2, 0), (1, 0), (0, 0), (0, 1), (0, 2), (1, 2), (2, 2), (2, 1)];
    let kept: Vec<u16> = ring
        .iter()
        .enumerate()
        .filter(|(place, _)| place % 2 == 0 || !coarse[place / 2])
        .map(|(_, &(i, j))| index(i, j))
        .collect();
    for (place, &from) in kept.iter().enumerate() {
        indices.extend([index(1, 1), from, kept[(place + 1) % kept.len()]]);
    }
}
