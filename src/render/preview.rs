//! One material alone: what an artist looks at while he makes it.

use glam::{DVec3, Vec4};

use super::air::{Aerial, Atmosphere, SkyTable};
use super::camera::{Camera, sun_direction};
use super::error::{RenderError, Result};
use super::frame::{Bound, FullScreen, ObjectsUniform, Tables, Targets, ViewUniform, resolve};
use super::gpu::Gpu;
use super::height_field::HeightField;
use super::image::Image;
use super::light::{LightMap, OPEN};
use super::lights::Lights;
use super::material::{Material, MaterialGroup};
use super::progress::Progress;

/// A material on a square of ground and on a ball.
#[derive(Clone, Debug)]
pub struct Preview<'a> {
    /// The complete WGSL: the emitted core within one of the texts of `terrane_shaderlib::hosts::preview`.
    pub shader: &'a str,
    /// What the shader's group 1 reads.
    pub material: &'a Material,
    /// Metres on a side of the square.
    pub size: f64,
    /// Width and height in pixels.
    pub image: [u32; 2],
    /// Samples of a pixel on a side.
    pub supersampling: u32,
}

/// Degrees: from the left behind the camera, so that shapes and bumps read.
const SUN: [f64; 2] = [258.0, 40.0];
const TURBIDITY: f64 = 2.5;

/// Draws a preview.
///
/// # Errors
/// [`RenderError::Scene`] for a size that makes no picture, [`RenderError::Texture`] for a file of the material, the
/// others where the device fails.
pub fn render_preview(gpu: &Gpu, preview: &Preview<'_>, progress: Progress) -> Result<Image> {
    super::scene::validate_size(preview.image, preview.supersampling)?;
    if !(0.01..=10_000.0).contains(&preview.size) {
        return Err(RenderError::Scene(format!("a square of {} m is not in 0.01..10000", preview.size)));
    }
    let [width, height] = preview.image.map(|side| side * preview.supersampling);
    let material = MaterialGroup::new(gpu, preview.material, progress)?;
    let bound = bind(gpu, preview)?;
    let pipeline = FullScreen::behind(gpu, "preview", preview.shader, &[&bound.layout, &material.layout])?;
    let targets = Targets::new(gpu, width, height, false)?;
    let _phase = progress.phase("drawing", 1);
    let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    gpu.checked("drawing commands", || {
        drop(targets.depth_pass(&mut encoder));
        pipeline.draw(&mut targets.sky_pass(&mut encoder), &[&bound.group, &material.group]);
    })?;
    gpu.queue.submit([encoder.finish()]);
    gpu.wait()?;
    resolve(gpu, &targets.radiance, preview.supersampling)
}

/// The shader's unit is half a side of the square; its scene lies around the middle of a flat map of 2 × 2 texels.
fn bind(gpu: &Gpu, preview: &Preview<'_>) -> Result<Bound> {
    let unit = preview.size * 0.5;
    let place = |x: f64, y: f64, z: f64| [(x + 1.0) * unit, y * unit, (z + 1.0) * unit];
    let [width, height] = preview.image;
    // As wide as square and ball need, whatever the picture's shape.
    let tall = 2.65 / (f64::from(width) / f64::from(height)).min(2.2) / 5.8;
    let fov = 2.0 * tall.atan().to_degrees();
    let camera = Camera { eye: place(0.0, 3.1, 5.4), target: place(0.0, 0.55, 0.0), fov };
    let view = camera.view(width, height)?;
    let field = HeightField::new([2, 2], [unit, unit], vec![0.0; 4])?;
    let atmosphere = Atmosphere::new(TURBIDITY, sun_direction(SUN[0], SUN[1]));
    let lights = Lights::new(&atmosphere, [0.0, 1.0], 0.0, 1.0);
    let sky = SkyTable::new(&atmosphere, 2.0, lights.low.sky);
    let aerial =
        Aerial { cells: vec![DVec3::ZERO; super::air::AERIAL_CELLS.iter().product::<u32>() as usize], reach: 1.0 };
    let light = LightMap {
        horizon_size: [1, 1],
        horizon: vec![OPEN],
        sky_size: [1, 1],
        sky: vec![Vec4::Y],
        images: vec![Vec4::splat(OPEN)],
    };
    let samples = preview.image.map(|side| side * preview.supersampling);
    let uniform = ViewUniform::new(&view, &field, &atmosphere, &lights, aerial.reach, samples);
    Bound::new(
        gpu,
        &Tables {
            view: uniform,
            objects: ObjectsUniform::none(),
            lights: &lights,
            sky: &sky,
            aerial: &aerial,
            field: &field,
            light: &light,
        },
    )
}
