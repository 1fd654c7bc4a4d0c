//! Shaders around the emitted core: entry points, bindings and light of one host.
//!
//! A host's shader is its files in the given order, after the core and the library functions that they use. The files call
//! `terrane_shade(frame: HostFrame) -> TerrainOut`, which the generator writes, and use the library's `Place` and `Coord`.

use crate::SourceFile;

macro_rules! host {
    ($path:literal) => {
        SourceFile { path: $path, text: include_str!(concat!("../hosts/", $path)) }
    };
}

/// Plain WebGPU: a terrain of patches. Entry points `terrain_vertex` and `terrain_fragment`.
pub const WGPU_TERRAIN: &[SourceFile] = &[
    host!("wgpu/view.wgsl"),
    host!("wgpu/frame.wgsl"),
    host!("wgpu/ground.wgsl"),
    host!("wgpu/light.wgsl"),
    host!("wgpu/terrain.wgsl"),
];

/// Plain WebGPU: one material on a square and a ball. Entry points `preview_vertex` and `preview_fragment`.
pub const WGPU_PREVIEW: &[SourceFile] =
    &[host!("wgpu/view.wgsl"), host!("wgpu/frame.wgsl"), host!("wgpu/light.wgsl"), host!("wgpu/preview.wgsl")];

/// Sampled textures that [`WGPU_TERRAIN`] and [`WGPU_PREVIEW`] bind at most in group 0; what is left of a stage's 16 is the material's.
pub const WGPU_TEXTURES: usize = 5;

/// The renderer's own: the sky behind a terrain. Entry points `sky_vertex` and `sky_fragment`.
pub const WGPU_SKY: &[SourceFile] = &[host!("wgpu/view.wgsl"), host!("wgpu/sky.wgsl")];

/// The renderer's own: from radiance to a picture. Entry points `resolve_vertex` and `resolve_fragment`.
pub const WGPU_RESOLVE: &[SourceFile] = &[host!("wgpu/resolve.wgsl")];

/// Relief's own: bounds and mips of a height map, made on the device. Entry points `build_vertex`, and `build_fill`, `build_mip`,
/// `build_cells` and `build_nodes` for one level each.
pub const WGPU_RELIEF_BUILD: &[SourceFile] = &[host!("relief/build.wgsl")];

/// The files of a host, joined.
#[must_use]
pub fn join(files: &[SourceFile]) -> String {
    files.iter().flat_map(|file| [file.text, "\n"]).collect()
}
