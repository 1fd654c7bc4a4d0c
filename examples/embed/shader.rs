//! One shader of three parts: the generated core, the engine's own half, and the call between them.

use super::manifest::{Input, Manifest};

const ENGINE: &str = include_str!("engine.wgsl");

/// Joins the parts. The bindings are the engine's to choose: here all of them in group 1, in the manifest's order.
pub(crate) fn compose(core: &str, manifest: &Manifest) -> Result<String, String> {
    let fields = manifest.inputs.iter().map(expression).collect::<Result<Vec<_>, _>>()?;
    let call: Vec<String> = manifest
        .arguments
        .iter()
        .map(|argument| match argument.as_str() {
            "terrain" => format!("TerrainIn({})", fields.join(", ")),
            resource => format!("engine_{resource}"),
        })
        .collect();
    let bindings: String = declarations(manifest)
        .into_iter()
        .enumerate()
        .map(|(binding, declaration)| format!("@group(1) @binding({binding}) {declaration};\n"))
        .collect();
    let call = call.join(", ");
    Ok(format!(
        "{core}\n{ENGINE}\n{bindings}\nfn engine_material(ground: EngineGround) -> TerrainOut {{\n    return terrane_surface({call});\n}}\n"
    ))
}

/// The resources of group 1 in the order of their bindings: the uniform block, the textures, the samplers.
fn declarations(manifest: &Manifest) -> Vec<String> {
    let uniform = manifest.parameters.iter().map(|_| "var<uniform> engine_parameters: TerrainParameters".to_owned());
    let textures =
        manifest.textures.iter().map(|texture| format!("var engine_{}: texture_2d_array<f32>", texture.name));
    let samplers = manifest.samplers.iter().map(|sampler| format!("var engine_{}: sampler", sampler.name));
    uniform.chain(textures).chain(samplers).collect()
}

/// Where this engine has what the material asks for.
fn expression(input: &Input) -> Result<&'static str, String> {
    Ok(match input.name.as_str() {
        "position" => "Place(ground.corner, ground.local, ground.local_dx, ground.local_dy)",
        "terrain_uv" => "Coord(ground.uv, ground.uv_dx, ground.uv_dy)",
        "height" => "ground.local.y",
        "slope" => "1.0 - ground.normal.y",
        "normal" => "ground.normal",
        "curvature" => "ground.curvature",
        "distance" => "ground.distance",
        "sun" => "ground.sun",
        unknown => return Err(format!("the material asks for `{unknown}`, which this engine does not know")),
    })
}
