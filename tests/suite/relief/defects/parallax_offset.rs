//! Of parallax mapping with offset limiting (Welsh 2004).

use terrane_shaderlib::relief::Method;

use super::super::device;
use super::super::scene::{Scene, wall};

/// As steep as the scenes' rays: 64 steps down on a texel on are 45°.
const METHOD: Method = Method::ParallaxOffset(64);

#[test]
fn the_limit_places_even_level_ground_by_the_sine_of_the_elevation_too_near() {
    let Some(gpu) = device() else { return };
    let height = |x, y| u16::from([x, y] == [0, 5]) * 600;
    let scene = Scene::new([8, 8], height, [0.25, 1.0, 601.0], [1.0, 0.0, -64.0]);
    let share = scene.hit(&gpu, METHOD) / scene.truth();
    assert!((share - 0.5_f64.sqrt()).abs() < 1e-3, "{share}");
    scene.expect_right(&gpu, Method::QuadtreeDisplacementRepaired);
}

#[test]
fn one_reading_sees_no_wall_between_the_entry_and_the_ground() {
    let Some(gpu) = device() else { return };
    let scene = wall(4, [0.25, 1.0], [1.0, 0.0]);
    scene.expect_late(&gpu, METHOD, 3.0);
    scene.expect_right(&gpu, Method::QuadtreeDisplacementRepaired);
}
