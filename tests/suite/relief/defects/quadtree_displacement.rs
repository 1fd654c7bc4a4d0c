//! Of quadtree displacement mapping (Drobot 2010), listing 1.3. Texel i is the square from i - 0.5 to i + 0.5.

use terrane::relief::{Outcome, Tracer};
use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::heightfield::adversary::{Depth, Land, Rays, map};
use terrane_shaderlib::relief::{Displacement, Method, Placed, Undefined};

use super::super::scene::{ENOUGH, Scene, wall};
use super::super::{Segment, device};

const METHOD: Method = Method::QuadtreeDisplacement(Displacement::PUBLISHED);
const REPAIRED: Method = Method::QuadtreeDisplacementRepaired;

/// With 0 / 0 as 0, not as a number that a minimum passes over.
const ZERO: Method =
    Method::QuadtreeDisplacement(Displacement { undefined: Undefined::Zero, ..Displacement::PUBLISHED });

#[test]
fn the_first_step_divides_zero_by_zero_and_jumps_over_a_wall_or_stays_for_ever() {
    let Some(gpu) = device() else { return };
    // The highest texel stands elsewhere, so that the first move is one from under the highest plane.
    let height = |x, y| if [x, y] == [7, 7] { 1000 } else { u16::from(x == 4) * 600 };
    let scene = Scene::new([8, 8], height, [0.2, 1.0, 500.0], [1.0, 0.0, -50.0]);
    scene.expect_late(&gpu, METHOD, 6.0);
    scene.expect_endless(&gpu, ZERO);
    scene.expect_right(&gpu, REPAIRED);
}

#[test]
fn a_ray_along_an_axis_divides_zero_by_zero_on_a_border() {
    let Some(gpu) = device() else { return };
    // Between the fourth row of texels and the fifth. What comes of it is open in WGSL.
    let scene = wall(4, [0.25, 3.5], [1.0, 0.0]);
    assert!((scene.hit(&gpu, METHOD) - scene.truth()).abs() < 0.5, "as Direct3D has it, on the wall");
    scene.expect_endless(&gpu, ZERO);
    scene.expect_right(&gpu, REPAIRED);
}

#[test]
fn toward_smaller_coordinates_the_border_is_a_cell_too_far() {
    let Some(gpu) = device() else { return };
    let (forth, back) = (wall(4, [0.25, 1.0], [1.0, 0.0]), wall(3, [6.75, 1.0], [-1.0, 0.0]));
    assert!((forth.truth() - back.truth()).abs() < 1e-9, "the same but for the direction");
    assert!((forth.hit(&gpu, METHOD) - forth.truth()).abs() < 0.5);
    back.expect_late(&gpu, METHOD, 6.0);
    back.expect_right(&gpu, REPAIRED);
}

#[test]
fn left_of_the_tile_a_coordinate_is_cut_toward_zero_and_a_border_is_not_seen() {
    let Some(gpu) = device() else { return };
    // From node 0 to node -1, both of which become 0.
    let height = |x, _| u16::from(x == 6) * 600;
    let scene = Scene::new([8, 8], height, [1.75, 1.0, 601.0], [-1.0, 0.0, -128.0]);
    scene.expect_late(&gpu, METHOD, 1.5);
    scene.expect_right(&gpu, REPAIRED);
}

#[test]
fn without_an_end_to_its_nodes_some_rays_never_end() {
    let Some(gpu) = device() else { return };
    let heights = map(Land::Hills, [64, 64], Border::Wrap, Depth::Sixteen, 1).expect("a map");
    let mut rays = Rays::new(&heights, 1);
    let cases = (0..512).map(|_| rays.above(0.364));
    let sent: Vec<Segment> = cases.map(|case| Segment { ray: case.ray, range: (0.0, case.end as f64) }).collect();
    // A node that is seen again is seen for ever: no ray has as many nodes as this.
    let unresolved = |method: Method| {
        let placed = Placed::new(&heights, method.bounds(), ENOUGH).expect("sides are powers of two");
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let (traced, _) = tracer.trace(&sent).expect("the device answers");
        traced.iter().filter(|one| one.outcome == Outcome::Unresolved).count()
    };
    assert!(unresolved(METHOD) > 0, "a border that is reached, but for rounding, is 0 away");
    assert_eq!(unresolved(REPAIRED), 0);
}

#[test]
fn a_ray_that_is_given_up_counts_as_a_hit_in_the_air() {
    let Some(gpu) = device() else { return };
    let height = |x, y| u16::from([x, y] == [0, 5]) * 600;
    let scene = Scene::new([8, 8], height, [0.25, 1.0, 601.0], [1.0, 0.0, -64.0]);
    let capped = Displacement { caps: Some([4, 4]), steep: 64, ..Displacement::PUBLISHED };
    let found = scene.hit(&gpu, Method::QuadtreeDisplacement(capped));
    assert!(scene.height(found) > 100.0, "{} steps above the ground", scene.height(found));
    scene.expect_right(&gpu, METHOD);
    scene.expect_right(&gpu, REPAIRED);
}

#[test]
fn maxima_of_texels_miss_the_slope_between_them() {
    let Some(gpu) = device() else { return };
    // Along the foot of a wall, within half a texel of the lower column: there the surface is 260 steps high.
    let scene = wall(4, [3.44, 0.25], [0.001, 1.0]);
    scene.expect_late(&gpu, METHOD, 4.0);
    scene.expect_right(&gpu, REPAIRED);
}

#[test]
fn whole_numbers_divided_by_whole_numbers_leave_no_borders_within_the_tile() {
    let Some(gpu) = device() else { return };
    let scene = wall(4, [0.25, 1.0], [1.0, 0.0]);
    scene.expect_endless(&gpu, Method::QuadtreeDisplacement(Displacement::LISTING));
    assert!((scene.hit(&gpu, METHOD) - scene.truth()).abs() < 0.5, "in fractions of the tile it is right");
    scene.expect_right(&gpu, REPAIRED);
}
