//! From a checked shader to its manifest.

use naga::TypeInner;
use sha2::{Digest, Sha256};

use super::relief::relief;
use super::{
    FileInfo, InputInfo, LayerInfo, LimitsInfo, Manifest, ParameterInfo, PermutationInfo, SamplerInfo, SourceLine,
    TerrainInfo, TextureInfo, UniformInfo, VERSION,
};
use crate::check::Checked;
use crate::diagnostic::Sources;
use crate::emit::{MATERIAL_GROUP, Place, Shader, array_binding, frame, sampler_binding};
use crate::graph::model::{Blend, Filter, FrameField, Terrain, Wrap};
use crate::library::costs;
use crate::patch::Specialization;
use crate::program::Program;

/// What one permutation consists of.
pub struct Parts<'a> {
    /// All materials.
    pub program: &'a Program,
    /// What was emitted of them.
    pub patch: &'a Specialization,
    /// The core.
    pub core: &'a Shader,
    /// The host shader.
    pub host: &'a Shader,
    /// The host shader as naga sees it.
    pub checked: &'a Checked,
    /// The terrain, where there is one.
    pub terrain: Option<&'a Terrain>,
}

/// The manifest of a terrain or surface with one permutation.
pub fn manifest(parts: &Parts<'_>, sources: &Sources) -> Manifest {
    let program = parts.program;
    let parameters = uniform(parts);
    let arguments = std::iter::once("terrain".to_owned())
        .chain(parameters.iter().map(|_| "parameters".to_owned()))
        .chain(program.arrays.iter().map(|array| array.name()))
        .chain(program.samplers.iter().map(|sampler| sampler.name()));
    Manifest {
        version: VERSION,
        generator: concat!("terrane ", env!("CARGO_PKG_VERSION")).into(),
        name: program.name.clone(),
        terrain: parts.terrain.map(terrain),
        layers: program
            .layers
            .iter()
            .map(|layer| LayerInfo { name: layer.name.clone(), surface: layer.path.clone(), doc: layer.doc.clone() })
            .collect(),
        arguments: arguments.collect(),
        inputs: inputs(parts),
        limits: limits(program, parameters.as_ref()),
        parameters,
        textures: textures(program),
        samplers: samplers(program),
        relief: relief(program, parts.patch),
        permutations: vec![permutation(parts, sources)],
    }
}

/// The JSON schema of the manifest.
pub fn schema() -> String {
    let schema = schemars::schema_for!(Manifest);
    // A schema is plain data: serialising it cannot fail.
    serde_json::to_string_pretty(&schema).unwrap_or_default() + "\n"
}

