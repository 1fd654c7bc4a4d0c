//! Calling the library's functions on the machine.

use terrane_codegen::machine::{Component, Domain, F32, Machine, Value};

use super::LIBRARY;
use super::texture::EXAMPLE;

/// The library on the machine, with the example texture.
pub(super) fn machine() -> Machine<'static> {
    Machine::new(&LIBRARY.module, &LIBRARY.info, &*EXAMPLE)
}

/// A place in all its parts.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    pub(super) origin: [i32; 2],
    pub(super) local: [f32; 3],
    pub(super) ddx: [f32; 3],
    pub(super) ddy: [f32; 3],
}

impl Place {
    /// Patch corner in 1/256 m, metres east and south of it.
    pub(super) fn new(origin: [i32; 2], x: f32, z: f32) -> Self {
        Self { origin, local: [x, 0.0, z], ..Self::default() }
    }
}

/// The argument for a `Place`.
pub(super) fn place<D: Domain>(places: &[Place]) -> Value<D> {
    let vector = |part: fn(&Place) -> [f32; 3]| Value::vector(&places.iter().map(part).collect::<Vec<_>>());
    Value::join([
        Value::integers(&places.iter().map(|place| place.origin).collect::<Vec<_>>()),
        vector(|place| place.local),
        vector(|place| place.ddx),
        vector(|place| place.ddy),
    ])
}

/// The floats of a result: one list of components for each point.
pub(super) fn floats<D: Domain<Float = f32>>(value: &Value<D>, points: usize) -> Vec<Vec<f32>> {
    let components: Vec<usize> = float_components(value);
    let at = |point: usize| components.iter().map(|component| float(value, *component, point)).collect();
    (0..points).map(at).collect()
}

fn float_components<D: Domain>(value: &Value<D>) -> Vec<usize> {
    let is_float = |index: &usize| matches!(value.components[*index], Component::Float(_));
    (0..value.components.len()).filter(is_float).collect()
}

fn float<D: Domain<Float = f32>>(value: &Value<D>, component: usize, point: usize) -> f32 {
    value.float_at(component, point).expect("the component is a float")
}

/// A function of one place and further arguments that are the same everywhere: its first float at each place.
pub(super) fn at_places(function: &str, places: &[Place], rest: &[Value<F32>]) -> Vec<f32> {
    all_at_places(function, places, rest).into_iter().map(|floats| floats[0]).collect()
}

/// As [`at_places`], with every float of the result.
pub(super) fn all_at_places(function: &str, places: &[Place], rest: &[Value<F32>]) -> Vec<Vec<f32>> {
    let arguments: Vec<Value<F32>> = [place(places)].into_iter().chain(rest.iter().cloned()).collect();
    let called = machine().call(function, &arguments, places.len());
    let (value, _) = called.unwrap_or_else(|error| panic!("{function}: {error}"));
    floats(&value, places.len())
}
