//! The examples in the nodes' documentation are true on the device.

use std::fmt::Write as _;

use terrane_codegen::library::Kind;
use terrane_codegen::machine::Probe;
use terrane_codegen::machine::probe::Resource;

use super::super::LIBRARY;
use super::super::examples::ty;
use super::device::Device;

const BINDINGS: &str = "
@group(0) @binding(1) var<storage, read_write> example_results: array<f32>;
@group(0) @binding(2) var example_texture: texture_2d_array<f32>;
@group(0) @binding(3) var example_sampler: sampler;
";

#[test]
fn examples_hold_on_the_device() {
    let Ok(device) = Device::open().map_err(crate::skip::Skip::report) else { return };
    let wrong: Vec<String> = LIBRARY.kinds.values().flat_map(|kind| wrong(&device, kind)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn wrong(device: &Device, kind: &Kind) -> Vec<String> {
    let examples = &kind.examples;
    let calls: Vec<(&str, &str)> =
        examples.iter().map(|example| (ty(&example.expected), example.call.as_str())).collect();
    let expected: Vec<(&str, &str)> =
        examples.iter().map(|example| (ty(&example.expected), example.expected.as_str())).collect();
    let (found, expected) = (values(device, kind, &calls), values(device, kind, &expected));
    let pairs = examples.iter().zip(found.chunks(4).zip(expected.chunks(4)));
    // Twice the tolerance: it is stated for correctly rounded arithmetic.
    let far = |tolerance: f64| move |(a, b): (&f32, &f32)| f64::from((a - b).abs()) > 2.0 * tolerance;
    pairs
        .filter(|(example, (found, expected))| found.iter().zip(*expected).any(far(example.tolerance)))
        .map(|(example, (found, expected))| format!("{} is {found:?}, not {expected:?}", example.call))
        .collect()
}

/// Four floats for each expression, given with its type.
fn values(device: &Device, kind: &Kind, expressions: &[(&str, &str)]) -> Vec<f32> {
    let probe = Probe {
        function: kind.name.clone(),
        shader: shader(expressions),
        resources: vec![Resource::Texture, Resource::Sampler],
        inputs: 0,
        outputs: expressions.len() * 4,
    };
    device.run(&probe, &[], 1).into_iter().map(f32::from_bits).collect()
}

fn shader(expressions: &[(&str, &str)]) -> String {
    let mut text = String::from("@compute @workgroup_size(1)\nfn probe_main() {\n");
    for (index, (ty, expression)) in expressions.iter().enumerate() {
        let four = match *ty {
            "vec2f" => format!("vec4f({expression}, 0.0, 0.0)"),
            "vec3f" => format!("vec4f({expression}, 0.0)"),
            "vec4f" => (*expression).to_owned(),
            _ => format!("vec4f(f32({expression}), 0.0, 0.0, 0.0)"),
        };
        writeln!(text, "    let v{index} = {four};").expect("a String takes any text");
        for component in 0..4 {
            writeln!(text, "    example_results[{}] = v{index}[{component}];", 4 * index + component)
                .expect("a String takes any text");
        }
    }
    text.push_str("}\n");
    let items: Vec<&str> = LIBRARY.closure(&text).into_iter().map(|item| LIBRARY.slice(item)).collect();
    format!("{}\n{BINDINGS}\n{text}", items.join("\n\n"))
}
