//! Arguments for library nodes: random, inside the declared ranges, as scenes have them.

use terrane_codegen::library::{Overload, Port};
use terrane_codegen::machine::{F32, Value};
use terrane_codegen::value::Type;

use crate::support::Random;

/// Values for all parameters of a node. A texture port is three of them; its texture and sampler have id 0.
pub(crate) fn arguments(overload: &Overload, points: usize) -> Vec<Value<F32>> {
    let mut random = Random::new(
        overload.function.bytes().fold(0, |seed: u32, byte| seed.wrapping_mul(31).wrapping_add(byte.into())),
    );
    let of = |port: &Port| match &port.ty {
        Type::Texture => vec![Value::handle(0), Value::handle(0), Value::i32(&[0])],
        _ => vec![argument(&mut random, port, points)],
    };
    overload.inputs.iter().flat_map(of).collect()
}

fn argument(random: &mut Random, port: &Port, points: usize) -> Value<F32> {
    let (low, high) = port.range.unwrap_or((0.0, 65535.0));
    let mut whole = || (0..points).map(|_| (low + (high - low) * random.unit()) as i64).collect::<Vec<_>>();
    match &port.ty {
        Type::I32 => Value::i32(&whole().iter().map(|number| *number as i32).collect::<Vec<_>>()),
        Type::U32 => Value::u32(&whole().iter().map(|number| *number as u32).collect::<Vec<_>>()),
        Type::Struct(name) if name == "Place" => place(random, points),
        Type::Struct(name) if name == "Coord" => coord(random, points),
        Type::Struct(name) => panic!("no values for a port of type {name}"),
        // Wide ranges are those of lengths, which are small more often than large.
        floats => numbers(random, floats.components().unwrap_or(1), points, |random| {
            let t = random.unit();
            low + (high - low) * if high - low > 1000.0 { t * t * t } else { t }
        }),
    }
}

fn numbers(random: &mut Random, count: usize, points: usize, draw: impl Fn(&mut Random) -> f32) -> Value<F32> {
    Value::join((0..count).map(|_| Value::f32(&(0..points).map(|_| draw(random)).collect::<Vec<_>>())))
}

/// Somewhere in a patch of 64 m, on a terrain of some kilometres, seen by pixels of centimetres to metres.
fn place(random: &mut Random, points: usize) -> Value<F32> {
    let corners: Vec<[i32; 2]> =
        (0..points).map(|_| [0; 2].map(|_| 64 * 256 * (random.below(128) as i32 - 64))).collect();
    let local = numbers(random, 3, points, |random| 64.0 * random.unit());
    let gradient = |random: &mut Random| (random.unit() - 0.5) * random.unit().powi(4);
    let (ddx, ddy) = (numbers(random, 3, points, gradient), numbers(random, 3, points, gradient));
    Value::join([Value::integers(&corners), local, ddx, ddy])
}

fn coord(random: &mut Random, points: usize) -> Value<F32> {
    let uv = numbers(random, 2, points, |random| 8.0 * random.unit() - 4.0);
    let gradients = numbers(random, 4, points, |random| (random.unit() - 0.5) * random.unit().powi(4));
    Value::join([uv, gradients])
}
