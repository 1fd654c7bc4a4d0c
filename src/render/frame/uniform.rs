//! `HostView` of shaderlib/hosts/wgpu/view.wgsl, byte for byte.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Mat4};

use crate::render::air::{Atmosphere, Medium, SUN_RADIUS};
use crate::render::camera::View;
use crate::render::height_field::HeightField;
use crate::render::lights::Lights;

/// The uniform block of group 0. Members in the order and with the names of the shader's.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct ViewUniform {
    clip: Mat4,
    right: [f32; 3],
    eye_height: f32,
    up: [f32; 3],
    aerial_reach: f32,
    forward: [f32; 3],
    sun_radius: f32,
    sun: [f32; 3],
    low: f32,
    sun_low: [f32; 3],
    height_range: f32,
    sun_high: [f32; 3],
    rayleigh_fall: f32,
    sun_disc: [f32; 3],
    haze_fall: f32,
    rayleigh: [f32; 3],
    unused_1: f32,
    haze: [f32; 3],
    unused_2: f32,
    sky: [[f32; 4]; 9],
    eye_texel: [i32; 2],
    eye_offset: [f32; 2],
    spacing: [f32; 2],
    pixels: [f32; 2],
}

impl ViewUniform {
    /// Fills the block for a picture of that many samples.
    pub(crate) fn new(
        view: &View,
        field: &HeightField,
        atmosphere: &Atmosphere,
        lights: &Lights,
        aerial_reach: f64,
        samples: [u32; 2],
    ) -> Self {
        let Medium { rayleigh, haze_extinction, .. } = *atmosphere.medium();
        let vector = |v: DVec3| v.as_vec3().to_array();
        let light = |v: DVec3| lights.expose(v).to_array();
        let place = [view.eye.x, view.eye.z];
        let eye_texel = [0, 1].map(|axis| (place[axis] / field.spacing()[axis] - 0.5).round());
        let eye_offset = [0, 1].map(|axis| (place[axis] - (eye_texel[axis] + 0.5) * field.spacing()[axis]) as f32);
        let [low, high] = field.range();
        // Radiance of a disc of that irradiance whose edge is darkened: the mean over the disc is 2 / (2 + exponent) of
        // the middle's, about 0.8.
        let disc = atmosphere.sun_irradiance(view.eye.y) / (std::f64::consts::PI * SUN_RADIUS * SUN_RADIUS * 0.8);
        Self {
            clip: view.clip_from_eye(),
            right: vector(view.right * view.half[0]),
            eye_height: view.eye.y as f32,
            up: vector(view.up * view.half[1]),
            aerial_reach: aerial_reach as f32,
            forward: vector(view.forward),
            sun_radius: SUN_RADIUS.tan() as f32,
            sun: vector(atmosphere.sun()),
            low,
            sun_low: light(lights.low.sun),
            height_range: (high - low).max(1.0),
            sun_high: light(lights.sun_high),
            rayleigh_fall: (1.0 / Medium::RAYLEIGH_HEIGHT) as f32,
            sun_disc: light(disc),
            haze_fall: (1.0 / Medium::HAZE_HEIGHT) as f32,
            rayleigh: vector(rayleigh),
            unused_1: 0.0,
            haze: vector(haze_extinction),
            unused_2: 0.0,
            sky: lights.low.harmonics.0.map(|colour| lights.expose(colour).extend(0.0).to_array()),
            eye_texel: eye_texel.map(|texel| texel as i32),
            eye_offset,
            spacing: field.spacing().map(|metres| metres as f32),
            pixels: samples.map(|side| side as f32),
        }
    }
}
