//! Horizons and the visible sky against brute force.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use terrane::render::HeightField;
use terrane::render::light::{Horizons, Land, OPEN, sky_visibility};

use super::world::mountains;

/// The steepest slope from a texel to the bilinear surface along a direction, in steps of a fortieth of a texel.
fn brute_force(field: &HeightField, column: u32, row: u32, direction: DVec2) -> f64 {
    let direction = direction.normalize();
    let [sx, sz] = field.spacing();
    let from = DVec2::new((f64::from(column) + 0.5) * sx, (f64::from(row) + 0.5) * sz);
    let height = f64::from(field.at(i64::from(column), i64::from(row)));
    let inside = |at: DVec2| {
        let place = at / DVec2::new(sx, sz) - 0.5;
        let last = DVec2::new(f64::from(field.size()[0]) - 1.0, f64::from(field.size()[1]) - 1.0);
        place.cmpge(DVec2::splat(-1e-9)).all() && place.cmple(last + 1e-9).all()
    };
    // From a texel away: nearer than that the receiver stands on the same bilinear patch.
    (40..)
        .map(|step| f64::from(step) * sx.min(sz) / 40.0)
        .map(|distance| (distance, from + direction * distance))
        .take_while(|&(_, at)| inside(at))
        .map(|(distance, at)| (field.bilinear(at.x, at.y) - height) / distance)
        .fold(f64::from(OPEN), f64::max)
}

#[test]
fn horizons_agree_with_brute_force() {
    let field = mountains(96, 24.0);
    for azimuth in [0.0, 0.3, 0.785, 1.1, 1.6, 2.3, 3.1, 3.9, 4.7, 5.9] {
        let direction = DVec2::from_angle(azimuth);
        let horizons = Horizons::new(Land { field: &field, beyond: 0.0 }, direction, &|_| ());
        let mut errors: Vec<f64> = Vec::new();
        for row in 2..94 {
            for column in 2..94 {
                let exact = brute_force(&field, column, row, direction);
                // Below the horizontal no sun and no sky is hidden.
                let swept = f64::from(horizons.tangents[(row * 96 + column) as usize]);
                errors.push((swept.max(0.0).atan() - exact.max(0.0).atan()).abs().to_degrees());
            }
        }
        errors.sort_by(f64::total_cmp);
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        let p99 = errors[errors.len() * 99 / 100];
        assert!(mean < 0.5 && p99 < 4.0, "azimuth {azimuth}: mean {mean}, p99 {p99} degrees");
    }
}

#[test]
fn horizons_are_exact_along_the_axes() {
    let field = mountains(64, 20.0);
    for direction in [DVec2::X, -DVec2::X, DVec2::Y, -DVec2::Y] {
        let horizons = Horizons::new(Land { field: &field, beyond: 0.0 }, direction, &|_| ());
        for (index, &swept) in horizons.tangents.iter().enumerate() {
            let exact = brute_force(&field, index as u32 % 64, index as u32 / 64, direction);
            assert!((f64::from(swept) - exact).abs() < 1e-5, "{direction}, texel {index}: {swept}, not {exact}");
        }
    }
}

#[test]
fn a_wall_throws_the_shadow_that_its_height_gives() {
    let heights = (0..64 * 64).map(|i| if i % 64 == 40 { 30.0 } else { 0.0 }).collect();
    let field = HeightField::new([64, 64], [2.0, 2.0], heights).expect("finite heights");
    let horizons = Horizons::new(Land { field: &field, beyond: 0.0 }, DVec2::X, &|_| ());
    for column in 0..40 {
        let tangent = horizons.tangents[32 * 64 + column];
        let exact = 30.0 / (2.0 * (40 - column) as f32);
        assert!((tangent - exact).abs() < 1e-4, "column {column}: {tangent}, not {exact}");
    }
    assert_eq!(horizons.tangents[32 * 64 + 63], OPEN);
}

#[test]
fn an_open_plain_sees_the_whole_sky() {
    let field = HeightField::new([32, 32], [1.0, 1.0], vec![7.0; 32 * 32]).expect("finite heights");
    for vector in sky_visibility(Land { field: &field, beyond: 0.0 }, 8, &|_| ()).vectors {
        assert!((vector - glam::Vec3::Y).length() < 1e-5, "{vector}");
    }
}

/// A plane's sky is the part of the hemisphere over the horizontal that lies over the plane too: (1 + cos)/2 of an even
/// sky's light.
#[test]
fn a_slope_loses_the_sky_behind_it() {
    let heights = (0..128 * 128).map(|i| (i % 128) as f32 * 0.75).collect();
    let field = HeightField::new([128, 128], [1.0, 1.0], heights).expect("finite heights");
    let normal = DVec3::new(-0.75, 1.0, 0.0).normalize();
    let vectors = sky_visibility(Land { field: &field, beyond: 0.0 }, 64, &|_| ()).vectors;
    let seen = vectors[64 * 128 + 64].as_dvec3().dot(normal);
    let exact = (1.0 + normal.y) / 2.0;
    assert!((seen - exact).abs() < 2e-3, "{seen}, not {exact}");
}

#[test]
fn visible_sky_agrees_with_brute_force() {
    let field = mountains(64, 30.0);
    let swept = sky_visibility(Land { field: &field, beyond: 0.0 }, 16, &|_| ()).vectors;
    let mut worst = 0.0_f64;
    let mut sum = 0.0;
    for row in (8..56).step_by(4) {
        for column in (8..56).step_by(4) {
            let exact = brute_force_sky(&field, column, row, 96);
            let off = swept[(row * 64 + column) as usize].as_dvec3().distance(exact);
            worst = worst.max(off);
            sum += off / 144.0;
        }
    }
    assert!(sum < 0.012 && worst < 0.06, "mean {sum}, worst {worst}");
}

/// Midpoint integral over azimuth and elevation.
fn brute_force_sky(field: &HeightField, column: u32, row: u32, azimuths: u32) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for azimuth in 0..azimuths {
        let direction = DVec2::from_angle(TAU * f64::from(azimuth) / f64::from(azimuths));
        let horizon = brute_force(field, column, row, direction).max(0.0).atan();
        for step in 0..200 {
            let elevation = (f64::from(step) + 0.5) / 200.0 * TAU / 4.0;
            if elevation > horizon {
                let (up, flat) = elevation.sin_cos();
                sum += DVec3::new(direction.x * flat, up, direction.y * flat) * flat;
            }
        }
    }
    sum * (TAU / f64::from(azimuths)) * (TAU / 4.0 / 200.0) / (TAU / 2.0)
}
