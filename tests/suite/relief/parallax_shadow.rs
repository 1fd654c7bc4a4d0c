//! The published soft shadow of parallax occlusion mapping against its table.

use terrane::relief::Lighting;
use terrane_shaderlib::heightfield::visibility::Sun;

use super::device;
use super::lighting::{Place, differences, largest, subjects};

/// The table of the sample, in f64.
fn published_parallax(place: &Place<'_>, [x, y]: [f64; 2], lid: f64) -> f64 {
    let Sun { towards, tangent, .. } = place.scene.sun;
    let reach = lid / place.scene.steps / tangent.hypot(1.0);
    let at = |part: f64| place.heights.surface(x + part * reach * towards[0], y + part * reach * towards[1]) / lid;
    let taps = [(0.88, 1.0), (0.77, 2.0), (0.66, 4.0), (0.55, 6.0), (0.44, 8.0), (0.33, 10.0), (0.22, 12.0)];
    let blocked = taps.map(|(part, weight)| (at(part) - at(0.0) - part) * weight * 0.58);
    let free = 1.0 - blocked.into_iter().fold(f64::MIN, f64::max);
    (free * 0.6 + 0.4).clamp(0.0, 1.0)
}

#[test]
fn published_parallax_shadows_are_those_of_the_table() {
    let Some(gpu) = device() else { return };
    let mut partly = 0;
    for subject in subjects(128) {
        let place = Place::new(&subject, Sun::new(34.0, 30.0, 0.27));
        let points = place.facing(24);
        let lid = place.heights.highest();
        let truth: Vec<f64> = points.iter().map(|point| published_parallax(&place, *point, lid)).collect();
        partly += truth.iter().filter(|share| (0.01..0.99).contains(*share)).count();
        let off = largest(&differences(&place.seen(&gpu, Lighting::ParallaxPublished, &points), &truth));
        assert!(off < 1e-3, "{}: off by {off}", subject.name);
    }
    assert!(partly > 100, "only {partly} points are partly lit");
}
