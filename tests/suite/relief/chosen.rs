//! A method that a terrain names: the ground is where it finds it, and its light is what it is with any other.

use terrane::render::Gpu;
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::Method;

use super::device;
use super::plain::{Plain, SHAPE, SLOPING, Shape, other, rough, rough_over};

fn named(method: Method) -> Shape {
    Shape { method: Some(method), ..SHAPE }
}

/// What a terrain draws that names a method, over maps that have the same share of it.
fn drawn(gpu: &Gpu, method: Method, maps: &[&Heights]) -> Vec<u8> {
    let plain = Plain::layered(maps, named(method));
    plain.unwrap_or_else(|findings| panic!("{findings}")).render(gpu, SLOPING).image.pixels
}

/// A method has to draw the walk's picture: but for hits on the other side of an edge, which are lit otherwise.
#[track_caller]
fn expect_walk(gpu: &Gpu, methods: &[Method], maps: &[&Heights]) {
    let walk = drawn(gpu, Method::Walk, maps);
    for method in methods {
        let part = other(&drawn(gpu, *method, maps), &walk, 2);
        assert!(part < 0.002, "{method}: {part} of the picture is another");
    }
}

/// One for each kind of textures.
const KINDS: [Method; 5] = [Method::Sprint, Method::Wide, Method::Leap, Method::Stride, Method::StrideQuadrants];

#[test]
fn every_exact_method_draws_the_same_picture() {
    let Some(gpu) = device() else { return };
    let methods: Vec<Method> = Method::all().into_iter().filter(|method| method.is_exact()).collect();
    assert_eq!(methods.len(), 10, "{methods:?}");
    expect_walk(&gpu, &methods, &[&rough(64)]);
}

#[test]
fn so_it_is_over_maps_of_two_sizes() {
    let Some(gpu) = device() else { return };
    let (large, small) = (rough(64), rough(32));
    let [one, two] = [&[&large][..], &[&large, &small]].map(|maps| drawn(&gpu, Method::Walk, maps));
    let seen = other(&one, &two, 2);
    assert!(seen > 0.1, "the second map changes {seen} of the picture");
    expect_walk(&gpu, &KINDS, &[&large, &small]);
}

#[test]
fn so_it_is_over_maps_of_few_texels_and_of_unequal_sides() {
    let Some(gpu) = device() else { return };
    for size in [[1, 1], [2, 2], [2, 8], [64, 16]] {
        expect_walk(&gpu, &KINDS, &[&rough_over(size)]);
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
    let level = Heights::new([64; 2], Border::Wrap, Texels::U16(vec![u16::MAX; 4096])).expect("a map");
    let even = drawn(&gpu, Method::Walk, &[&level]);
    for method in Method::all().into_iter().filter(|method| !method.is_exact()) {
        let part = other(&drawn(&gpu, method, &[&rough(64)]), &even, 2);
        assert!(part > 0.3, "{method}: only {part} of the picture shows relief");
    }
}

#[test]
fn light_is_not_what_a_method_makes_of_it() {
    let Some(gpu) = device() else { return };
    // With so many steps it finds what is exact nearly everywhere, and it has no bounds of its own.
    let [many, exact] = [Method::Linear(2048, 0), Method::Walk].map(|method| drawn(&gpu, method, &[&rough(64)]));
    let part = other(&many, &exact, 2);
    assert!(part < 0.01, "{part} of the picture is another");
}
