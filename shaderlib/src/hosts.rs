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

/// The files of a terrain of patches, and those behind them.
macro_rules! terrain {
    ($($path:literal),*) => {
        &[
            host!("wgpu/view.wgsl"),
            host!("wgpu/frame.wgsl"),
            host!("wgpu/ground.wgsl"),
            host!("wgpu/light.wgsl"),
            host!("wgpu/terrain.wgsl"),
            $(host!($path)),*
        ]
    };
}

/// The same with solids on the terrain, and those behind them.
macro_rules! furnished {
    ($($path:literal),*) => {
        terrain!(
            "wgpu/objects.wgsl",
            "wgpu/objects_light.wgsl",
            "wgpu/objects_ground.wgsl",
            "wgpu/objects_drawn.wgsl",
            $($path),*
        )
    };
}

/// Plain WebGPU: a terrain of patches. Entry points `terrain_vertex` and `terrain_fragment`.
pub const WGPU_TERRAIN: &[SourceFile] = terrain!("wgpu/alone.wgsl", "wgpu/flat.wgsl");

/// The same for materials with relief. `terrain_fragment` gives depth as a second colour.
pub const WGPU_TERRAIN_DISPLACED: &[SourceFile] =
    terrain!("wgpu/alone.wgsl", "wgpu/traced.wgsl", "wgpu/displaced.wgsl");

/// The same for looking at the search itself. `terrain_fragment` gives what it cost and how far it went.
pub const WGPU_TERRAIN_SEARCHED: &[SourceFile] = terrain!("wgpu/alone.wgsl", "wgpu/traced.wgsl", "wgpu/searched.wgsl");

/// [`WGPU_TERRAIN`] with solids that stand on it, in a uniform block at binding 7 of group 0. More entry points:
/// `objects_vertex` and `objects_fragment`.
pub const WGPU_TERRAIN_FURNISHED: &[SourceFile] = furnished!("wgpu/objects_flat.wgsl", "wgpu/flat.wgsl");

/// [`WGPU_TERRAIN_DISPLACED`] with solids.
pub const WGPU_TERRAIN_DISPLACED_FURNISHED: &[SourceFile] =
    furnished!("wgpu/traced.wgsl", "wgpu/objects_sunk.wgsl", "wgpu/displaced.wgsl");

/// Solids that such a terrain has at most.
pub const WGPU_OBJECTS: usize = 16;

/// The files of one material on a square and a ball, and those behind them.
macro_rules! preview {
    ($($path:literal),*) => {
        &[
            host!("wgpu/view.wgsl"),
            host!("wgpu/frame.wgsl"),
            host!("wgpu/light.wgsl"),
            host!("wgpu/preview.wgsl"),
            $(host!($path)),*
        ]
    };
}

/// Plain WebGPU: one material on a square and a ball. Entry points `preview_vertex` and `preview_fragment`.
pub const WGPU_PREVIEW: &[SourceFile] = preview!("wgpu/preview_flat.wgsl");

/// The same for a material with relief.
pub const WGPU_PREVIEW_DISPLACED: &[SourceFile] = preview!("wgpu/traced.wgsl", "wgpu/preview_displaced.wgsl");

/// Sampled textures that [`WGPU_TERRAIN`] and [`WGPU_PREVIEW`] bind at most in group 0; what is left of a stage's 16 is the material's.
pub const WGPU_TEXTURES: usize = 5;

/// The renderer's own: the sky behind a terrain. Entry points `sky_vertex` and `sky_fragment`.
pub const WGPU_SKY: &[SourceFile] = &[host!("wgpu/view.wgsl"), host!("wgpu/sky.wgsl")];

/// The renderer's own: depth of displaced surfaces. Entry points `depth_vertex` and `depth_fragment`.
pub const WGPU_DEPTH: &[SourceFile] = &[host!("wgpu/depth.wgsl")];

/// The renderer's own: from radiance to a picture. Entry points `resolve_vertex` and `resolve_fragment`.
pub const WGPU_RESOLVE: &[SourceFile] = &[host!("wgpu/resolve.wgsl")];

/// Relief's own: mips and bounds of a height map, made on the device. Entry points `build_vertex`, or `build_part_vertex` for the parts
/// of a level that `build_highest_node` and `build_reached` tell, and for one level each
/// `build_fill` and `build_mip`, `build_cells` and `build_nodes`, `build_same`, `build_patches` and `build_wide`; for square cones
/// `build_corners`, `build_surrounded`, `build_joined`, `build_steepened`, and `build_cone` or `build_quadrants`; for round ones
/// `build_counting`, `build_counting_nodes`, `build_searched` and `build_round_cone`.
pub const WGPU_RELIEF_BUILD: &[SourceFile] = &[
    host!("relief/build.wgsl"),
    host!("relief/build_mips.wgsl"),
    host!("relief/build_pyramid.wgsl"),
    host!("relief/build_patches.wgsl"),
    host!("relief/build_wide.wgsl"),
    host!("relief/build_cones_squares.wgsl"),
    host!("relief/build_cones.wgsl"),
    host!("relief/build_cones_codes.wgsl"),
    host!("relief/build_cones_round.wgsl"),
    host!("relief/build_cones_reached.wgsl"),
];

/// The texts of a host, for materials without relief and with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Host {
    /// Calls `terrane_shade` alone.
    pub flat: String,
    /// Calls `terrane_ground`, `terrane_trace`, `terrane_sunlit` and `terrane_open` as well; `None` for a host that draws no
    /// relief.
    pub displaced: Option<String>,
}

/// The plain WebGPU host for terrain.
#[must_use]
pub fn terrain() -> Host {
    Host { flat: join(WGPU_TERRAIN), displaced: Some(join(WGPU_TERRAIN_DISPLACED)) }
}

/// The same for terrain with objects on it.
#[must_use]
pub fn furnished() -> Host {
    Host { flat: join(WGPU_TERRAIN_FURNISHED), displaced: Some(join(WGPU_TERRAIN_DISPLACED_FURNISHED)) }
}

/// The plain host, but materials with relief show what the search for it did.
#[must_use]
pub fn searched() -> Host {
    Host { flat: join(WGPU_TERRAIN), displaced: Some(join(WGPU_TERRAIN_SEARCHED)) }
}

/// The host that shows one material.
#[must_use]
pub fn preview() -> Host {
    Host { flat: join(WGPU_PREVIEW), displaced: Some(join(WGPU_PREVIEW_DISPLACED)) }
}

/// The files of a host, joined.
#[must_use]
pub fn join(files: &[SourceFile]) -> String {
    files.iter().flat_map(|file| [file.text, "\n"]).collect()
}
