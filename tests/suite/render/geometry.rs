//! The quadtree leaves no crack and keeps its error.

use std::collections::BTreeMap;

use glam::DVec3;
use terrane::render::geometry::{Bounds, CELLS, Grid, Patch, select};
use terrane::render::{Camera, HeightField};

use super::world::mountains;

/// Eyes over, beside and far above the terrain, the same in every run.
fn eyes(field: &HeightField, count: usize) -> impl Iterator<Item = DVec3> {
    let [width, depth] = field.extent();
    let mut state = 1_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1_u32 << 31)
    };
    (0..count).map(move |_| {
        let (x, z, up) = (random() * 1.4 - 0.2, random() * 1.4 - 0.2, random());
        DVec3::new(x * width, 1200.0 * up * up, z * depth)
    })
}

type Vertex = (i32, i32);

fn triangles(field: &HeightField, grid: &Grid, patch: &Patch) -> Vec<[Vertex; 3]> {
    let last = field.size().map(|side| side as i32 - 1);
    let vertex = |index: u16| {
        let corner = grid.vertices[usize::from(index)].map(|place| i32::from(place) << patch.level);
        let texel = [(patch.texel[0] + corner[0]).min(last[0]), (patch.texel[1] + corner[1]).min(last[1])];
        let [x, z] = patch.tile.unfold(field, texel);
        (x, z)
    };
    let list = &grid.indices[patch.permutation()];
    let turned = |t: &[u16]| if patch.flipped() { [t[0], t[2], t[1]] } else { [t[0], t[1], t[2]] };
    list.chunks_exact(3).map(|t| turned(t).map(vertex)).collect()
}

/// Twice the area; positive counter-clockwise seen from above, where z grows down the page.
fn area([a, b, c]: [Vertex; 3]) -> i64 {
    let cross = |p: Vertex, q: Vertex| i64::from(p.0) * i64::from(q.1) - i64::from(p.1) * i64::from(q.0);
    -(cross(a, b) + cross(b, c) + cross(c, a))
}

/// Every edge inside the terrain is run through twice, once each way, between the same two vertices: neighbours match
/// vertex for vertex, there is no T-junction, hole or overlap.
fn assert_watertight(field: &HeightField, patches: &[Patch], rings: i32) {
    let grid = Grid::new();
    let last = field.size().map(|side| side as i32 - 1);
    let mut edges: BTreeMap<(Vertex, Vertex), i32> = BTreeMap::new();
    let mut covered = 0;
    for triangle in patches.iter().flat_map(|patch| triangles(field, &grid, patch)) {
        let area = area(triangle);
        assert!(area >= 0, "{triangle:?} faces down");
        // What lies beyond the terrain's end shrinks to lines.
        if area == 0 {
            continue;
        }
        covered += area;
        for (from, to) in [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (triangle[i], triangle[j])) {
            *edges.entry((from.min(to), from.max(to))).or_default() += if from < to { 1 } else { -1 };
        }
    }
    let end = |place: i32, last: i32| place == -rings * last || place == (rings + 1) * last;
    let border = |a: Vertex, b: Vertex| (a.0 == b.0 && end(a.0, last[0])) || (a.1 == b.1 && end(a.1, last[1]));
    for ((from, to), balance) in edges {
        assert_eq!(balance.abs(), i32::from(border(from, to)), "the edge {from:?} {to:?} has one side");
    }
    let tiles = i64::from((2 * rings + 1) * (2 * rings + 1));
    assert_eq!(covered, 2 * tiles * i64::from(last[0]) * i64::from(last[1]));
}

#[test]
fn leaves_meet_vertex_for_vertex_wherever_the_camera_is() {
    let field = mountains(257, 8.0);
    let bounds = Bounds::new(&field);
    let mut permutations = [false; 9];
    for eye in eyes(&field, 48) {
        let patches = select(&field, &bounds, eye, 0.002, 0);
        assert_watertight(&field, &patches, 0);
        patches.iter().for_each(|patch| permutations[patch.permutation()] = true);
    }
    assert_eq!(permutations, [true; 9], "the cameras do not reach every permutation");
}

#[test]
fn leaves_meet_on_terrain_that_is_no_power_of_two() {
    for size in [[2, 2], [33, 33], [34, 40], [100, 300], [500, 77]] {
        let heights = (0..size[0] * size[1]).map(|i| ((i * 7919) % 101) as f32).collect();
        let field = HeightField::new(size, [3.0, 5.0], heights).expect("finite heights");
        let bounds = Bounds::new(&field);
        for eye in eyes(&field, 6) {
            assert_watertight(&field, &select(&field, &bounds, eye, 0.05, 0), 0);
            assert_watertight(&field, &select(&field, &bounds, eye, 0.05, 2), 2);
        }
    }
}

