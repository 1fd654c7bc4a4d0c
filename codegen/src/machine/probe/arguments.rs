//! Arguments for library nodes: random, inside the declared ranges, as scenes have them.

use crate::library::{Overload, Port};
use crate::machine::domain::F32;
use crate::machine::error::MachineError;
use crate::machine::value::Value;
use crate::value::Type;

/// One point in so many has a footprint of exactly 0, as a host without gradients gives.
const STILL: usize = 16;

/// Values for all parameters of a node at so many points, the same for equal nodes and seeds.
///
/// Numbers are inside the ports' ranges. Places lie in patches of 64 m on a terrain of some kilometres, and pixels are
/// centimetres to metres wide, some of no width at all. A texture port is three arguments: texture 0, sampler 0, layer 0.
///
/// # Errors
/// If a port is a struct for which nothing typical is known.
pub fn arguments(overload: &Overload, points: usize, seed: u64) -> Result<Vec<Value<F32>>, MachineError> {
    // Nodes of equal ports get different numbers.
    let mut random =
        Random(overload.function.bytes().fold(seed, |seed, byte| seed.wrapping_mul(31).wrapping_add(byte.into())));
    let mut arguments = Vec::new();
    for port in &overload.inputs {
        match &port.ty {
            Type::Texture => arguments.extend([Value::handle(0), Value::handle(0), Value::i32(&[0])]),
            Type::Struct(name) if name == "Place" => arguments.push(place(&mut random, points)),
            Type::Struct(name) if name == "Coord" => arguments.push(coord(&mut random, points)),
            Type::Struct(name) => {
                let construct = format!("a port of type `{name}`, for which no arguments are known");
                return Err(MachineError::Unsupported { function: overload.function.clone(), construct });
            }
            _ => arguments.push(number(&mut random, port, points)),
        }
    }
    Ok(arguments)
}

fn number(random: &mut Random, port: &Port, points: usize) -> Value<F32> {
    let (low, high) = port.range.unwrap_or((0.0, 65535.0));
    let mut whole = || (0..points).map(|_| (low + (high - low) * random.unit()) as i64).collect::<Vec<_>>();
    match &port.ty {
        Type::I32 => Value::i32(&whole().iter().map(|number| *number as i32).collect::<Vec<_>>()),
        Type::U32 => Value::u32(&whole().iter().map(|number| *number as u32).collect::<Vec<_>>()),
        // Wide ranges are those of lengths, which are small more often than large.
        floats => vector(random, floats.components().unwrap_or(1), points, |random| {
            let t = random.unit();
            low + (high - low) * if high - low > 1000.0 { t * t * t } else { t }
        }),
    }
}

fn vector(random: &mut Random, count: usize, points: usize, draw: impl Fn(&mut Random) -> f32) -> Value<F32> {
    Value::join((0..count).map(|_| Value::f32(&(0..points).map(|_| draw(random)).collect::<Vec<_>>())))
}

fn place(random: &mut Random, points: usize) -> Value<F32> {
    let mut patch = || 64 * 256 * ((random.unit() * 128.0) as i32 - 64);
    let corners: Vec<[i32; 2]> = (0..points).map(|_| [patch(), patch()]).collect();
    let local = vector(random, 3, points, |random| 64.0 * random.unit());
    Value::join([Value::integers(&corners), local, gradients(random, 6, points)])
}

fn coord(random: &mut Random, points: usize) -> Value<F32> {
    let uv = vector(random, 2, points, |random| 8.0 * random.unit() - 4.0);
    Value::join([uv, gradients(random, 4, points)])
}

/// Small more often than large, and all of them 0 at some points.
fn gradients(random: &mut Random, count: usize, points: usize) -> Value<F32> {
    let mut one = |point: usize| {
        let (size, number) = (random.unit(), random.unit() - 0.5);
        if point.is_multiple_of(STILL) { 0.0 } else { number * (size * size) * (size * size) }
    };
    Value::join((0..count).map(|_| Value::f32(&(0..points).map(&mut one).collect::<Vec<_>>())))
}

/// SplitMix64 (Steele, Lea and Flood, 2014).
struct Random(u64);

impl Random {
    /// From 0 up to but not including 1.
    fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 40) as f32 / 16_777_216.0
    }
}
