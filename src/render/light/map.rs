//! The light map: what the shader reads of terrain-scale light.

use glam::{DVec2, DVec3, Vec3, Vec4};
use rayon::prelude::*;

use super::horizon::{Horizons, OPEN};
use super::visibility::{sky_lines, sky_visibility};
use crate::render::height_field::HeightField;
use crate::render::progress::Progress;

/// The sky varies slowly over the ground: this many texels on a side are enough.
const SKY_TEXELS: u32 = 1024;

/// Metres over which ground lights ground.
const BOUNCE_REACH: f64 = 120.0;

/// Light at terrain scale.
#[derive(Clone, Debug)]
pub struct LightMap {
    /// Texels of `horizon`.
    pub horizon_size: [u32; 2],
    /// Tangent of the horizon under the sun.
    pub horizon: Vec<f32>,
    /// Texels of `sky`.
    pub sky_size: [u32; 2],
    /// [`super::SkyVisibility`] in xyz; in w the part of the sun's irradiance that the ground around receives on average.
    pub sky: Vec<Vec4>,
}

/// Computes the light map: `shadow` asks for the sun's, `directions` (0 for none) for the sky's.
#[must_use]
pub fn light_map(field: &HeightField, sun: DVec3, shadow: bool, directions: u32, progress: Progress) -> LightMap {
    let horizon = if shadow { sun_horizon(field, sun, progress) } else { vec![OPEN] };
    let horizon_size = if shadow { field.size() } else { [1, 1] };
    let mut coarse = field.clone();
    while coarse.size().iter().any(|&side| side > SKY_TEXELS) {
        coarse = coarse.halved();
    }
    let sunny = sunny_ground(field, &horizon, sun);
    if directions == 0 {
        let mean = sunny.iter().map(|&s| f64::from(s)).sum::<f64>() / sunny.len() as f64;
        return LightMap { horizon_size, horizon, sky_size: [1, 1], sky: vec![Vec3::Y.extend(mean as f32)] };
    }
    let phase = progress.phase("sky visibility", sky_lines(&coarse, directions));
    let vectors = sky_visibility(&coarse, directions, &|lines| phase.advance(lines)).vectors;
    let around = blurred(shrunk(sunny, field, &coarse), &coarse);
    let sky = vectors.into_iter().zip(around).map(|(vector, sun)| vector.extend(sun)).collect();
    LightMap { horizon_size, horizon, sky_size: coarse.size(), sky }
}

fn sun_horizon(field: &HeightField, sun: DVec3, progress: Progress) -> Vec<f32> {
    let direction = DVec2::new(sun.x, sun.z);
    let phase = progress.phase("sun horizon", Horizons::lines(field, direction));
    Horizons::new(field, direction, &|lines| phase.advance(lines)).tangents
}

/// Cosine to the sun for each texel, 0 in shadow.
fn sunny_ground(field: &HeightField, horizon: &[f32], sun: DVec3) -> Vec<f32> {
    let columns = field.size()[0] as usize;
    let sun_tangent = (sun.y / sun.x.hypot(sun.z).max(1e-9)) as f32;
    let [dx, dz] = field.spacing().map(|metres| (0.5 / metres) as f32);
    let sun = sun.as_vec3();
    let mut lit = vec![0.0; field.texels().len()];
    lit.par_chunks_mut(columns).enumerate().for_each(|(row, lit)| {
        for (column, lit) in lit.iter_mut().enumerate() {
            let at = |i, j| field.at(column as i64 + i, row as i64 + j);
            let normal = Vec3::new((at(-1, 0) - at(1, 0)) * dx, 1.0, (at(0, -1) - at(0, 1)) * dz).normalize();
            let tangent = horizon.get(row * columns + column).copied().unwrap_or(OPEN);
            *lit = if tangent < sun_tangent { normal.dot(sun).max(0.0) } else { 0.0 };
        }
    });
    lit
}

/// Halves a map until it is as small as `coarse`.
fn shrunk(texels: Vec<f32>, field: &HeightField, coarse: &HeightField) -> Vec<f32> {
    let mut size = field.size();
    let mut texels = texels;
    while size != coarse.size() {
        let smaller = size.map(|side| side.div_ceil(2).max(2));
        let at = |x: u32, z: u32| texels[(z.min(size[1] - 1) * size[0] + x.min(size[0] - 1)) as usize];
        texels = (0..smaller[0] * smaller[1])
            .map(|i| (2 * (i % smaller[0]), 2 * (i / smaller[0])))
            .map(|(x, z)| (at(x, z) + at(x + 1, z) + at(x, z + 1) + at(x + 1, z + 1)) * 0.25)
            .collect();
        size = smaller;
    }
    texels
}

/// Three box filters on each axis: close to a Gaussian whose reach is [`BOUNCE_REACH`].
fn blurred(mut texels: Vec<f32>, field: &HeightField) -> Vec<f32> {
    let [columns, rows] = field.size().map(|side| side as usize);
    let [reach_x, reach_z] = field.spacing().map(|metres| (BOUNCE_REACH / (3.0 * metres)).round() as usize);
    for _ in 0..3 {
        texels.par_chunks_mut(columns).for_each(|row| box_filter(row, reach_x));
        let mut turned: Vec<f32> = (0..columns * rows).map(|i| texels[i % rows * columns + i / rows]).collect();
        turned.par_chunks_mut(rows).for_each(|column| box_filter(column, reach_z));
        texels = (0..columns * rows).map(|i| turned[i % columns * rows + i / columns]).collect();
    }
    texels
}

/// The mean of the texels up to `reach` away, those on the line only.
fn box_filter(line: &mut [f32], reach: usize) {
    let mut sums = Vec::with_capacity(line.len() + 1);
    sums.push(0.0_f64);
    for (i, &texel) in line.iter().enumerate() {
        sums.push(sums[i] + f64::from(texel));
    }
    for (i, texel) in line.iter_mut().enumerate() {
        let (from, to) = (i.saturating_sub(reach), (i + reach + 1).min(sums.len() - 1));
        *texel = ((sums[to] - sums[from]) / (to - from) as f64) as f32;
    }
}
