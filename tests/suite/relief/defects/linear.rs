//! Of linear search: relief mapping (Policarpo, Oliveira and Comba 2005) and parallax occlusion mapping (Tatarchuk 2006) as
//! Drobot has it in listing 1.1.

use terrane_shaderlib::relief::Method;

use super::super::device;
use super::super::scene::Scene;

#[test]
fn a_wall_thinner_than_a_step_is_missed_whatever_follows_the_search() {
    let Some(gpu) = device() else { return };
    // 8 steps of 7 texels, at 28.25 and 35.25 on either side of a wall that is two texels thick at its foot.
    let height = |x, _| if x == 33 { 600 } else { 0 };
    let scene = Scene::new([64, 8], height, [0.25, 1.0, 601.0], [1.0, 0.0, -10.75]);
    assert!((31.0..33.0).contains(&scene.truth()), "{}", scene.truth());
    for halvings in [0, 6] {
        scene.expect_late(&gpu, Method::Linear(8, halvings), 20.0);
        scene.expect_right(&gpu, Method::Linear(1024, 20));
    }
    scene.expect_right(&gpu, Method::QuadtreeDisplacementRepaired);
}

/// Listing 1.1 over a profile: heights under the ray, by the ray's own height, 1 where it enters and 0 where it ends.
fn listing_1_1(profile: impl Fn(f32) -> f32, steps: u16) -> f32 {
    let size = 1.0 / f32::from(steps);
    let (mut depth, mut before) = (1.0_f32, 1.0_f32);
    let (mut first, mut second) = ([0.0_f32; 2], [0.0_f32; 2]);
    for _ in 0..steps {
        depth -= size;
        let current = profile(depth);
        if current > depth {
            (first, second) = ([depth, current], [depth + size, before]);
            break;
        }
        before = current;
    }
    let (beyond, within) = (second[0] - second[1], first[0] - first[1]);
    (first[0] * beyond - second[0] * within) / (beyond - within)
}

#[test]
fn listing_1_1_places_a_hit_in_the_first_step_at_the_entry() {
    let Some(gpu) = device() else { return };
    assert_eq!(listing_1_1(|_| 0.98, 8), 1.0, "the height before the first step is not read but taken for 1");
    assert!((listing_1_1(|_| 0.8, 8) - 0.8).abs() < 1e-6, "in later steps level ground is found");
    // Level ground but for a needle out of the way, in the first of 8 steps: `linear` reads where it enters.
    let height = |x, y| if [x, y] == [0, 5] { 600 } else { 588 };
    let scene = Scene::new([8, 8], height, [2.0, 1.0, 601.0], [1.0, 0.0, -64.0]);
    scene.expect_right(&gpu, Method::Linear(8, 0));
}

#[test]
fn listing_1_1_divides_zero_by_zero_where_there_is_no_hit() {
    assert!(listing_1_1(|_| -0.5, 8).is_nan());
}
