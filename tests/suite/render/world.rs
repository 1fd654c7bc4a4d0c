//! A landscape and a material for the renderer's tests: ridged noise, four grounds.

use terrane::render::{Gpu, HeightField, RenderError, Selection};
use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_shaderlib::{SourceFile, hosts};

use crate::skip::Skip;

/// The one device of a test, or the reason why there is none.
pub(crate) fn gpu() -> Result<Gpu, Skip> {
    match Gpu::new(&Selection::Best) {
        Err(RenderError::NoAdapter) => Err(Skip("no adapter".into())),
        other => Ok(other.expect("an adapter with the default limits")),
    }
}

/// Mountains of about 900 m on a square of `side` texels with `spacing` metres between them.
pub(crate) fn mountains(side: u32, spacing: f64) -> HeightField {
    let texel = |index: u32| {
        let metres = [index % side, index / side].map(|texel| f64::from(texel) * spacing);
        let (mut height, mut amplitude, mut wavelength) = (0.0, 520.0, 2600.0);
        let mut weight = 1.0;
        for octave in 0..9 {
            let ridge = 1.0 - (2.0 * noise(metres[0] / wavelength, metres[1] / wavelength, octave) - 1.0).abs();
            let ridge = ridge * ridge * weight;
            weight = (ridge * 1.6).clamp(0.0, 1.0);
            height += amplitude * ridge;
            amplitude *= 0.48;
            wavelength *= 0.49;
        }
        height as f32
    };
    HeightField::new([side, side], [spacing, spacing], (0..side * side).map(texel).collect()).expect("finite heights")
}

/// Value noise with a quintic fade, 0..1.
fn noise(x: f64, z: f64, seed: u32) -> f64 {
    let (i, j) = (x.floor(), z.floor());
    let fade = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let (s, t) = (fade(x - i), fade(z - j));
    let corner = |di: f64, dj: f64| hash(i + di, j + dj, seed);
    let north = corner(0.0, 0.0) * (1.0 - s) + corner(1.0, 0.0) * s;
    let south = corner(0.0, 1.0) * (1.0 - s) + corner(1.0, 1.0) * s;
    north * (1.0 - t) + south * t
}

fn hash(i: f64, j: f64, seed: u32) -> f64 {
    let mut word = (i as i32 as u32).wrapping_mul(0x9E37_79B9) ^ (j as i32 as u32).wrapping_mul(0x85EB_CA6B) ^ seed;
    for multiplier in [0x7FEB_352D_u32, 0x846C_A68B] {
        word = (word ^ (word >> 15)).wrapping_mul(multiplier);
    }
    f64::from(word ^ (word >> 16)) / f64::from(u32::MAX)
}

/// A complete terrain shader around a hand-written core.
pub(crate) fn shader(core: &str) -> String {
    shader_in(hosts::WGPU_TERRAIN, core)
}

/// A complete shader of any host around a hand-written core.
pub(crate) fn shader_in(host: &[SourceFile], core: &str) -> String {
    let library = Library::load(&mut Sources::default(), &[]).expect("the library is sound");
    let host = hosts::join(host);
    let used = library.closure(&format!("{core}{host}"));
    let items: String = used.into_iter().flat_map(|item| [library.slice(item), "\n\n"]).collect();
    format!("{items}{core}{host}")
}

/// The declarations that every core has.
pub(crate) const OUT: &str = "
struct TerrainOut {
    albedo: vec3f, normal: vec3f, roughness: f32, metallic: f32, occlusion: f32, emissive: vec3f,
}
";

/// Grey ground.
pub(crate) const GREY: &str = "
fn terrane_shade(frame: HostFrame) -> TerrainOut {
    return TerrainOut(vec3f(0.3), vec3f(0.0, 0.0, 1.0), 0.9, 0.0, 1.0, vec3f(0.0));
}
";

/// Grass, scree, rock and snow.
pub(crate) const ALPINE: &str = "
fn terrane_shade(frame: HostFrame) -> TerrainOut {
    let large = fbm(frame.position, 180.0, 5u, 0.55, 3u);
    let small = fbm(frame.position, 11.0, 6u, 0.6, 9u);
    let e = 0.35;
    let dx = fbm(place_moved(frame.position, vec2f(e, 0.0)), 11.0, 6u, 0.6, 9u) - small;
    let dz = fbm(place_moved(frame.position, vec2f(0.0, e)), 11.0, 6u, 0.6, 9u) - small;
    let rocky = smoothstep(0.16, 0.30, frame.slope + 0.25 * (small - 0.5) + 0.15 * (large - 0.5));
    let stony = smoothstep(0.05, 0.16, frame.slope + 0.2 * (large - 0.5));
    let snowy = smoothstep(560.0, 700.0, frame.height + 260.0 * (large - 0.5)) * smoothstep(0.34, 0.2, frame.slope + 0.2 * (small - 0.5));
    let grass = mix(vec3f(0.055, 0.075, 0.022), vec3f(0.13, 0.12, 0.045), small) * (0.7 + 0.6 * large);
    let scree = mix(vec3f(0.16, 0.145, 0.125), vec3f(0.27, 0.25, 0.22), small);
    let rock = mix(vec3f(0.11, 0.105, 0.10), vec3f(0.28, 0.26, 0.235), small * 0.6 + large * 0.4);
    var albedo = mix(mix(grass, scree, stony), rock, rocky);
    var roughness = mix(0.95, 0.8, rocky);
    let strength = mix(0.5, 1.6, rocky) * (1.0 - 0.8 * snowy);
    albedo = mix(albedo, vec3f(0.80, 0.83, 0.87), snowy);
    roughness = mix(roughness, 0.6, snowy);
    let normal = normalize(vec3f(-dx * strength / e, -dz * strength / e, 1.0));
    return TerrainOut(albedo, normal, roughness, 0.0, mix(0.75 + 0.25 * small, 1.0, snowy), vec3f(0.0));
}
";
