//! The light map: what the shader reads of terrain-scale light.

use glam::{DVec2, DVec3, Vec3, Vec4};
use rayon::prelude::*;

use super::horizon::{Horizons, Land, OPEN};
use super::visibility::{sky_lines, sky_visibility};
use crate::render::height_field::HeightField;
use crate::render::progress::Progress;

/// The sky varies slowly over the ground: this many texels on a side are enough.
const SKY_TEXELS: u32 = 1024;

/// Metres from the border at which land beyond it still hides sky.
const SKY_REACH: f64 = 1000.0;

/// Metres over which ground lights ground.
const BOUNCE_REACH: f64 = 120.0;

/// What is asked of a light map.
#[derive(Clone, Copy, Debug)]
pub struct LightSettings {
    /// Unit vector to the sun.
    pub sun: DVec3,
    /// Whether the terrain hides the sun.
    pub shadow: bool,
    /// Directions in which the sky is looked at, 0 for an open one.
    pub directions: u32,
    /// Whether mirror images of the terrain lie around it.
    pub surroundings: bool,
}

/// Light at terrain scale.
#[derive(Clone, Debug)]
pub struct LightMap {
    /// Texels of `horizon`.
    pub horizon_size: [u32; 2],
    /// Tangent of the horizon under the sun.
    pub horizon: Vec<f32>,
    /// Texels of `sky` and `images`.
    pub sky_size: [u32; 2],
    /// [`super::SkyVisibility`] in xyz; in w the part of the sun's irradiance that the ground around receives on average.
    pub sky: Vec<Vec4>,
    /// Tangent of the horizon under the sun where the terrain is mirrored on neither axis, x, z, both.
    pub images: Vec<Vec4>,
}

/// Computes the light map.
#[must_use]
pub fn light_map(field: &HeightField, settings: LightSettings, progress: Progress) -> LightMap {
    let LightSettings { sun, shadow, directions, surroundings } = settings;
    let sky_reach = if surroundings { SKY_REACH } else { 0.0 };
    let sun_reach = if surroundings { shadow_length(field, sun) } else { 0.0 };
    let horizon = if shadow { sun_horizon(Land { field, beyond: sun_reach }, sun, progress) } else { vec![OPEN] };
    let horizon_size = if shadow { field.size() } else { [1, 1] };
    let coarse = coarse(field);
    let size = if directions > 0 || (shadow && surroundings) { coarse.size() } else { [1, 1] };
    let texels = (size[0] * size[1]) as usize;
    let images = if shadow && surroundings {
        image_horizons(Land { field: &coarse, beyond: sun_reach }, sun, progress)
    } else {
        vec![Vec4::splat(OPEN); texels]
    };
    let around = blurred(shrunk(sunny_ground(field, &horizon, sun), field.size(), coarse.size()), &coarse);
    let sky = if directions > 0 {
        let land = Land { field: &coarse, beyond: sky_reach };
        let phase = progress.phase("sky visibility", sky_lines(land, directions));
        let vectors = sky_visibility(land, directions, &|lines| phase.advance(lines)).vectors;
        vectors.into_iter().zip(around).map(|(vector, sun)| vector.extend(sun)).collect()
    } else {
        let mean = around.iter().map(|&sun| f64::from(sun)).sum::<f64>() / around.len() as f64;
        vec![Vec3::Y.extend(mean as f32); texels]
    };
    LightMap { horizon_size, horizon, sky_size: size, sky, images }
}

/// The terrain with at most [`SKY_TEXELS`] on a side.
fn coarse(field: &HeightField) -> HeightField {
    let mut coarse = field.clone();
    while coarse.size().iter().any(|&side| side > SKY_TEXELS) {
        coarse = coarse.halved();
    }
    coarse
}

/// Metres behind the highest peak that its shadow can reach, and no more than the terrain's own length.
fn shadow_length(field: &HeightField, sun: DVec3) -> f64 {
    let [low, high] = field.range().map(f64::from);
    let longest = field.extent()[0].max(field.extent()[1]);
    ((high - low) * sun.x.hypot(sun.z) / sun.y.max(1e-6)).min(longest)
}

fn sun_horizon(land: Land<'_>, sun: DVec3, progress: Progress) -> Vec<f32> {
    let direction = DVec2::new(sun.x, sun.z);
    let phase = progress.phase("sun horizon", Horizons::lines(land, direction));
    Horizons::new(land, direction, &|lines| phase.advance(lines)).tangents
}

/// Seen from a mirror image, it is the sun that is mirrored.
fn image_horizons(land: Land<'_>, sun: DVec3, progress: Progress) -> Vec<Vec4> {
    let directions =
        [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]].map(|[x, z]| DVec2::new(x * sun.x, z * sun.z));
    let lines = directions.iter().map(|&direction| Horizons::lines(land, direction)).sum();
    let phase = progress.phase("sun horizon around", lines);
    let [itself, x, z, both] =
        directions.map(|direction| Horizons::new(land, direction, &|lines| phase.advance(lines)).tangents);
    (0..itself.len()).map(|i| Vec4::new(itself[i], x[i], z[i], both[i])).collect()
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

/// Halves a map until it has `coarse` texels.
fn shrunk(mut texels: Vec<f32>, mut size: [u32; 2], coarse: [u32; 2]) -> Vec<f32> {
    while size != coarse {
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
