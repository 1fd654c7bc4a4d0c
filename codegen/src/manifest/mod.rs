//! Everything that an engine must know to use an emitted shader, as JSON.

mod build;
mod relief;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use build::{Parts, manifest, schema};

use crate::library::Cost;

/// Raised when a reader of the old form would misread the new one.
pub const VERSION: u32 = 1;

/// The manifest of one terrain or surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Manifest {
    /// Version of this form: 1.
    pub version: u32,
    /// What made it: `terrane 0.1.0`.
    pub generator: String,
    /// Terrain or surface name.
    pub name: String,
    /// The terrain that it was made for; absent for a surface alone.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub terrain: Option<TerrainInfo>,
    /// Layers of the whole terrain, bottom to top.
    pub layers: Vec<LayerInfo>,
    /// Arguments of `terrane_surface`, in order. One bind group layout serves all permutations.
    pub arguments: Vec<String>,
    /// Members of `TerrainIn`, in order: what the host must give.
    pub inputs: Vec<InputInfo>,
    /// The uniform block; absent where nothing can be tweaked.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub parameters: Option<UniformInfo>,
    /// Texture arrays.
    pub textures: Vec<TextureInfo>,
    /// Samplers.
    pub samplers: Vec<SamplerInfo>,
    /// The displaced surface; absent where no layer has one, or the terrain traces none.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub relief: Option<ReliefInfo>,
    /// What the material takes of a device's limits, beside what the host takes.
    pub limits: LimitsInfo,
    /// The shaders, and where each is to be used.
    pub permutations: Vec<PermutationInfo>,
}

/// The terrain's shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TerrainInfo {
    /// Height map: a grey PNG.
    pub height_map: String,
    /// Texels of the height map.
    pub texels: [u32; 2],
    /// Metres on x (east) and z (south).
    pub size: [f32; 2],
    /// Metres at black and at white.
    pub range: [f32; 2],
    /// Side of a patch in metres.
    pub patch: f32,
    /// `over`, `height_max` or `height_soft`.
    pub blend: String,
}

/// A material in place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LayerInfo {
    /// Unique on the terrain.
    pub name: String,
    /// The surface's graph file.
    pub surface: String,
    /// What its author says.
    pub doc: String,
}

/// A member of `TerrainIn`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct InputInfo {
    /// Its name.
    pub name: String,
    /// WGSL type; `Place` and `Coord` are declared in the core.
    #[serde(rename = "type")]
    pub ty: String,
    /// Unit.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub unit: Option<String>,
}

/// The uniform block.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct UniformInfo {
    /// Bind group in the host shader.
    pub group: u32,
    /// Binding in the host shader.
    pub binding: u32,
    /// Bytes of the whole block.
    pub size: u32,
    /// Its members.
    pub members: Vec<ParameterInfo>,
}

/// A member of the uniform block.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ParameterInfo {
    /// `<layer>_<parameter>`.
    pub name: String,
    /// WGSL type.
    #[serde(rename = "type")]
    pub ty: String,
    /// Byte offset in the block.
    pub offset: u32,
    /// Components in order.
    pub default: Vec<f32>,
    /// Inclusive, for every component.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub range: Option<[f32; 2]>,
    /// Unit.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub unit: Option<String>,
    /// Whether it is a linear Rec. 709 colour.
    pub color: bool,
    /// For a user interface.
    pub doc: String,
}

/// A texture array.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TextureInfo {
    /// Argument of the core's functions; the host's variable has `terrane_` before it.
    pub name: String,
    /// Bind group in the host shader.
    pub group: u32,
    /// Binding in the host shader.
    pub binding: u32,
    /// WebGPU texture format.
    pub format: String,
    /// `2d-array`.
    pub dimension: String,
    /// `float`: filterable; `uint` for those of a relief.
    pub sample_type: String,
    /// WebGPU's access to a storage texture, `read-only`, which takes WGSL's `readonly_and_readwrite_storage_textures`; absent
    /// for one that is sampled.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub access: Option<String>,
    /// Texels.
    pub width: u32,
    /// Texels.
    pub height: u32,
    /// Levels of the mip chain: the full one, made by the host, or for a relief those of the file.
    pub mip_levels: u32,
    /// A PNG for each layer; for a relief a file of texels: little-endian, row by row, mip after mip.
    pub layers: Vec<String>,
}

/// A sampler.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SamplerInfo {
    /// Argument of `terrane_surface`; the host's variable has `terrane_` before it.
    pub name: String,
    /// Bind group in the host shader.
    pub group: u32,
    /// Binding in the host shader.
    pub binding: u32,
    /// WebGPU address mode: `repeat`, `clamp-to-edge`, `mirror-repeat`.
    pub address_mode: String,
    /// WebGPU filter mode: `linear`, `nearest`.
    pub filter: String,
    /// 1..16.
    pub max_anisotropy: u16,
}

/// The displaced surface: functions of the core, and the textures that they read.
///
/// `terrane_relief` places it under a pixel. `terrane_displace` traces the eye's ray; `terrane_relief_shadow` and
/// `terrane_relief_occlusion` are there if the terrain asks for them. The last arguments of these three are all textures of all
/// arrays, in order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReliefInfo {
    /// How rays are traced: the method, as `terrane measure` names it.
    pub method: String,
    /// Arguments of `terrane_relief`, in order.
    pub arguments: Vec<String>,
    /// Metres from the eye: where relief begins to fade, and where it is gone.
    pub fade: [f32; 2],
    /// Metres from the ground to the lowest point.
    pub deepest: f32,
    /// Height maps, with what is known of them.
    pub arrays: Vec<ReliefArrayInfo>,
}

/// Height maps of one size.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReliefArrayInfo {
    /// Texels of every map.
    pub size: [u32; 2],
    /// The textures over them: heights, and what the tracer and the lights know of them.
    pub textures: Vec<TextureInfo>,
    /// The image that each layer was made of.
    pub sources: Vec<ReliefSourceInfo>,
}

/// A channel of an image.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReliefSourceInfo {
    /// The image, project-relative.
    pub file: String,
    /// Its channel.
    pub channel: u8,
}

/// Use of limits.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LimitsInfo {
    /// Of WebGPU's 16 in a stage.
    pub sampled_textures: u32,
    /// Of WebGPU's 4 in a stage.
    pub storage_textures: u32,
    /// Of WebGPU's 16 in a stage.
    pub samplers: u32,
    /// Of WebGPU's 65536.
    pub uniform_bytes: u32,
    /// Of WebGPU's 256.
    pub texture_array_layers: u32,
}

/// One specialised shader.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PermutationInfo {
    /// Layers that it composites, bottom to top.
    pub layers: Vec<String>,
    /// The core.
    pub core: FileInfo,
    /// The core with plain WebGPU entry points.
    pub host: FileInfo,
    /// Where it is to be used: `all`.
    pub patches: String,
    /// Cost of `terrane_surface`.
    pub cost: Cost,
    /// Calls that the graphs make.
    pub nodes: u32,
    /// Values that are left of them: equal sub-trees are computed once, dead ones not at all.
    pub values: u32,
    /// Lines of the core and the nodes that they came from.
    pub source_map: Vec<SourceLine>,
}

/// An emitted file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FileInfo {
    /// Beside the manifest.
    pub path: String,
    /// SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
}

/// Where a line of the core came from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SourceLine {
    /// Line of the core, from 1.
    pub line: u32,
    /// `granite/edge/grain`: layer, instance nodes, node.
    pub node: String,
    /// The graph file.
    pub file: String,
    /// Line of the graph file, from 1.
    pub file_line: u32,
}
