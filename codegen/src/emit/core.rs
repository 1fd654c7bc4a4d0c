//! The core: pure functions and a few structs, no entry points, no globals.

use std::collections::BTreeSet;

use super::VISIBLE;
use super::arguments::arguments;
use super::compose::Composer;
use super::names::Names;
use super::relief::relief;
use super::text::{Place, Shader};
use crate::graph::model::FrameField;
use crate::library::Library;
use crate::patch::Specialization;
use crate::program::{Op, Program, ValueId};
use crate::value::Literal;

/// The core of a specialised shader: the library functions that it needs, and `terrane_surface`.
pub fn core(library: &Library, program: &Program, patch: &Specialization) -> Shader {
    let body = body(library, program, patch);
    let mut shader = header(program, patch);
    declarations(&mut shader, library, &library.closure(&body.text));
    shader.append(body);
    shader
}

/// What stands on top of every emitted file.
pub(super) fn header(program: &Program, patch: &Specialization) -> Shader {
    let mut shader = Shader::default();
    shader.line(&format!("// {}: made by Terrane from the graphs. Change those, not this file.", program.name));
    shader.line("//");
    shader.line("// Layers, top to bottom:");
    for layer in patch.layers.iter().rev().map(|layer| &program.layers[*layer]) {
        let doc = layer.doc.lines().collect::<Vec<_>>().join(" ");
        shader.line(&format!("//   {} ({}): {doc}", layer.name, layer.path));
    }
    shader.line("");
    shader
}

/// Library declarations, in the order of the library.
pub(super) fn declarations(shader: &mut Shader, library: &Library, items: &BTreeSet<usize>) {
    for item in items {
        shader.verbatim(Place::Item(*item), library.slice(*item));
    }
}

/// Everything of the core behind the library's functions.
pub(super) fn body(library: &Library, program: &Program, patch: &Specialization) -> Shader {
    let mut shader = body_with(library, program, patch, ("terrane_surface", "TerrainOut"), |shader, names| {
        Composer { program, patch, names, shader }.body();
    });
    relief(&mut shader, library, program, patch);
    shader
}

/// The structs, and a function of a name and result that takes what a surface takes.
pub(super) fn body_with(
    library: &Library,
    program: &Program,
    patch: &Specialization,
    (name, result): (&str, &str),
    write: impl FnOnce(&mut Shader, &Names<'_>),
) -> Shader {
    let mut shader = Shader::default();
    structs(&mut shader, program, patch);
    let names = Names::new(library, program, &patch.live);
    shader.line("/// The look of the ground at one place.");
    let given = arguments(program, &patch.live, &[]);
    shader.open(&format!("fn {name}({}) -> {result}", given.declared()));
    write(&mut shader, &names);
    shader.close();
    shader
}

fn structs(shader: &mut Shader, program: &Program, patch: &Specialization) {
    if patch.layers.len() > 1 && (patch.guard || patch.relief.is_some()) {
        shader.line("/// A layer is skipped where its weight is not above this.");
        shader.line(&format!("const TERRANE_VISIBLE: f32 = {};", Literal::f32(VISIBLE).wgsl()));
        shader.line("");
    }
    shader.line("/// What the host knows of a place.");
    shader.open("struct TerrainIn");
    for field in frame(program, patch) {
        shader.line(&format!("{}: {},", field.name(), field.ty().wgsl()));
    }
    shader.close();
    shader.line("");
    let parameters = parameters(program, &patch.live);
    if !parameters.is_empty() {
        shader.line("/// What may be tweaked while the shader runs.");
        shader.open("struct TerrainParameters");
        for parameter in &program.parameters {
            shader.line(&format!("{}: {},", parameter.name, parameter.ty.wgsl()));
        }
        shader.close();
        shader.line("");
    }
    shader.line("/// What the host is to draw.");
    shader.open("struct TerrainOut");
    for line in TERRAIN_OUT {
        shader.line(line);
    }
    shader.close();
    shader.line("");
}

const TERRAIN_OUT: [&str; 6] = [
    "albedo: vec3f,      // linear Rec. 709",
    "normal: vec3f,      // tangent space: x east, y south, z out of the ground",
    "roughness: f32,     // perceptual",
    "metallic: f32,",
    "occlusion: f32,     // 1 is open",
    "emissive: vec3f,",
];

/// The frame fields in use. A terrain of constants still has a place, since WGSL knows no empty struct.
pub(crate) fn frame(program: &Program, patch: &Specialization) -> Vec<FrameField> {
    // Tracing moves the place, and fades with the distance.
    let traced =
        |field: &FrameField| patch.relief.is_some() && [FrameField::Position, FrameField::Distance].contains(field);
    let used =
        |field: &FrameField| traced(field) || patch.live.iter().any(|id| program.pool.get(*id).op == Op::Frame(*field));
    let fields: Vec<FrameField> = FrameField::ALL.iter().map(|(field, ..)| *field).filter(used).collect();
    if fields.is_empty() { vec![FrameField::Height] } else { fields }
}

/// Positions of the parameters that values read.
pub(crate) fn parameters(program: &Program, live: &BTreeSet<ValueId>) -> BTreeSet<usize> {
    let index = |op: &Op| if let Op::Parameter(index) = op { Some(*index) } else { None };
    live.iter().filter_map(|id| index(&program.pool.get(*id).op)).collect()
}

/// Positions of the arrays and samplers that values read.
pub(crate) fn resources(program: &Program, live: &BTreeSet<ValueId>) -> (BTreeSet<usize>, BTreeSet<usize>) {
    let index = |op: &Op| if let Op::Texture(index) = op { Some(program.textures[*index]) } else { None };
    let textures = live.iter().filter_map(|id| index(&program.pool.get(*id).op));
    textures.map(|texture| (texture.array, texture.sampler)).unzip()
}
