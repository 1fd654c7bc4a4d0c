//! What the published shadows of relief get wrong, each where it is smallest.

use terrane::measure::Subject;
use terrane::relief::Lighting;
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::visibility::Sun;
use terrane_shaderlib::heightfield::{Border, Heights, Texels};

use crate::relief::device;
use crate::relief::lighting::Place;

/// Flat ground with a wall one texel wide along a column, so many steps high.
fn wall(column: usize, steps: u16) -> Subject {
    let mut texels = vec![0; 64 * 64];
    (0..64).for_each(|row| texels[row * 64 + column] = steps);
    // What the lid is measured by, far from everything that is asked.
    texels[63 * 64 + 63] = u16::MAX;
    let heights = Heights::new([64, 64], Border::Wrap, Texels::U16(texels)).expect("as many texels as its size says");
    Subject { name: "wall".into(), heights, full: 65535.0 }
}

/// What a method says and what is true, at (20, 30), with the sun along +x.
fn beside(gpu: &Gpu, subject: &Subject, elevation: f64, lighting: Lighting) -> (f64, f64) {
    let place = Place::new(subject, Sun::new(0.0, elevation, 0.27));
    let points = [[20.0, 30.0]];
    let seen = place.seen(gpu, lighting, &points)[0].share.expect("resolved");
    (seen, place.sun_shares(&points, 24)[0])
}

#[test]
fn light_leaks_through_a_wall_between_the_samples_of_parallax_shadows() {
    let Some(gpu) = device() else { return };
    // The ray leaves the lid after 3.2 / tan 8° = 22.8 texels: 12 samples are 1.9 apart, at 21.9, 23.8, 25.7 …
    let subject = wall(23, 40000);
    assert_eq!(beside(&gpu, &subject, 8.0, Lighting::Parallax(12)), (1.0, 0.0));
    let (exact, _) = beside(&gpu, &subject, 8.0, Lighting::Cone(1, 0.0));
    assert!(exact < 1e-6, "{exact}");
}

#[test]
fn published_parallax_shadows_end_as_near_under_a_low_sun_as_under_a_high_one() {
    let Some(gpu) = device() else { return };
    // The relief is 3.2 texels deep, and the ray is taken to have left it after as many, though at 8° it has not after 22.
    assert_eq!(beside(&gpu, &wall(24, 60000), 8.0, Lighting::ParallaxPublished), (1.0, 0.0));
    assert!(beside(&gpu, &wall(21, 60000), 8.0, Lighting::ParallaxPublished).0 < 0.1);
}

#[test]
fn light_leaks_past_what_the_fast_horizon_averages_away() {
    let Some(gpu) = device() else { return };
    // 12 texels away a tap reads mip 3, in which the wall is an eighth as high.
    let subject = wall(32, 65535);
    let (seen, truth) = beside(&gpu, &subject, 10.0, Lighting::FastHorizon(6));
    assert!(truth < 1e-6 && seen > 0.999, "{seen}, {truth}");
}

#[test]
fn the_published_horizon_darkens_what_the_sun_passes_over() {
    let Some(gpu) = device() else { return };
    // A step of 1.5 texels, 1.6 away: its edge stands at 42°, and a sun at 60° clears it.
    let mut texels = vec![20000; 64 * 64];
    (0..64 * 64).filter(|index| index % 64 > 21).for_each(|index| texels[index] = 50000);
    texels[63 * 64 + 63] = u16::MAX;
    let heights = Heights::new([64, 64], Border::Wrap, Texels::U16(texels)).expect("as many texels as its size says");
    let subject = Subject { name: "step".into(), heights, full: 65535.0 };
    let place = Place::new(&subject, Sun::new(0.0, 60.0, 0.27));
    let points = [[20.4, 30.0]];
    let seen = place.seen(&gpu, Lighting::Published, &points)[0].share.expect("resolved");
    assert!(place.sun_shares(&points, 24)[0] > 1.0 - 1e-9 && seen < 0.9, "{seen}");
}