#[test]
fn no_texel_is_farther_from_its_leaf_than_the_tolerance_seen_from_the_eye() {
    let field = mountains(257, 6.0);
    let bounds = Bounds::new(&field);
    let (eye, tolerance) = (DVec3::new(300.0, 900.0, 500.0), 0.004);
    let patches = select(&field, &bounds, eye, tolerance, 0);
    assert!(patches.iter().any(|patch| patch.level > 0), "nothing is simplified");
    for patch in &patches {
        let [x, z] = patch.node();
        let error = f64::from(bounds.node(patch.level, x, z).error);
        for row in 0..=(CELLS << patch.level) {
            for column in 0..=(CELLS << patch.level) {
                let texel = [patch.texel[0] + column as i32, patch.texel[1] + row as i32];
                let [i, j] = texel.map(i64::from);
                if i >= 257 || j >= 257 {
                    continue;
                }
                let height = f64::from(field.at(i, j));
                let off = (height - coarse_height(&field, patch, column, row)).abs();
                assert!(off <= error + 1e-3, "{off} m at {texel:?}, the node says {error}");
                let place = DVec3::new((i as f64 + 0.5) * 6.0, height, (j as f64 + 0.5) * 6.0);
                assert!(off <= tolerance * (eye.distance(place) + off) + 1e-3, "{off} m at {texel:?}");
            }
        }
    }
}

/// The height of a leaf's own triangles over a texel, found by the triangle that contains it.
fn coarse_height(field: &HeightField, patch: &Patch, column: u32, row: u32) -> f64 {
    let step = 1_u32 << patch.level;
    let cell = |at: u32| (at / step).min(CELLS - 1);
    let (x, z) = (cell(column), cell(row));
    let (s, t) = (f64::from(column) / f64::from(step) - f64::from(x), f64::from(row) / f64::from(step) - f64::from(z));
    let at = |i: u32, j: u32| {
        let texel = |base: i32, place: u32| i64::from(base) + i64::from(place * step);
        f64::from(field.at(texel(patch.texel[0], x + i), texel(patch.texel[1], z + j)))
    };
    // The diagonal meets the middle of the fan, whose column and row are odd.
    if (x + z) % 2 == 0 {
        let corner = if s >= t { (s - t) * at(1, 0) } else { (t - s) * at(0, 1) };
        corner + (1.0 - s.max(t)) * at(0, 0) + s.min(t) * at(1, 1)
    } else if s + t <= 1.0 {
        (1.0 - s - t) * at(0, 0) + s * at(1, 0) + t * at(0, 1)
    } else {
        (s + t - 1.0) * at(1, 1) + (1.0 - t) * at(1, 0) + (1.0 - s) * at(0, 1)
    }
}

#[test]
fn what_the_camera_sees_is_kept() {
    let field = mountains(257, 8.0);
    let bounds = Bounds::new(&field);
    let camera = Camera { eye: [200.0, 900.0, 300.0], target: [1200.0, 300.0, 1500.0], fov: 50.0 };
    let view = camera.view(1280, 720).expect("a good camera");
    let leaves = select(&field, &bounds, view.eye, 0.002, 0);
    let kept = terrane::render::geometry::visible(&field, &bounds, &view, &leaves);
    assert!(kept.len() < leaves.len(), "nothing is culled");
    let clip = view.clip_from_eye().as_dmat4();
    for patch in &leaves {
        let seen = (0..=CELLS as i64 * CELLS as i64).any(|i| {
            let [column, row] = [i % 33, i / 33].map(|place| place << patch.level);
            let (column, row) = (i64::from(patch.texel[0]) + column, i64::from(patch.texel[1]) + row);
            let place =
                DVec3::new((column as f64 + 0.5) * 8.0, f64::from(field.at(column, row)), (row as f64 + 0.5) * 8.0);
            let at = clip * (place - view.eye).extend(1.0);
            column < 257 && row < 257 && at.w > 0.0 && at.x.abs() <= at.w && at.y.abs() <= at.w && at.z <= at.w
        });
        assert!(!seen || kept.contains(patch), "{patch:?} is seen");
    }
}
