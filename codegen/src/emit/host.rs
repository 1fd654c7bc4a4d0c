//! The plain WebGPU host: bindings, and the glue between a renderer's frame and the core.

use super::core::{body, declarations, frame, header, parameters, resources};
use super::text::Shader;
use crate::library::Library;
use crate::patch::Specialization;
use crate::program::Program;

/// Bind group of everything that belongs to the material.
pub const MATERIAL_GROUP: u32 = 1;

/// The core together with a host's own text, which calls `terrane_shade(frame: HostFrame) -> TerrainOut` and declares
/// `HostFrame` with every frame field.
pub fn host(library: &Library, program: &Program, patch: &Specialization, host: &str) -> Shader {
    let body = body(library, program, patch);
    let mut shader = header(program, patch);
    declarations(&mut shader, library, &library.closure(&format!("{}{host}", body.text)));
    shader.append(body);
    shader.line("");
    glue(&mut shader, program, patch);
    shader.line("");
    shader.text.push_str(host);
    shader
}

/// The layout is the whole terrain's; a shader declares what it reads of it.
fn glue(shader: &mut Shader, program: &Program, patch: &Specialization) {
    let (arrays, samplers) = resources(program, patch);
    let fields: Vec<String> = frame(program, patch).iter().map(|field| format!("frame.{}", field.name())).collect();
    let mut arguments = vec![format!("TerrainIn({})", fields.join(", "))];
    if !parameters(program, patch).is_empty() {
        binding(shader, 0, "var<uniform> terrane_parameters: TerrainParameters");
        arguments.push("terrane_parameters".into());
    }
    for array in arrays {
        let name = format!("terrane_{}", program.arrays[array].name());
        binding(shader, array_binding(array), &format!("var {name}: texture_2d_array<f32>"));
        arguments.push(name);
    }
    for sampler in samplers {
        let name = format!("terrane_{}", program.samplers[sampler].name());
        binding(shader, sampler_binding(program, sampler), &format!("var {name}: sampler"));
        arguments.push(name);
    }
    shader.line("");
    shader.line("/// The core with its resources.");
    shader.open("fn terrane_shade(frame: HostFrame) -> TerrainOut");
    shader.line(&format!("return terrane_surface({});", arguments.join(", ")));
    shader.close();
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
