//! From a scene to its picture.
//!
//! Depth of the ground as the height map has it, the sky, the ground's light, the depth of its relief, then objects: the order is
//! right for every sample. Relief only goes down from the ground, and the light of a sample is followed along its own ray, so
//! the ground that is in front before relief is the one whose relief is seen: the light needs the first depth alone, and no
//! object may stand in that, or it would hide relief in front of it. Once the depth of the relief has taken the ground's place, an
//! object is seen exactly where it is nearer than that. One that was tested against the ground itself would end where it
//! goes into the ground; its part in a crack, over the crack's bottom, would be lost. It covers the light of what is behind it, and
//! nothing is mixed: samples of a pixel are, later.

use glam::DVec3;
use terrane_shaderlib::hosts;

use super::air::{Aerial, Atmosphere, SkyTable};
use super::camera::{Camera, View, sun_direction};
use super::error::{RenderError, Result};
use super::frame::{
    Bound, Displaced, FullScreen, ObjectsUniform, Tables, Targets, TerrainDraw, TerrainPipeline, ViewUniform,
    read_depth, resolve,
};
use super::geometry::{Bounds, select, visible};
use super::gpu::Gpu;
use super::height_field::HeightField;
use super::image::Image;
use super::light::{LightSettings, light_map};
use super::lights::{ADAPTATION, Lights};
use super::material::{Material, MaterialGroup};
use super::object::{self, Object};
use super::progress::Progress;

/// Everything that a picture of a terrain depends on.
#[derive(Clone, Debug)]
pub struct RenderScene<'a> {
    /// The complete WGSL: the emitted core within one of the texts of `terrane_shaderlib::hosts::terrain`, or where there are
    /// objects, of `furnished`.
    pub shader: &'a str,
    /// What the shader's group 1 reads.
    pub material: &'a Material,
    /// The shape of the terrain.
    pub field: &'a HeightField,
    /// Whether the terrain throws shadows on itself.
    pub shadow: bool,
    /// Directions of the sky's occlusion by the terrain, 0 for none.
    pub occlusion: u32,
    /// Whether mirror images of the terrain lie around it, so that no picture shows where the height map ends.
    pub surroundings: bool,
    /// Where from.
    pub camera: Camera,
    /// Degrees clockwise from north (−z), and above the horizon.
    pub sun: [f64; 2],
    /// 1.8 is arctic air, 10 is haze.
    pub turbidity: f64,
    /// Stops on top of the base exposure.
    pub exposure: f64,
    /// What stands on the terrain, no more than `terrane_shaderlib::hosts::WGPU_OBJECTS`.
    pub objects: &'a [Object],
    /// Width and height in pixels.
    pub image: [u32; 2],
    /// Samples of a pixel on a side.
    pub supersampling: u32,
    /// Pixels by which simplified terrain may be off.
    pub tolerance: f64,
}

/// A picture and its depth.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture.
    pub image: Image,
    /// [`super::NEAR`] over metres along the view's axis, 0 for the sky; one per sample, row by row.
    pub depth: Vec<f32>,
}

/// Metres of land around a terrain: beyond, haze has taken the contrast.
const LAND_REACH: f64 = 12_000.0;

/// Largest side of a texture that core WebGPU promises.
const LARGEST: u32 = 8192;

/// Draws a scene.
///
/// # Errors
/// [`RenderError::Scene`] for a camera, sun, size or object that makes no picture, [`RenderError::Texture`] for a file of the
/// material, the others where the device fails.
pub fn render_scene(gpu: &Gpu, scene: &RenderScene<'_>, progress: Progress) -> Result<Image> {
    let targets = draw(gpu, scene, progress)?;
    let _phase = progress.phase("tone mapping", 1);
    resolve(gpu, &targets.radiance, scene.supersampling)
}

/// Draws a scene and keeps its depth.
///
/// # Errors
/// As [`render_scene`].
pub fn render_with_depth(gpu: &Gpu, scene: &RenderScene<'_>, progress: Progress) -> Result<Rendered> {
    let targets = draw(gpu, scene, progress)?;
    Ok(Rendered {
        image: resolve(gpu, &targets.radiance, scene.supersampling)?,
        depth: read_depth(gpu, &targets.depth)?,
    })
}

/// Refuses what does not fit into a texture.
pub(super) fn validate_size(image: [u32; 2], supersampling: u32) -> Result<()> {
    if !(1..=8).contains(&supersampling) {
        return Err(RenderError::Scene(format!("supersampling of {supersampling} is not in 1..8")));
    }
    let largest = LARGEST / supersampling;
    if image.iter().any(|side| !(1..=largest).contains(side)) {
        let [width, height] = image;
        let reason = format!("a picture of {width} x {height} is not in 1..{largest} pixels on each side");
        return Err(RenderError::Scene(reason));
    }
    Ok(())
}

