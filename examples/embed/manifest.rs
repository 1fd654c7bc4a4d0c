//! The part of the manifest that this engine reads. The whole of it is described by `terrane`'s JSON schema.

use std::path::Path;

use serde::Deserialize;

/// What `terrane build` wrote beside the shaders.
#[derive(Debug, Deserialize)]
pub(crate) struct Manifest {
    pub(crate) version: u32,
    pub(crate) terrain: Option<Terrain>,
    /// Arguments of `terrane_surface`, in order.
    pub(crate) arguments: Vec<String>,
    /// Members of `TerrainIn`, in order.
    pub(crate) inputs: Vec<Input>,
    pub(crate) parameters: Option<Parameters>,
    pub(crate) textures: Vec<Texture>,
    pub(crate) samplers: Vec<Sampler>,
    pub(crate) permutations: Vec<Permutation>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct Terrain {
    pub(crate) height_map: String,
    /// Metres on x and z.
    pub(crate) size: [f32; 2],
    /// Metres at black and at white.
    pub(crate) range: [f32; 2],
    /// Side of a patch in metres.
    pub(crate) patch: f32,
}

#[derive(Debug, Deserialize)]
pub(crate) struct Input {
    pub(crate) name: String,
}

/// The uniform block `TerrainParameters`.
#[derive(Debug, Deserialize)]
pub(crate) struct Parameters {
    /// Bytes.
    pub(crate) size: usize,
    pub(crate) members: Vec<Parameter>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct Parameter {
    /// Byte in the block.
    pub(crate) offset: usize,
    pub(crate) default: Vec<f32>,
}

/// A texture array.
#[derive(Debug, Deserialize)]
pub(crate) struct Texture {
    pub(crate) name: String,
    /// A WebGPU format.
    pub(crate) format: String,
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// A PNG for each layer.
    pub(crate) layers: Vec<String>,
}

#[derive(Debug, Deserialize)]
pub(crate) struct Sampler {
    pub(crate) name: String,
    pub(crate) address_mode: String,
    pub(crate) filter: String,
    pub(crate) max_anisotropy: u16,
}

#[derive(Debug, Deserialize)]
pub(crate) struct Permutation {
    pub(crate) core: File,
}

#[derive(Debug, Deserialize)]
pub(crate) struct File {
    /// Beside the manifest.
    pub(crate) path: String,
}

impl Manifest {
    /// Reads a manifest of a version that this engine knows.
    pub(crate) fn read(path: &Path) -> Result<Self, String> {
        let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let manifest: Self = serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))?;
        if manifest.version != 1 {
            return Err(format!("{} has version {}, this engine reads version 1", path.display(), manifest.version));
        }
        Ok(manifest)
    }
}
