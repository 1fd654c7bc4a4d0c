//! The displaced surface in a manifest.

use terrane_shaderlib::relief::Bounds;

use super::{ReliefArrayInfo, ReliefInfo, ReliefLayerInfo, ReliefTextureInfo};
use crate::emit::{MATERIAL_GROUP, arguments, relief_binding};
use crate::patch::Specialization;
use crate::program::{Program, ProgramRelief, ReliefArray, ReliefMap};

/// What a host must know of the displaced surface, if a visible layer has one.
pub(super) fn relief(program: &Program, patch: &Specialization) -> Option<ReliefInfo> {
    let (relief, part) = program.relief.as_ref().zip(patch.relief.as_ref())?;
    let before = ["tangent: vec3f", "bitangent: vec3f", "pixel: f32"];
    let behind: Vec<String> = relief.arrays.iter().map(|array| format!("{}: heights", array.heights())).collect();
    let layers = patch.layers.iter().filter_map(|layer| program.layers[*layer].relief);
    Some(ReliefInfo {
        method: relief.trace.method.search().to_string(),
        arguments: arguments(program, &part.live(), &before, &behind).names().map(str::to_owned).collect(),
        fade: [relief.trace.fade.0, relief.trace.fade.1],
        deepest: layers.map(|layer| layer.depth).fold(0.0, f32::max),
        arrays: (0..relief.arrays.len()).map(|index| array(program, relief, index)).collect(),
    })
}

fn array(program: &Program, relief: &ProgramRelief, index: usize) -> ReliefArrayInfo {
    let array = &relief.arrays[index];
    let (width, height) = array.size;
    let mips = width.min(height).max(1).ilog2() + 1;
    let (format, size, levels) = match relief.trace.method.search().bounds() {
        Bounds::None => ("r16uint", [1, 1], 1),
        Bounds::Cones(_) => ("rg16uint", [width, height], mips),
        _ => ("r16uint", [width, 2 * height], 1),
    };
    let texture = |name: String, part: usize, format: &str, size: [u32; 2], mip_levels: u32| ReliefTextureInfo {
        name,
        group: MATERIAL_GROUP,
        binding: relief_binding(program, 2 * index + part) as u32,
        format: format.into(),
        dimension: "2d-array".into(),
        sample_type: "uint".into(),
        width: size[0],
        height: size[1],
        mip_levels,
    };
    ReliefArrayInfo {
        heights: texture(array.heights(), 0, "r16uint", [width, height], mips),
        bounds: texture(array.bounds(), 1, format, size, levels),
        layers: array.maps.iter().map(|map| layer(program, array, map)).collect(),
    }
}

fn layer(program: &Program, array: &ReliefArray, map: &ReliefMap) -> ReliefLayerInfo {
    let stem = map.file.trim_end_matches(".png").replace('/', "_");
    let (width, height) = array.size;
    let path = |what: &str| format!("{}.{stem}_{}_{width}x{height}.{what}.bin", program.name, map.channel);
    ReliefLayerInfo { file: map.file.clone(), channel: map.channel, heights: path("heights"), bounds: path("bounds") }
}