/// Draws a scene's radiance and depth.
pub(super) fn draw(gpu: &Gpu, scene: &RenderScene<'_>, progress: Progress) -> Result<Targets> {
    scene.validate()?;
    let view = scene.camera.view(scene.image[0], scene.image[1])?;
    let [width, height] = scene.image.map(|side| side * scene.supersampling);
    let material = MaterialGroup::new(gpu, scene.material, progress)?;
    let bound = bind(gpu, scene, &view, progress)?;
    let displaced = !scene.material.reliefs.is_empty();
    let terrain = {
        let _phase = progress.phase("terrain shader", 1);
        TerrainPipeline::new(gpu, scene.shader, displaced, &bound, &material)?
    };
    let sky = FullScreen::behind(gpu, "sky", &hosts::join(hosts::WGPU_SKY), &[&bound.layout])?;
    let objects = match scene.objects {
        [] => None,
        _ => Some(FullScreen::among(gpu, "objects", scene.shader, &[&bound.layout, &material.layout])?),
    };
    let patches = TerrainDraw::new(gpu, scene.field, &scene.patches(&view, progress))?;
    let targets = Targets::new(gpu, width, height, displaced)?;
    let phase = progress.phase("drawing", patches.pieces() as u64 + 4);
    let submit = |record: &dyn Fn(&mut wgpu::CommandEncoder)| {
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        gpu.checked("drawing commands", || record(&mut encoder))?;
        gpu.queue.submit([encoder.finish()]);
        gpu.wait()?;
        phase.advance(1);
        Ok(())
    };
    submit(&|encoder| patches.draw_depth(&mut targets.depth_pass(encoder), &terrain, &bound, &material))?;
    submit(&|encoder| sky.draw(&mut targets.sky_pass(encoder), &[&bound.group]))?;
    for piece in 0..patches.pieces() {
        submit(&|encoder| {
            patches.draw_light(&mut targets.light_pass(encoder, piece == 0), &terrain, &bound, &material, piece);
        })?;
    }
    if let Some(texture) = &targets.displaced {
        let displaced = Displaced::new(gpu, texture)?;
        submit(&|encoder| displaced.draw(&mut targets.displaced_pass(encoder)))?;
    }
    if let Some(objects) = &objects {
        submit(&|encoder| objects.draw(&mut targets.objects_pass(encoder), &[&bound.group, &material.group]))?;
    }
    Ok(targets)
}

fn bind(gpu: &Gpu, scene: &RenderScene<'_>, view: &View, progress: Progress) -> Result<Bound> {
    let sun = sun_direction(scene.sun[0], scene.sun[1]);
    let phase = progress.phase("atmosphere", 4);
    let atmosphere = Atmosphere::new(scene.turbidity, sun);
    phase.advance(1);
    let lights = Lights::new(&atmosphere, scene.field.range(), scene.exposure, ADAPTATION);
    phase.advance(1);
    let sky = SkyTable::new(&atmosphere, view.eye.y, lights.low.sky);
    phase.advance(1);
    let aerial = Aerial::new(&atmosphere, view, scene.reach(view.eye));
    drop(phase);
    let settings =
        LightSettings { sun, shadow: scene.shadow, directions: scene.occlusion, surroundings: scene.surroundings };
    let light = light_map(scene.field, settings, progress);
    let samples = scene.image.map(|side| side * scene.supersampling);
    let uniform = ViewUniform::new(view, scene.field, &atmosphere, &lights, aerial.reach, samples);
    let (field, objects) = (scene.field, ObjectsUniform::new(scene.objects, view));
    Bound::new(
        gpu,
        &Tables { view: uniform, objects, lights: &lights, sky: &sky, aerial: &aerial, field, light: &light },
    )
}

impl RenderScene<'_> {
    fn validate(&self) -> Result<()> {
        let refuse = |reason: String| Err(RenderError::Scene(reason));
        validate_size(self.image, self.supersampling)?;
        if !(0.0..=90.0).contains(&self.sun[1]) || !self.sun[0].is_finite() {
            return refuse(format!("a sun {} degrees above the horizon is not in 0..90", self.sun[1]));
        }
        if !(1.0..=20.0).contains(&self.turbidity) || !(-20.0..=20.0).contains(&self.exposure) {
            return refuse("turbidity is not in 1..20 or exposure not in -20..20 stops".into());
        }
        if self.tolerance.is_nan() || self.tolerance < 0.0 {
            return refuse(format!("a tolerance of {} pixels is negative", self.tolerance));
        }
        object::validate(self.objects)?;
        let [x, y, z] = self.camera.eye;
        let ground = self.field.bilinear(x, z);
        if y <= ground && [x, z].iter().zip(self.field.extent()).all(|(at, extent)| (0.0..extent).contains(at)) {
            return refuse(format!("camera: the eye is {:.1} m under the ground at {ground:.1} m", ground - y));
        }
        Ok(())
    }

    fn patches(&self, view: &View, progress: Progress) -> Vec<super::geometry::Patch> {
        let _phase = progress.phase("terrain patches", 1);
        let bounds = Bounds::new(self.field);
        let tolerance = self.tolerance / view.pixels_per_radian(self.image[1]);
        let leaves = select(self.field, &bounds, view.eye, tolerance, self.rings());
        let patches = visible(self.field, &bounds, view, &leaves);
        log::debug!("{} of {} patches are visible", patches.len(), leaves.len());
        patches
    }

    /// Images on each side of the terrain.
    fn rings(&self) -> u32 {
        let [width, depth] = self.field.extent();
        // Three are as far as a repetition can go before it is noticed.
        if self.surroundings { (LAND_REACH / width.min(depth)).ceil().clamp(1.0, 3.0) as u32 } else { 0 }
    }

    /// Metres from the eye to the land's farthest corner.
    fn reach(&self, eye: DVec3) -> f64 {
        let farthest = |at: f64, extent: f64| {
            let around = extent * f64::from(self.rings());
            (at + around).abs().max((at - extent - around).abs())
        };
        let [width, depth] = self.field.extent();
        let [low, high] = self.field.range().map(f64::from);
        let up = (eye.y - low).abs().max((eye.y - high).abs());
        DVec3::new(farthest(eye.x, width), up, farthest(eye.z, depth)).length()
    }
}
