//! The examples in the nodes' documentation are true.

use std::fmt::Write as _;

use naga::valid::{Capabilities, ValidationFlags, Validator};
use terrane_codegen::library::Example;
use terrane_codegen::machine::{F32, Machine, Value};

use super::LIBRARY;
use super::texture::EXAMPLE;

const TEXTURES: &str = "@group(0) @binding(0) var example_texture: texture_2d_array<f32>;\n\
                        @group(0) @binding(1) var example_sampler: sampler;\n";

/// The type of an example: said by how its expected value is written.
pub(super) fn ty(expected: &str) -> &str {
    ["vec2f", "vec3f", "vec4f"]
        .into_iter()
        .find(|ty| expected.starts_with(&format!("{ty}(")))
        .or_else(|| expected.ends_with('u').then_some("u32"))
        .or_else(|| expected.ends_with('i').then_some("i32"))
        .unwrap_or("f32")
}

fn components(value: &Value<F32>) -> Vec<f64> {
    let count = value.components.len();
    let integer = |index| value.int_at(index, 0).map(f64::from);
    (0..count).filter_map(|index| value.float_at(index, 0).map(f64::from).or_else(|| integer(index))).collect()
}

#[test]
fn every_example_holds() {
    let examples: Vec<&Example> = LIBRARY.kinds.values().flat_map(|kind| &kind.examples).collect();
    let mut text = format!("{}{TEXTURES}", LIBRARY.text);
    for (index, example) in examples.iter().enumerate() {
        let (ty, call, expected) = (ty(&example.expected), &example.call, &example.expected);
        writeln!(text, "fn example_{index}() -> {ty} {{ return {call}; }}").expect("a String takes any text");
        writeln!(text, "fn expected_{index}() -> {ty} {{ return {expected}; }}").expect("a String takes any text");
    }
    let module = naga::front::wgsl::parse_str(&text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
    let info = Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
    let machine = Machine::new(&module, &info, &*EXAMPLE);
    let value = |function: String| {
        let called = machine.call::<F32>(&function, &[], 1);
        called.map(|(value, _)| components(&value)).unwrap_or_else(|error| panic!("{function}: {error}"))
    };
    let mut wrong = Vec::new();
    for (index, example) in examples.iter().enumerate() {
        let (found, expected) = (value(format!("example_{index}")), value(format!("expected_{index}")));
        // A tolerance of 0 means the bits; others leave room for the rounding of the expected literal itself.
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= example.tolerance * 1.0001;
        if !found.iter().zip(&expected).all(near) || found.len() != expected.len() {
            wrong.push(format!("{} is {found:?}, not {expected:?} +- {}", example.call, example.tolerance));
        }
    }
    assert!(wrong.is_empty(), "{} of {} examples:\n{}", wrong.len(), examples.len(), wrong.join("\n"));
}
