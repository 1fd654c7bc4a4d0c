//! The plain WebGPU host: bindings, and the glue between a renderer's frame and the core.

use super::arguments::arguments;
use super::core::{body, declarations, frame, header, parameters, resources};
use super::relief::{relief_arguments, relief_member};
use super::text::Shader;
use crate::graph::model::ReliefShadow;
use crate::library::Library;
use crate::patch::{ReliefPart, Specialization};
use crate::program::Program;

/// Bind group of everything that belongs to the material.
pub const MATERIAL_GROUP: u32 = 1;

/// The core together with a host's own text, which calls `terrane_shade(frame: HostFrame) -> TerrainOut` and declares
/// `HostFrame` with every frame field.
pub fn host(library: &Library, program: &Program, patch: &Specialization, host: &str) -> Shader {
    let body = body(library, program, patch);
    let mut joint = Shader::default();
    glue(&mut joint, program, patch);
    let mut shader = header(program, patch);
    declarations(&mut shader, library, &library.closure(&format!("{}{}{host}", body.text, joint.text)));
    shader.append(body);
    shader.line("");
    shader.append(joint);
    shader.line("");
    shader.text.push_str(host);
    shader
}

/// The layout is the whole terrain's; a shader declares what it reads of it.
fn glue(shader: &mut Shader, program: &Program, patch: &Specialization) {
    let (arrays, samplers) = resources(program, &patch.live);
    if !parameters(program, &patch.live).is_empty() {
        binding(shader, 0, "var<uniform> terrane_parameters: TerrainParameters");
    }
    for array in arrays {
        let name = program.arrays[array].name();
        binding(shader, array_binding(array), &format!("var terrane_{name}: texture_2d_array<f32>"));
    }
    for sampler in samplers {
        let name = program.samplers[sampler].name();
        binding(shader, sampler_binding(program, sampler), &format!("var terrane_{name}: sampler"));
    }
    let relief = program.relief.iter().filter(|_| patch.relief.is_some()).flat_map(super::relief::textures);
    for (index, (name, ty)) in relief.enumerate() {
        binding(shader, relief_binding(program, index), &format!("var terrane_{name}: {ty}"));
    }
    shade(shader, program, patch);
    if let Some(part) = &patch.relief {
        ground(shader, program, patch, part);
    }
}

/// The frame as a function of the core takes it.
fn terrain(program: &Program, patch: &Specialization) -> String {
    let fields: Vec<String> = frame(program, patch).iter().map(|field| format!("frame.{}", field.name())).collect();
    format!("TerrainIn({})", fields.join(", "))
}

fn shade(shader: &mut Shader, program: &Program, patch: &Specialization) {
    let given = arguments(program, &patch.live, &[]);
    let rest = given.names().skip(1).map(|name| format!("terrane_{name}"));
    let all: Vec<String> = std::iter::once(terrain(program, patch)).chain(rest).collect();
    shader.line("");
    shader.line("/// The core with its resources.");
    shader.open("fn terrane_shade(frame: HostFrame) -> TerrainOut");
    shader.line(&format!("return terrane_surface({});", all.join(", ")));
    shader.close();
}

/// The displaced ground with its resources.
fn ground(shader: &mut Shader, program: &Program, patch: &Specialization, part: &ReliefPart) {
    let Some(relief) = &program.relief else { return };
    let given = relief_arguments(program, part);
    let value = |(index, name): (usize, &str)| match index {
        0 => terrain(program, patch),
        // The ground's axes and the width of a pixel come from the host.
        1..=3 => name.to_owned(),
        _ => format!("terrane_{name}"),
    };
    let all: Vec<String> = given.names().enumerate().map(value).collect();
    let textures: Vec<String> =
        super::relief::textures(relief).iter().map(|(name, _)| format!("terrane_{name}")).collect();
    let textures = textures.join(", ");
    let (no_shadow, no_occlusion) = (relief.trace.shadow == ReliefShadow::Off, relief.trace.occlusion == 0);
    let unless = |off: bool, call: &str| if off { "1.0f".to_owned() } else { format!("{call}, {textures})") };
    let functions = [
        (
            "ground(frame: HostFrame, tangent: vec3f, bitangent: vec3f, pixel: f32) -> TerrainRelief",
            format!("terrane_relief({})", all.join(", ")),
        ),
        (
            "trace(relief: TerrainRelief, ray: DisplacedRay) -> DisplacedHit",
            format!("terrane_displace(ray, relief, {textures})"),
        ),
        (
            "sunlit(relief: TerrainRelief, ray: DisplacedRay, radius: f32) -> f32",
            unless(no_shadow, "terrane_relief_shadow(ray, radius, relief"),
        ),
        ("texels(relief: TerrainRelief) -> f32", texels(patch, program)),
        (
            "open(relief: TerrainRelief, point: vec3f, normal: vec3f, turn: f32) -> f32",
            unless(no_occlusion, "terrane_relief_occlusion(point, normal, turn, relief"),
        ),
    ];
    for (head, value) in functions {
        shader.line("");
        shader.open(&format!("fn terrane_{head}"));
        shader.line(&format!("return {value};"));
        shader.close();
    }
}

/// log2 of the texels in a metre, of the finest map that is there.
fn texels(patch: &Specialization, program: &Program) -> String {
    let names = patch.layers.iter().map(|layer| &program.layers[*layer]).filter(|layer| layer.relief.is_some());
    let all = names.map(|layer| format!("displaced_texels(relief.{})", relief_member(&layer.name)));
    all.reduce(|all, one| format!("max({all}, {one})")).unwrap_or_default()
}

fn binding(shader: &mut Shader, binding: usize, declaration: &str) {
    shader.line(&format!("@group({MATERIAL_GROUP}) @binding({binding}) {declaration};"));
}

/// Binding 0 is the uniform block; arrays follow.
pub(crate) fn array_binding(array: usize) -> usize {
    1 + array
}

/// Samplers follow the arrays.
pub(crate) fn sampler_binding(program: &Program, sampler: usize) -> usize {
    1 + program.arrays.len() + sampler
}

/// Height maps follow the samplers, in the order of [`ProgramRelief::maps`](crate::program::ProgramRelief::maps).
pub(crate) fn relief_binding(program: &Program, texture: usize) -> usize {
    sampler_binding(program, program.samplers.len()) + texture
}
