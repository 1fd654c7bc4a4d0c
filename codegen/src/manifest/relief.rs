//! The displaced surface in a manifest.

use terrane_shaderlib::relief::Bounds;

use super::{ReliefArrayInfo, ReliefInfo, ReliefSourceInfo, TextureInfo};
use crate::emit::{MATERIAL_GROUP, relief_arguments, relief_binding};
use crate::patch::Specialization;
use crate::program::{Program, ProgramRelief, ReliefArray, ReliefMap};

/// What a host must know of the displaced surface, if a visible layer has one.
pub(super) fn relief(program: &Program, patch: &Specialization) -> Option<ReliefInfo> {
    let (relief, part) = program.relief.as_ref().zip(patch.relief.as_ref())?;
    let layers = patch.layers.iter().filter_map(|layer| program.layers[*layer].relief);
    Some(ReliefInfo {
        method: relief.trace.method.search().to_string(),
        arguments: relief_arguments(program, relief, part).names().map(str::to_owned).collect(),
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
    let texture = |part: usize, what: &str, format: &str, size: [u32; 2], mip_levels: u32| TextureInfo {
        name: [array.heights(), array.bounds()][part].clone(),
        group: MATERIAL_GROUP,
        binding: relief_binding(program, 2 * index + part) as u32,
        format: format.into(),
        dimension: "2d-array".into(),
        sample_type: "uint".into(),
        width: size[0],
        height: size[1],
        mip_levels,
        layers: files(program, array, what),
    };
    let source = |map: &ReliefMap| ReliefSourceInfo { file: map.file.clone(), channel: map.channel };
    ReliefArrayInfo {
        heights: texture(0, "heights", "r16uint", [width, height], mips),
        bounds: texture(1, "bounds", format, size, levels),
        sources: array.maps.iter().map(source).collect(),
    }
}

/// Files of texels beside the manifest, one for each layer.
fn files(program: &Program, array: &ReliefArray, what: &str) -> Vec<String> {
    let (width, height) = array.size;
    let name = |map: &ReliefMap| {
        let stem = map.file.trim_end_matches(".png").replace('/', "_");
        format!("{}.{stem}_{}_{width}x{height}.{what}.bin", program.name, map.channel)
    };
    array.maps.iter().map(name).collect()
}
