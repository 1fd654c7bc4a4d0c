//! Texture reads: arguments and globals, levels and gradients, filters, and what `Accept` makes of them.

use terrane_codegen::machine::domain::accept::Interval;
use terrane_codegen::machine::{
    Accept, Component, Domain, F32, F64, Footprint, Image, Images, Machine, Sample, Sampler, Textures, Value, Wrap,
};

use crate::support::{Random, shader};

const READS: &str = "
@group(1) @binding(0) var heights: texture_2d<f32>;
@group(1) @binding(1) var heights_sampler: sampler;

fn read(from_texture: texture_2d_array<f32>, how: sampler, layer: i32, uv: vec2f) -> vec4f {
    return textureSampleLevel(from_texture, how, uv, layer, 0.0);
}
fn twice(of_texture: texture_2d_array<f32>, of_sampler: sampler, uv: vec2f) -> vec4f {
    return read(of_texture, of_sampler, 0, uv) + read(of_texture, of_sampler, 1, uv);
}
fn wide(of_texture: texture_2d_array<f32>, of_sampler: sampler, uv: vec2f, ddx: vec2f) -> vec4f {
    return textureSampleGrad(of_texture, of_sampler, uv, 0, ddx, vec2f(0.0), vec2i(1, 0));
}
fn global(uv: vec2f, level: f32) -> f32 {
    return textureSampleLevel(heights, heights_sampler, uv, level).x;
}
fn texel(at: vec2i, level: i32) -> f32 { return textureLoad(heights, at, level).y; }
fn sizes(of_texture: texture_2d_array<f32>, level: u32) -> vec4u {
    return vec4u(textureDimensions(of_texture, level), textureNumLayers(of_texture), textureNumLevels(of_texture));
}
fn whole(of_texture: texture_2d<u32>, at: vec2u) -> u32 { return textureLoad(of_texture, at, 0).x; }";

fn images() -> Images {
    // 4 x 2, two layers: texel (x, y) of layer l holds (x, y, l, 1).
    let texel = |i: u32| [f64::from(i % 4), f64::from(i / 4 % 2), f64::from(i / 8), 1.0];
    let array = Image::new(4, 2, 2, (0..16).map(texel).collect()).with_mean_levels();
    let words = Image::new(2, 1, 1, vec![[f64::from(u32::MAX), 0.0, 0.0, 1.0], [7.0, 0.0, 0.0, 1.0]]);
    let sampler = |wrap, linear| Sampler { wrap, linear, linear_levels: linear, anisotropy: 1 };
    Images {
        images: vec![array, words],
        samplers: vec![
            sampler(Wrap::Repeat, true),
            sampler(Wrap::Clamp, true),
            sampler(Wrap::Mirror, true),
            sampler(Wrap::Repeat, false),
        ],
    }
}

#[track_caller]
fn call<D: Domain>(function: &str, arguments: &[Value<D>], points: usize) -> Value<D> {
    let (shader, images) = (shader(READS), images());
    let mut machine = Machine::new(&shader.module, &shader.info, &images);
    machine.bind("heights", 0).expect("there is such a variable");
    machine.bind("heights_sampler", 1).expect("there is such a variable");
    match machine.call(function, arguments, points) {
        Ok((value, _)) => value,
        Err(error) => panic!("{error}"),
    }
}

#[track_caller]
fn close(value: &Value<F64>, component: usize, expected: &[f64]) {
    for (point, expected) in expected.iter().enumerate() {
        let found = value.float_at(component, point).expect("a float");
        assert!((found - expected).abs() < 1e-6, "component {component}, point {point}: {found}, not {expected}");
    }
}

#[test]
fn textures_flow_as_arguments_and_are_filtered_between_texel_centres() {
    // The centre of texel (1, 0); halfway to (2, 0); a quarter on to the wrapped (0, 0) of the next; between the rows.
    let uv = [[0.375, 0.25], [0.5, 0.25], [0.9375, 0.25], [0.375, 0.5]];
    let result = call::<F64>("twice", &[Value::handle(0), Value::handle(0), Value::vector(&uv)], 4);
    close(&result, 0, &[2.0, 3.0, 4.5, 2.0]);
    close(&result, 1, &[0.0, 0.0, 0.0, 1.0]);
    close(&result, 2, &[1.0; 4]);
    close(&result, 3, &[2.0; 4]);
}