impl Manifest {
    /// The manifest as JSON text.
    pub fn to_json(&self) -> String {
        // Plain data with string keys: serialising it cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}

fn terrain(terrain: &Terrain) -> TerrainInfo {
    let height = &terrain.height;
    TerrainInfo {
        height_map: height.file.clone(),
        texels: [height.texels.0, height.texels.1],
        size: [height.size.0, height.size.1],
        range: [height.range.0, height.range.1],
        patch: terrain.patch,
        blend: match terrain.blend {
            Blend::Over => "over",
            Blend::HeightMax => "height_max",
            Blend::HeightSoft { .. } => "height_soft",
        }
        .into(),
    }
}

fn inputs(parts: &Parts<'_>) -> Vec<InputInfo> {
    let unit =
        |field: FrameField| FrameField::ALL.iter().find(|(known, ..)| *known == field).and_then(|(.., unit)| *unit);
    let info = |field: FrameField| InputInfo {
        name: field.name().into(),
        ty: field.ty().wgsl().into(),
        unit: unit(field).map(str::to_owned),
    };
    frame(parts.program, parts.patch).into_iter().map(info).collect()
}

/// Offsets are naga's own: what the driver will use.
fn uniform(parts: &Parts<'_>) -> Option<UniformInfo> {
    let module = &parts.checked.module;
    let (_, ty) = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some("TerrainParameters"))?;
    let TypeInner::Struct { members, span } = &ty.inner else { return None };
    let known = |name: &str| parts.program.parameters.iter().find(|parameter| parameter.name == name);
    let members = members.iter().filter_map(|member| {
        let parameter = known(member.name.as_deref()?)?;
        Some(ParameterInfo {
            name: parameter.name.clone(),
            ty: parameter.ty.wgsl().into(),
            offset: member.offset,
            default: parameter.default.values(),
            range: parameter.range.map(|(low, high)| [low, high]),
            unit: parameter.unit.clone(),
            color: parameter.color,
            doc: parameter.doc.clone(),
        })
    });
    Some(UniformInfo { group: MATERIAL_GROUP, binding: 0, size: *span, members: members.collect() })
}

fn textures(program: &Program) -> Vec<TextureInfo> {
    let info = |(index, array): (usize, &crate::program::TextureArray)| TextureInfo {
        name: array.name(),
        group: MATERIAL_GROUP,
        binding: array_binding(index) as u32,
        format: array.format.webgpu().into(),
        dimension: "2d-array".into(),
        sample_type: "float".into(),
        access: None,
        width: array.size.0,
        height: array.size.1,
        mip_levels: array.size.0.max(array.size.1).max(1).ilog2() + 1,
        layers: array.files.clone(),
    };
    program.arrays.iter().enumerate().map(info).collect()
}

fn samplers(program: &Program) -> Vec<SamplerInfo> {
    let info = |(index, key): (usize, &crate::program::SamplerKey)| SamplerInfo {
        name: key.name(),
        group: MATERIAL_GROUP,
        binding: sampler_binding(program, index) as u32,
        address_mode: match key.wrap {
            Wrap::Repeat => "repeat",
            Wrap::Clamp => "clamp-to-edge",
            Wrap::Mirror => "mirror-repeat",
        }
        .into(),
        filter: match key.filter {
            Filter::Linear => "linear",
            Filter::Nearest => "nearest",
        }
        .into(),
        max_anisotropy: u16::from(key.anisotropy),
    };
    program.samplers.iter().enumerate().map(info).collect()
}

fn limits(program: &Program, uniform: Option<&UniformInfo>) -> LimitsInfo {
    let layers = program.arrays.iter().map(|array| array.files.len());
    let maps = program.relief.iter().flat_map(|relief| &relief.arrays).map(|array| array.maps.len());
    LimitsInfo {
        sampled_textures: (program.arrays.len() + program.maps(false).count()) as u32,
        storage_textures: program.maps(true).count() as u32,
        samplers: program.samplers.len() as u32,
        uniform_bytes: uniform.map_or(0, |uniform| uniform.size),
        texture_array_layers: layers.chain(maps).max().unwrap_or(0) as u32,
    }
}

fn permutation(parts: &Parts<'_>, sources: &Sources) -> PermutationInfo {
    let program = parts.program;
    let values = parts.patch.live.iter().filter(|id| !program.pool.get(**id).is_inline()).count();
    PermutationInfo {
        layers: parts.patch.layers.iter().map(|layer| program.layers[*layer].name.clone()).collect(),
        core: file(format!("{}.core.wgsl", program.name), parts.core),
        host: file(format!("{}.wgsl", program.name), parts.host),
        patches: "all".into(),
        cost: costs(&parts.checked.module).get("terrane_surface").copied().unwrap_or_default(),
        nodes: program.pool.counts().0 as u32,
        values: values as u32,
        source_map: source_map(parts, sources),
    }
}

fn file(path: String, shader: &Shader) -> FileInfo {
    let digest = Sha256::digest(shader.text.as_bytes());
    FileInfo { path, sha256: digest.iter().map(|byte| format!("{byte:02x}")).collect() }
}

fn source_map(parts: &Parts<'_>, sources: &Sources) -> Vec<SourceLine> {
    let line_of = |byte: usize| parts.core.text[..byte].matches('\n').count() as u32 + 1;
    let lines = parts.core.map.iter().filter_map(|(range, place)| {
        let Place::Value(id) = place else { return None };
        let origin = parts.program.pool.origins(*id).first()?;
        let (file_line, _) = sources.position(origin.span.source, origin.span.start as usize);
        let file = sources.get(origin.span.source).path.clone();
        Some(SourceLine { line: line_of(range.start), node: origin.path.clone(), file, file_line: file_line as u32 })
    });
    lines.collect()
}
