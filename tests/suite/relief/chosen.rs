//! A method that a terrain names: the ground is where it finds it, and its light is what it is with any other.

use terrane::render::{Camera, Gpu};
use terrane_shaderlib::relief::Method;

use super::device;
use super::plain::{MIDDLE, Plain, SHAPE, Shape, rough};

/// From over the finest mips to the fourth, some of them between two.
const CAMERA: Camera =
    Camera { eye: [MIDDLE.x, 3.2, MIDDLE.z], target: [MIDDLE.x + 0.3, 0.0, MIDDLE.z - 5.5], fov: 52.0 };

fn named(method: Method) -> Shape {
    Shape { method: Some(method), ..SHAPE }
}

/// What a terrain draws that names a method.
fn drawn(gpu: &Gpu, method: Method) -> Vec<u8> {
    Plain::new(&rough(64), named(method)).render(gpu, CAMERA).image.pixels
}

/// The same over maps of two sizes.
fn drawn_over_two(gpu: &Gpu, method: Method) -> Vec<u8> {
    let plain = Plain::layered(&[&rough(64), &rough(32)], named(method));
    plain.unwrap_or_else(|findings| panic!("{findings}")).render(gpu, CAMERA).image.pixels
}

/// The part of a picture's bytes that differ by more than two of 255.
fn other(a: &[u8], b: &[u8]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).filter(|(a, b)| a.abs_diff(**b) > 2).count() as f64 / a.len() as f64
}

#[test]
fn every_exact_method_draws_the_same_picture() {
    let Some(gpu) = device() else { return };
    let walk = drawn(&gpu, Method::Walk);
    let methods: Vec<Method> = Method::all().into_iter().filter(|method| method.is_exact()).collect();
    assert_eq!(methods.len(), 8, "{methods:?}");
    for method in methods {
        // A hit on the other side of an edge is lit otherwise.
        let part = other(&drawn(&gpu, method), &walk);
        assert!(part < 0.002, "{method}: {part} of the picture is another");
    }
}

#[test]
fn so_it_is_over_maps_of_two_sizes() {
    let Some(gpu) = device() else { return };
    let walk = drawn_over_two(&gpu, Method::Walk);
    let seen = other(&walk, &drawn(&gpu, Method::Walk));
    assert!(seen > 0.1, "the second map changes {seen} of the picture");
    for method in [Method::Sprint, Method::Wide, Method::Stride] {
        let part = other(&drawn_over_two(&gpu, method), &walk);
        assert!(part < 0.002, "{method}: {part} of the picture is another");
    }
}

#[test]
fn more_storage_textures_than_a_stage_has_are_refused() {
    let maps = [16, 32, 64].map(rough);
    let maps = maps.each_ref();
    assert!(Plain::layered(&maps, named(Method::Walk)).is_ok());
    let findings = Plain::layered(&maps, named(Method::Sprint)).err().expect("six storage textures");
    assert!(findings.contains("the materials need 6 storage textures, the host leaves 4"), "{findings}");
    assert!(findings.contains("`relief_32x32_patch_bounds`: relief_1.png"), "{findings}");
}

#[test]
fn every_method_can_be_drawn() {
    let Some(gpu) = device() else { return };
    for method in Method::all().into_iter().filter(|method| !method.is_exact()) {
        let picture = drawn(&gpu, method);
        assert!(picture.iter().any(|byte| *byte != picture[0]), "{method}: an even picture");
    }
}

#[test]
fn light_is_not_what_a_method_makes_of_it() {
    let Some(gpu) = device() else { return };
    // With so many steps it finds what is exact nearly everywhere, and it has no bounds of its own.
    let part = other(&drawn(&gpu, Method::Linear(2048, 0)), &drawn(&gpu, Method::Walk));
    assert!(part < 0.01, "{part} of the picture is another");
}
