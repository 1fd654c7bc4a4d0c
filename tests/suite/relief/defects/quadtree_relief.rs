//! Of quadtree relief mapping (Schröders and van Gulik 2006), algorithm 1.

use terrane_shaderlib::relief::Method;

use super::super::device;
use super::super::scene::{Scene, wall};

/// As the text has it: down to texels.
const METHOD: Method = Method::QuadtreeRelief(0);

#[test]
fn a_ray_along_an_axis_never_ends() {
    let Some(gpu) = device() else { return };
    // The border across the ray is behind it, by a number over 0: the nearer one, for ever.
    let scene = wall(4, [0.25, 1.0], [1.0, 0.0]);
    scene.expect_endless(&gpu, METHOD);
    scene.expect_right(&gpu, Method::QuadtreeReliefExact);
}

#[test]
fn half_a_texel_beyond_a_border_lies_a_corner_that_was_not_looked_at() {
    let Some(gpu) = device() else { return };
    // The ray crosses a fifth of the texel of the needle, from one side to the next, 180 steps high where the needle has 600.
    let height = |x, y| if [x, y] == [4, 4] { 600 } else { 0 };
    let scene = Scene::new([8, 8], height, [0.25, 6.95, 601.0], [1.0, -1.0, -130.0]);
    scene.expect_late(&gpu, METHOD, 1.0);
    scene.expect_right(&gpu, Method::QuadtreeReliefExact);
}

#[test]
fn the_condition_of_the_loop_stops_above_the_texels() {
    let Some(gpu) = device() else { return };
    // Under the ray is level ground; the needle is the other corner of a block of two by two texels.
    let height = |x, y| if [x, y] == [5, 5] { 600 } else { 0 };
    let scene = Scene::new([8, 8], height, [0.25, 3.8, 601.0], [1.0, 0.01, -64.0]);
    let found = scene.hit(&gpu, Method::QuadtreeRelief(1));
    assert!(scene.height(found) > 300.0, "in the air, {} steps high", scene.height(found));
    scene.expect_right(&gpu, METHOD);
    scene.expect_right(&gpu, Method::QuadtreeReliefExact);
}

#[test]
fn boxes_over_texels_miss_the_slope_between_them() {
    let Some(gpu) = device() else { return };
    // Along the foot of a wall, within half a texel of the lower column: there the surface is 260 steps high, the box 0.
    let scene = wall(4, [3.44, 0.25], [0.001, 1.0]);
    scene.expect_late(&gpu, METHOD, 4.0);
    scene.expect_right(&gpu, Method::QuadtreeReliefExact);
}
