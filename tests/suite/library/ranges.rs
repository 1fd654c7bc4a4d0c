//! Inputs inside the declared ranges give finite results inside the declared range, without an undefined operation on the way:
//! random ones and every corner.

use terrane_codegen::library::{Overload, Port};
use terrane_codegen::machine::{Component, F32, Value};
use terrane_codegen::value::Type;

use super::LIBRARY;
use super::call::{Place, floats, machine, place};
use super::watched::{Watched, take_hazard};

/// Points for each node.
pub(super) const POINTS: usize = 3000;

/// Numbers of an input whose ends are combined in every way; further ones repeat the first.
const CORNER_BITS: usize = 11;

/// SplitMix64 (Steele, Lea and Flood, 2014): a seeded sequence that is the same everywhere.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn word(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 up to but not including 1.
    pub(super) fn unit(&mut self) -> f64 {
        (self.word() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Half of the time a special value: an end of the range, a value next to it, 0, 0.5, 1 or something tiny.
    fn number(&mut self, (low, high): (f32, f32)) -> f32 {
        let tiny = (self.between(-30.0, 0.0) * std::f64::consts::LN_10).exp() as f32;
        let special = [low, high, low.next_up(), high.next_down(), 0.0, 0.5, 1.0, -1.0, tiny, -tiny, low + tiny];
        let choice = self.word() as usize % (2 * special.len());
        let any = self.between(low.into(), high.into()) as f32;
        special.get(choice).copied().unwrap_or(any).clamp(low, high)
    }

    /// A place up to 8,000 km away, seen by pixels of any size.
    fn place(&mut self) -> Place {
        let mut gradient = || {
            let size = [0.0, 1e-3, 0.1, 10.0, 1e4][self.word() as usize % 5];
            [0; 3].map(|_| self.between(-size, size) as f32)
        };
        let (ddx, ddy) = (gradient(), gradient());
        let origin =
            [0; 2].map(|_| [0, 256, -2_048_000_000, self.between(-2.048e9, 2.048e9) as i32][self.word() as usize % 4]);
        let local = [self.number((-4096.0, 4096.0)), self.number((-12000.0, 12000.0)), self.number((-4096.0, 4096.0))];
        Place { origin, local, ddx, ddy }
    }
}

/// Values for a port at every point; a texture port is three arguments.
fn arguments(random: &mut Random, port: &Port) -> Vec<Value<F32>> {
    match &port.ty {
        Type::Texture => vec![Value::handle(0), Value::handle(0), Value::i32(&[0])],
        _ => vec![argument(random, port)],
    }
}

fn argument(random: &mut Random, port: &Port) -> Value<F32> {
    let range = port.range.unwrap_or((0.0, 65535.0));
    let mut numbers = || (0..POINTS).map(|_| random.number(range)).collect::<Vec<f32>>();
    match &port.ty {
        Type::I32 => Value::i32(&numbers().iter().map(|number| *number as i32).collect::<Vec<_>>()),
        Type::U32 => Value::u32(&numbers().iter().map(|number| *number as u32).collect::<Vec<_>>()),
        Type::Struct(name) if name == "Place" => place(&(0..POINTS).map(|_| random.place()).collect::<Vec<_>>()),
        Type::Struct(name) if name == "Coord" => {
            let ranges = [(-64.0, 64.0), (-64.0, 64.0), (-2.0, 2.0), (-2.0, 2.0), (-2.0, 2.0), (-2.0, 2.0)];
            let mut part = |range| Value::f32(&(0..POINTS).map(|_| random.number(range)).collect::<Vec<_>>());
            Value::join(ranges.map(&mut part))
        }
        Type::Struct(name) => panic!("no values for a port of type {name}"),
        floats => Value::join((0..floats.components().unwrap_or(1)).map(|_| Value::f32(&numbers()))),
    }
}

/// Overwrites the first points with the corners of the ports' ranges, as far as there is room.
fn corners(arguments: &mut [Vec<Value<F32>>], inputs: &[Port]) {
    let mut bit = 0;
    for (values, port) in arguments.iter_mut().zip(inputs) {
        let (Some((low, high)), true) = (port.range, port.ty.components().is_some()) else { continue };
        for component in values.iter_mut().flat_map(|value| &mut value.components) {
            let Component::Float(numbers) = component else { continue };
            for (point, number) in numbers.iter_mut().enumerate().take(1 << CORNER_BITS) {
                *number = if point >> (bit % CORNER_BITS) & 1 == 0 { low } else { high };
            }
            bit += 1;
        }
    }
}

/// Behind the corners: for each port a point where all of it is 0, as near as its range allows; vectors without a direction.
fn zeros(arguments: &mut [Vec<Value<F32>>], inputs: &[Port]) {
    for (index, (values, port)) in arguments.iter_mut().zip(inputs).enumerate() {
        let Some((low, high)) = port.range else { continue };
        for component in values.iter_mut().flat_map(|value| &mut value.components) {
            if let Component::Float(numbers) = component {
                numbers[(1 << CORNER_BITS) + index] = 0.0_f32.clamp(low, high);
            }
        }
    }
}

/// The declared range of every float of a result.
pub(super) fn output_ranges(overload: &Overload) -> Vec<Option<(f32, f32)>> {
    let of = |port: &Port| vec![port.range; port.ty.components().unwrap_or(0)];
    match &overload.output.ty {
        Type::Struct(_) => overload.members.iter().flat_map(of).collect(),
        _ => of(&overload.output),
    }
}

/// Arguments for a node at [`POINTS`] points: random, with all corners first.
pub(super) fn inputs(overload: &Overload) -> Vec<Value<F32>> {
    let seed = overload.function.bytes().fold(1, |seed: u64, byte| seed.wrapping_mul(31) + u64::from(byte));
    let mut random = Random(seed);
    let mut values: Vec<Vec<Value<F32>>> = overload.inputs.iter().map(|port| arguments(&mut random, port)).collect();
    corners(&mut values, &overload.inputs);
    zeros(&mut values, &overload.inputs);
    values.concat()
}

fn check(overload: &Overload) -> Vec<String> {
    let values = inputs(overload);
    take_hazard();
    let watched: Vec<Value<Watched>> = values.iter().map(Value::to).collect();
    let (result, _) = match machine().call(&overload.function, &watched, POINTS) {
        Ok(result) => result,
        Err(error) => return vec![format!("{}: {error}", overload.function)],
    };
    let ranges = output_ranges(overload);
    let fits = |(number, range): (&f32, &Option<(f32, f32)>)| {
        number.is_finite() && range.is_none_or(|(low, high)| *number >= low && *number <= high)
    };
    let results = floats(&result, POINTS).into_iter().enumerate();
    let bad = results.filter(|(_, components)| !components.iter().zip(&ranges).all(fits));
    let bad = bad.take(2).map(|(point, components)| witness(overload, &values, point, &components));
    let undefined = take_hazard().map(|operation| format!("{}: WGSL leaves {operation} undefined", overload.function));
    bad.chain(undefined).collect()
}

/// Where a result is wrong, with the arguments and the declared range.
pub(super) fn witness(overload: &Overload, values: &[Value<F32>], point: usize, components: &[f32]) -> String {
    let mut values = values.iter();
    let shown = overload.inputs.iter().map(|port| {
        // A texture port is three arguments, and the same one everywhere.
        let value = values.nth(if port.ty == Type::Texture { 2 } else { 0 });
        value.map_or_else(String::new, |value| show(port, value, point))
    });
    let shown = shown.collect::<Vec<_>>().join(", ");
    format!("{}({shown}) is {components:?}, declared {:?}", overload.function, output_ranges(overload))
}

fn show(port: &Port, value: &Value<F32>, point: usize) -> String {
    let part = |index| {
        let float = value.float_at(index, point).map(|number| format!("{number:?}"));
        float.or_else(|| value.int_at(index, point).map(|number| format!("{number:?}"))).unwrap_or_default()
    };
    let parts: Vec<String> = (0..value.components.len()).map(part).collect();
    format!("{}: {}", port.name, parts.join(" "))
}

#[test]
fn results_are_finite_and_inside_the_declared_range() {
    let overloads = LIBRARY.kinds.values().flat_map(|kind| &kind.overloads);
    let found: Vec<String> = overloads.flat_map(check).collect();
    assert!(found.is_empty(), "{} findings:\n{}", found.len(), found.join("\n"));
}
