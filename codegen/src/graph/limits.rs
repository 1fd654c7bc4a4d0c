//! What input may cost. Beyond a limit there is a diagnostic, never a stalled or broken process.

/// Bytes of a graph file or of `terrane.ron`.
pub const FILE_BYTES: u64 = 4 << 20;
/// Brackets inside brackets: what `ron` itself allows.
pub const DEPTH: usize = 128;
/// Nodes of a file, and of a terrain once every instance is copied to each of its calls.
pub const NODES: usize = 10_000;
/// Arguments of all nodes of a file.
pub const EDGES: usize = 100_000;
/// Instances inside instances.
pub const INCLUDE_DEPTH: usize = 16;
/// Files behind a terrain or a surface.
pub const FILES: usize = 64;
/// Bytes of a string.
pub const STRING_BYTES: usize = 4096;
/// Parts of a reference: `a.b.c` has three.
pub const STEPS: usize = 16;
/// Pixels on a side of an image.
pub const IMAGE_SIDE: u32 = 16_384;
/// Pixels of an image.
pub const IMAGE_PIXELS: u64 = 256 << 20;
/// Findings of one report.
pub const FINDINGS: usize = 200;
/// Layers of a terrain.
pub const LAYERS: usize = 64;
/// Objects of a scene: a uniform array has so many.
pub const OBJECTS: usize = terrane_shaderlib::hosts::WGPU_OBJECTS;
/// Patches on a side of a terrain.
pub const PATCHES: f32 = 1024.0;
