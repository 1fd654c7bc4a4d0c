//! Compute shaders that call a node.

use std::fmt::Write as _;

use terrane_codegen::library::{Overload, Port};
use terrane_codegen::machine::{Component, Value};
use terrane_codegen::value::Type;

use super::super::LIBRARY;
use super::super::watched::Watched;

const BINDINGS: &str = "
@group(0) @binding(0) var<storage, read> probe_words: array<u32>;
@group(0) @binding(1) var<storage, read_write> probe_results: array<f32>;
@group(0) @binding(2) var example_texture: texture_2d_array<f32>;
@group(0) @binding(3) var example_sampler: sampler;

fn probe_f32(at: u32) -> f32 { return bitcast<f32>(probe_words[at]); }
fn probe_i32(at: u32) -> i32 { return bitcast<i32>(probe_words[at]); }
fn probe_vec2(at: u32) -> vec2f { return vec2f(probe_f32(at), probe_f32(at + 1u)); }
fn probe_vec3(at: u32) -> vec3f { return vec3f(probe_vec2(at), probe_f32(at + 2u)); }
fn probe_vec4(at: u32) -> vec4f { return vec4f(probe_vec3(at), probe_f32(at + 3u)); }
";

/// The declarations that a text needs, and the text.
fn with_library(text: &str) -> String {
    let closure = LIBRARY.closure(text);
    let items: Vec<&str> = closure.into_iter().map(|item| LIBRARY.slice(item)).collect();
    format!("{}\n{BINDINGS}\n{text}", items.join("\n\n"))
}

/// Writes four floats for each expression, given with its type.
pub(super) fn expressions(expressions: &[(&str, &str)]) -> String {
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
            writeln!(text, "    probe_results[{}] = v{index}[{component}];", 4 * index + component)
                .expect("a String takes any text");
        }
    }
    text.push_str("}\n");
    with_library(&text)
}

/// Calls a node at every point with arguments from the words, and writes the floats of its result.
pub(super) fn calls(overload: &Overload) -> String {
    let mut offset = 0;
    let arguments: Vec<String> = overload.inputs.iter().map(|port| argument(port, &mut offset)).collect();
    let results = results(overload);
    let mut writes = String::new();
    for (index, result) in results.iter().enumerate() {
        writeln!(writes, "    probe_results[{}u * id.x + {index}u] = {result};", results.len())
            .expect("a String takes any text");
    }
    let text = format!(
        "@compute @workgroup_size(64)\nfn probe_main(@builtin(global_invocation_id) id: vec3u) {{\n    \
         if (id.x >= arrayLength(&probe_results) / {}u) {{ return; }}\n    let at = id.x * {offset}u;\n    \
         let result = {}({});\n{writes}}}\n",
        results.len(),
        overload.function,
        arguments.join(", "),
    );
    with_library(&text)
}

fn argument(port: &Port, offset: &mut usize) -> String {
    let at = *offset;
    let (words, text) = match &port.ty {
        Type::Texture => (0, "example_texture, example_sampler, 0i".to_owned()),
        Type::U32 => (1, format!("probe_words[at + {at}u]")),
        Type::I32 => (1, format!("probe_i32(at + {at}u)")),
        Type::F32 => (1, format!("probe_f32(at + {at}u)")),
        Type::Vec2 => (2, format!("probe_vec2(at + {at}u)")),
        Type::Vec3 => (3, format!("probe_vec3(at + {at}u)")),
        Type::Vec4 => (4, format!("probe_vec4(at + {at}u)")),
        Type::Struct(name) if name == "Coord" => {
            let parts = [0, 2, 4].map(|part| format!("probe_vec2(at + {}u)", at + part));
            (6, format!("Coord({})", parts.join(", ")))
        }
        Type::Struct(name) if name == "Place" => {
            let parts = [2, 5, 8].map(|part| format!("probe_vec3(at + {}u)", at + part));
            let origin = format!("vec2i(probe_i32(at + {at}u), probe_i32(at + {}u))", at + 1);
            (11, format!("Place({origin}, {})", parts.join(", ")))
        }
        Type::Struct(name) => panic!("no values for a port of type {name}"),
    };
    *offset += words;
    text
}

/// The floats of a node's result, as expressions.
fn results(overload: &Overload) -> Vec<String> {
    let components = |name: String, ty: &Type| match ty {
        Type::Vec2 | Type::Vec3 | Type::Vec4 => {
            (0..ty.components().unwrap_or(0)).map(|index| format!("{name}[{index}]")).collect()
        }
        _ => vec![name],
    };
    match &overload.output.ty {
        Type::Struct(_) => {
            let members = overload.members.iter();
            members.flat_map(|member| components(format!("result.{}", member.name), &member.ty)).collect()
        }
        Type::U32 | Type::I32 => vec!["f32(result)".to_owned()],
        ty => components("result".to_owned(), ty),
    }
}

/// The arguments as words, point by point.
pub(super) fn words(values: &[Vec<Value<Watched>>], points: usize) -> Vec<u32> {
    let components =
        || values.iter().filter(|values| !is_texture(values)).flatten().flat_map(|value| &value.components);
    let word = |component: &Component<Watched>, point: usize| match component {
        Component::Float(numbers) => numbers[point % numbers.len()].to_bits(),
        Component::Int(bits) => bits[point % bits.len()],
        Component::Truth(_) | Component::Handle(_) => 0,
    };
    (0..points).flat_map(|point| components().map(move |component| word(component, point))).collect()
}

fn is_texture(values: &[Value<Watched>]) -> bool {
    values.iter().any(|value| value.components.iter().any(|component| matches!(component, Component::Handle(_))))
}
