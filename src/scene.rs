//! From a project's graphs to what the renderer draws.

use std::collections::BTreeSet;
use std::path::Path;

use terrane_codegen::compile::Compiled;
use terrane_codegen::graph::model::{HeightFrom, Scene, Shadow, Solid, Terrain};
use terrane_codegen::manifest::{ReliefArrayInfo, UniformInfo};
use terrane_codegen::program::ProgramRelief;
use terrane_shaderlib::relief::MapTexture;

use crate::render::material::{Format, Material, Relief, Sampling, TextureArray, decode};
use crate::render::{self, Camera, HeightField, RenderError, RenderScene};

/// Every file of the project that a shader and its terrain read, project-relative.
pub fn files(compiled: &Compiled) -> BTreeSet<String> {
    let layers = compiled.manifest.textures.iter().flat_map(|texture| texture.layers.iter().cloned());
    let reliefs = compiled.manifest.relief.iter().flat_map(|relief| &relief.arrays);
    let layers = layers.chain(reliefs.flat_map(|array| array.sources.iter().map(|source| source.file.clone())));
    layers.chain(compiled.manifest.terrain.iter().map(|terrain| terrain.height_map.clone())).collect()
}

/// What group 1 reads, as the manifest lists it; parameters have their defaults.
pub fn material(compiled: &Compiled, root: &Path) -> Material {
    let program = &compiled.program;
    let manifest = &compiled.manifest;
    let arrays = manifest.textures.iter().zip(&program.arrays).map(|(info, array)| TextureArray {
        binding: info.binding,
        size: array.size,
        format: array.format,
        layers: array.files.iter().map(|file| root.join(file)).collect(),
    });
    let samplers = manifest.samplers.iter().zip(&program.samplers).map(|(info, key)| Sampling {
        binding: info.binding,
        wrap: key.wrap,
        filter: key.filter,
        anisotropy: key.anisotropy,
    });
    Material {
        parameters: manifest.parameters.as_ref().map(|block| (block.binding, defaults(block))),
        arrays: arrays.collect(),
        samplers: samplers.collect(),
        reliefs: compiled
            .manifest
            .relief
            .iter()
            .flat_map(|relief| &relief.arrays)
            .map(|array| map(array, compiled, root))
            .collect(),
    }
}

/// Height maps of one size.
fn map(array: &ReliefArrayInfo, compiled: &Compiled, root: &Path) -> Relief {
    let bindings = array.textures.iter().map(|texture| texture.binding);
    Relief {
        size: (array.size[0], array.size[1]),
        textures: bindings.zip(map_textures(compiled)).collect(),
        maps: array.sources.iter().map(|source| (root.join(&source.file), source.channel)).collect(),
    }
}

/// What a shader reads of its height maps, in the order of the manifest.
pub fn map_textures(compiled: &Compiled) -> Vec<MapTexture> {
    compiled.program.relief.as_ref().map_or(Vec::new(), ProgramRelief::textures)
}

/// The uniform block with every parameter at its default.
fn defaults(block: &UniformInfo) -> Vec<u8> {
    let mut bytes = vec![0; block.size as usize];
    for member in &block.members {
        for (index, value) in member.default.iter().enumerate() {
            let at = member.offset as usize + 4 * index;
            bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
        }
    }
    bytes
}

/// The terrain's shape in metres.
///
/// # Errors
/// If the height map cannot be read or is not what the terrain says.
pub fn height_field(terrain: &Terrain, root: &Path) -> Result<HeightField, RenderError> {
    let map = &terrain.height;
    let texels = decode(&root.join(&map.file), map.texels, Format::R16Float)?;
    let (low, high) = map.range;
    let metres = texels.values.iter().map(|value| low + value * (high - low)).collect();
    let spacing = [map.size.0 / map.texels.0 as f32, map.size.1 / map.texels.1 as f32];
    HeightField::new([map.texels.0, map.texels.1], spacing.map(f64::from), metres)
}

/// How fine a picture is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Width and height in pixels.
    pub image: [u32; 2],
    /// Samples of a pixel on a side.
    pub supersampling: u32,
    /// Pixels by which simplified terrain may be off.
    pub tolerance: f64,
}

/// What stands on a scene's terrain, its heights counted from 0.
pub fn objects(scene: &Scene, field: &HeightField) -> Vec<render::Object> {
    let objects = scene.objects.iter().map(|object| {
        let [x, y, z] = object.center.map(f64::from);
        let ground = if object.from == HeightFrom::Ground { field.bilinear(x, z) } else { 0.0 };
        let (solid, center) = (solid(object.solid), [x, ground + y, z]);
        render::Object { solid, center, albedo: object.albedo, roughness: object.roughness }
    });
    objects.collect()
}

fn solid(solid: Solid) -> render::Solid {
    match solid {
        Solid::Sphere { radius } => render::Solid::Sphere { radius: radius.into() },
        Solid::Box { size, turn } => render::Solid::Box { size: size.map(f64::from), turn: turn.into() },
        Solid::Column { radius, height } => render::Solid::Column { radius: radius.into(), height: height.into() },
    }
}

/// What the renderer is to draw; with objects, `compiled` is for the host that has some.
pub fn render_scene<'a>(
    scene: &Scene,
    compiled: &'a Compiled,
    material: &'a Material,
    field: &'a HeightField,
    objects: &'a [render::Object],
    quality: Quality,
) -> RenderScene<'a> {
    RenderScene {
        shader: &compiled.host.text,
        material,
        field,
        shadow: scene.terrain.shadow == Shadow::Horizon,
        occlusion: scene.terrain.occlusion,
        surroundings: true,
        camera: Camera {
            eye: scene.camera.eye.map(f64::from),
            target: scene.camera.target.map(f64::from),
            fov: scene.camera.fov.into(),
        },
        sun: [scene.sun.azimuth.into(), scene.sun.elevation.into()],
        turbidity: scene.turbidity.into(),
        exposure: scene.exposure.into(),
        objects,
        image: quality.image,
        supersampling: quality.supersampling,
        tolerance: quality.tolerance,
    }
}
