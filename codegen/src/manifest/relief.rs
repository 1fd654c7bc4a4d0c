//! The displaced surface in a manifest.

use terrane_shaderlib::relief::MapTexture;

use super::{ReliefArrayInfo, ReliefInfo, ReliefSourceInfo, TextureInfo};
use crate::emit::{MATERIAL_GROUP, relief_arguments, relief_binding};
use crate::patch::Specialization;
use crate::program::{Program, ProgramRelief, ReliefArray, ReliefMap};

/// What a host must know of the displaced surface, if a visible layer has one.
pub(super) fn relief(program: &Program, patch: &Specialization) -> Option<ReliefInfo> {
    let (relief, part) = program.relief.as_ref().zip(patch.relief.as_ref())?;
    let layers = patch.layers.iter().filter_map(|layer| program.layers[*layer].relief);
    Some(ReliefInfo {
        method: relief.method.to_string(),
        arguments: relief_arguments(program, part).names().map(str::to_owned).collect(),
        fade: [relief.trace.fade.0, relief.trace.fade.1],
        deepest: layers.map(|layer| layer.depth).fold(0.0, f32::max),
        arrays: (0..relief.arrays.len()).map(|index| array(program, relief, index)).collect(),
    })
}

fn array(program: &Program, relief: &ProgramRelief, index: usize) -> ReliefArrayInfo {
    let array = &relief.arrays[index];
    let size = [array.size.0, array.size.1];
    let textures = relief.textures();
    let texture = |(part, texture): (usize, &MapTexture)| TextureInfo {
        name: array.name(*texture),
        group: MATERIAL_GROUP,
        binding: relief_binding(program, textures.len() * index + part) as u32,
        format: texture.format().into(),
        dimension: "2d-array".into(),
        sample_type: "uint".into(),
        access: texture.is_storage().then(|| "read-only".into()),
        width: texture.size(size)[0],
        height: texture.size(size)[1],
        mip_levels: texture.mips(size),
        layers: files(program, array, texture.name()),
    };
    let source = |map: &ReliefMap| ReliefSourceInfo { file: map.file.clone(), channel: map.channel };
    ReliefArrayInfo {
        size,
        textures: textures.iter().enumerate().map(texture).collect(),
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
