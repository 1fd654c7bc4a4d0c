//! The atmosphere keeps energy, and its tables agree with direct integrals.

use std::f64::consts::TAU;

use glam::DVec3;
use terrane::render::air::{Aerial, Atmosphere, Daylight, Medium, PLANET_RADIUS, SkyTable, TOP_RADIUS};
use terrane::render::{Camera, luminance, sun_direction};

/// Directions of the upper hemisphere in even steps of sine of elevation, with equal solid angles.
fn hemisphere() -> Vec<DVec3> {
    let (rings, sectors) = (48, 96);
    let direction = |i: i32| {
        let up = (f64::from(i / sectors) + 0.5) / f64::from(rings);
        let azimuth = TAU * (f64::from(i % sectors) + 0.25) / f64::from(sectors);
        let flat = (1.0 - up * up).sqrt();
        DVec3::new(flat * azimuth.sin(), up, flat * azimuth.cos())
    };
    (0..rings * sectors).map(direction).collect()
}

fn irradiance(radiance: impl Fn(DVec3) -> DVec3, normal: DVec3) -> DVec3 {
    let directions = hemisphere();
    let solid_angle = TAU / directions.len() as f64;
    directions.iter().map(|&d| radiance(d) * (d.dot(normal).max(0.0) * solid_angle)).sum()
}

fn assert_near(value: DVec3, exact: DVec3, part: f64, what: &str) {
    assert!(((value - exact).abs() / exact).max_element() < part, "{what}: {value}, not {exact}");
}

#[test]
fn the_ambient_light_is_the_integral_of_the_sky() {
    for (elevation, turbidity) in [(6.0, 2.0), (28.0, 3.0), (60.0, 6.0)] {
        let atmosphere = Atmosphere::new(turbidity, sun_direction(130.0, elevation));
        let daylight = Daylight::new(&atmosphere, 300.0);
        let table = SkyTable::new(&atmosphere, 300.0, daylight.sky);
        let flat = irradiance(|d| table.radiance(d), DVec3::Y);
        assert_near(daylight.sky, flat, 0.02, "sky on flat ground");
        assert_near(daylight.harmonics.irradiance(DVec3::Y), flat, 0.02, "harmonics on flat ground");
        let tilted = DVec3::new(0.5, 0.8, -0.33).normalize();
        let exact = irradiance(|d| table.radiance(d), tilted);
        assert_near(daylight.harmonics.irradiance(tilted), exact, 0.12, "harmonics on a slope");
    }
}

#[test]
fn the_ground_gets_less_than_what_comes_in() {
    for turbidity in [1.8, 3.0, 6.0, 10.0] {
        let mut before = 0.0;
        for elevation in [0.0, 2.0, 5.0, 15.0, 30.0, 50.0, 70.0, 90.0] {
            let sun = sun_direction(40.0, elevation);
            let daylight = Daylight::new(&Atmosphere::new(turbidity, sun), 0.0);
            let total = luminance(daylight.sun) * sun.y + luminance(daylight.sky);
            // Light that bounces between land and air arrives more than once: a few percent.
            assert!(total < sun.y.max(0.02) * 1.05, "turbidity {turbidity}, {elevation} degrees: {total}");
            assert!(total > before, "turbidity {turbidity}: darker at {elevation} degrees than before");
            assert!(daylight.sky.min_element() > 0.0);
            before = total;
        }
    }
}

/// Bird and Riordan (1984) and CIE measurements agree on 10 to 25 % of the light from a clear sky at mid elevation.
#[test]
fn a_clear_sky_gives_a_believable_share() {
    let sun = sun_direction(40.0, 45.0);
    let daylight = Daylight::new(&Atmosphere::new(2.5, sun), 0.0);
    let (direct, sky) = (luminance(daylight.sun) * sun.y, luminance(daylight.sky));
    let share = sky / (direct + sky);
    assert!((0.08..0.28).contains(&share), "{share}");
    assert!(daylight.sky.z > daylight.sky.x, "the sky is not blue");
    assert!(daylight.sun.x > daylight.sun.z, "the sun is not warm");
}

#[test]
fn the_transmittance_table_agrees_with_the_integral() {
    let medium = Medium::clear(3.0);
    for elevation in [1.0, 3.0, 10.0, 28.0, 60.0, 89.0] {
        for height in [0.0, 250.0, 1200.0, 3000.0] {
            let sun = sun_direction(0.0, elevation);
            let table = Atmosphere::new(3.0, sun).sun_irradiance(height);
            let start = PLANET_RADIUS + height;
            let length = -start * sun.y + (start * start * (sun.y * sun.y - 1.0) + TOP_RADIUS * TOP_RADIUS).sqrt();
            let steps = 20_000;
            let depth: DVec3 = (0..steps)
                .map(|step| (f64::from(step) + 0.5) / f64::from(steps) * length)
                .map(|t| (start * start + t * t + 2.0 * start * sun.y * t).sqrt() - PLANET_RADIUS)
                .map(|height| medium.at(height).extinction * (length / f64::from(steps)))
                .sum();
            let exact = (-depth).exp();
            let good = (table - exact).abs().cmple(exact * 0.01 + 3e-4).all();
            assert!(good, "{elevation} degrees, {height} m: {table}, not {exact}");
        }
    }
}

#[test]
fn distant_air_becomes_the_sky() {
    let atmosphere = Atmosphere::new(3.0, sun_direction(130.0, 28.0));
    let camera = Camera { eye: [0.0, 200.0, 0.0], target: [1000.0, 230.0, 500.0], fov: 40.0 };
    let view = camera.view(64, 36).expect("a good camera");
    let aerial = Aerial::new(&atmosphere, &view, 1.0e6);
    // A ray just over the horizon, through the middle of the picture: all of its air is within reach.
    let direction = view.ray(32.0 / 63.0, 18.0 / 35.0);
    let sky = atmosphere.radiance(200.0, direction, DVec3::ZERO);
    let cell = aerial.cells[(31 * 36 + 18) * 64 + 32];
    assert_near(cell, sky, 0.03, "the last cell");
}

#[test]
fn turbidity_is_the_optical_depth_over_that_of_molecules() {
    let medium = Medium::clear(4.0);
    let local = medium.at(0.0);
    assert!(local.extinction.cmpge(local.rayleigh + local.haze).all());
    // Bucholtz 1995: 0.098 at 550 nm.
    let molecules = medium.rayleigh.y * Medium::RAYLEIGH_HEIGHT;
    let haze = medium.haze_extinction.y * Medium::HAZE_HEIGHT;
    assert!((molecules - 0.1).abs() < 0.012, "{molecules}");
    assert!((haze / molecules - 3.0).abs() < 0.3, "turbidity 4 has three parts of haze on one of molecules: {haze}");
}