#[test]
fn wraps_are_repeat_clamp_and_mirror() {
    let uv = [[1.125, 0.25], [-0.375, 0.25], [1.4, 0.25]];
    for (sampler, expected) in [(0, [0.0, 2.0, 1.1]), (1, [3.0, 0.0, 3.0]), (2, [3.0, 1.0, 1.9]), (3, [0.0, 2.0, 1.0])]
    {
        let result =
            call::<F64>("read", &[Value::handle(0), Value::handle(sampler), Value::i32(&[0]), Value::vector(&uv)], 3);
        close(&result, 0, &expected);
    }
}

#[test]
fn levels_come_from_the_argument_or_the_gradients() {
    let uv = Value::vector(&[[0.25, 0.5]]);
    // Level 1 is 2 x 1: means of 2 x 2 texels, 0.5 and 2.5 in x. Level 2 is 1.5.
    let result = call::<F64>("global", &[uv, Value::f32(&[0.0, 1.0, 1.5, 9.0])], 4);
    close(&result, 0, &[0.5, 0.5, 1.0, 1.5]);
    // A step of half the texture is two texels: level 1. The offset is one texel of the level: 2.5.
    let arguments =
        [Value::handle(0), Value::handle(0), Value::vector(&[[0.25, 0.5]]), Value::vector(&[[0.5, 0.0], [0.25, 0.0]])];
    close(&call::<F64>("wide", &arguments, 2), 0, &[2.5, 1.5]);
}

#[test]
fn loads_sizes_and_whole_numbers() {
    let at = Value::integers(&[[1, 1], [3, 0], [4, 0], [0, -1]]);
    close(&call::<F64>("texel", &[at, Value::i32(&[0])], 4), 0, &[1.0, 0.0, 0.0, 0.0]);
    let result = call::<F32>("sizes", &[Value::handle(0), Value::u32(&[0, 1])], 2);
    let columns = [[4, 2], [2, 1], [2, 2], [3, 3]];
    assert_eq!(result.components, columns.map(|column| Component::Int(column.to_vec())));
    let at = Value::join([Value::u32(&[0, 1]), Value::u32(&[0])]);
    let result = call::<F32>("whole", &[Value::handle(1), at], 2);
    assert_eq!(result.components, [Component::Int(vec![u32::MAX, 7])]);
}

#[test]
fn samples_are_accepted_wherever_the_coordinates_are() {
    let (images, mut random) = (images(), Random::new(17));
    for _ in 0..2000 {
        let uv = [random.unit() * 4.0 - 2.0, random.unit() * 4.0 - 2.0];
        let width = random.unit() * if random.below(2) == 0 { 0.01 } else { 1.0 };
        let slope = random.unit() * 2.0;
        let sampler = random.below(4);
        let gradient = |x: f32| Footprint::Gradient { ddx: [x, 0.0], ddy: [0.0, x] };
        let footprint = if random.below(2) == 0 { Footprint::Level(slope) } else { gradient(slope) };
        let interval = |x: f32, width: f32| Interval::new(x - width, x + width);
        let wide = Sample {
            texture: 0,
            sampler,
            layer: Accept::int(0),
            uv: uv.map(|x| interval(x, width)),
            offset: [0, 0],
            footprint: match footprint {
                Footprint::Level(level) => Footprint::Level(interval(level, 0.1)),
                Footprint::Gradient { ddx, ddy } => {
                    Footprint::Gradient { ddx: ddx.map(|x| interval(x, 0.01)), ddy: ddy.map(|x| interval(x, 0.01)) }
                }
            },
        };
        let accepted = Accept::sample(&images, &wide).expect("the texture exists");
        for _ in 0..4 {
            let inside = uv.map(|x| f64::from(x + width * (2.0 * random.unit() - 1.0) * 0.999));
            let footprint = match footprint {
                Footprint::Level(level) => Footprint::Level(f64::from(level)),
                Footprint::Gradient { ddx, ddy } => {
                    Footprint::Gradient { ddx: ddx.map(f64::from), ddy: ddy.map(f64::from) }
                }
            };
            let sample = Sample { texture: 0, sampler, layer: 0, uv: inside, offset: [0, 0], footprint };
            let texel = images.sample(&sample).expect("the texture exists");
            for (accepted, value) in accepted.iter().zip(texel) {
                assert!(accepted.holds(value), "{sample:?} gives {value}, not in {accepted:?}");
            }
        }
    }
}
