//! Shadow and occlusion over points of a map on one device.

use std::time::Duration;

use terrane_shaderlib::heightfield::Heights;
use terrane_shaderlib::heightfield::Ray;
use terrane_shaderlib::heightfield::visibility::Sun;
use terrane_shaderlib::relief::{Bounds, Method, Placed};

use super::setup::{DeviceRay, LONGEST, Setup};
use super::shader::with_call;
use super::tracer::Tracer;
use crate::render::{Gpu, RenderError};

/// What is asked of the light at a point, and how the answer is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lighting {
    /// `shadow_hard.wgsl`: the sun's middle, seen or not.
    Hard,
    /// `shadow_wide.wgsl`: the same with fewer loads.
    HardWide,
    /// `shadow_soft_parallax.wgsl` as published: seven samples.
    ParallaxPublished,
    /// `shadow_soft_parallax.wgsl`: samples along the ray.
    Parallax(u32),
    /// `shadow_fast_horizon.wgsl` as published: five taps.
    Published,
    /// `shadow_fast_horizon.wgsl`: taps that double their distance.
    FastHorizon(u32),
    /// `shadow_cone.wgsl`: planes through the sun's disc; nodes up to so many radii of the cone are taken as they are.
    Cone(u32, f32),
    /// `occlusion_directions.wgsl`: the sky over so many directions, turned from point to point or not, by horizons whose tangents
    /// may be so much too small.
    Sky(u32, Turn, f32),
    /// The same by so many taps of the fast horizon.
    FastSky(u32, Turn, u32),
}

/// Where the directions of occlusion begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// At +x everywhere.
    Fixed,
    /// Turned at each point by another part of a step, evenly spread.
    Jittered,
}

/// The map as land, and what lights it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scene {
    /// The sun; occlusion does without.
    pub sun: Sun,
    /// Steps of height that are as long as a texel is wide.
    pub steps: f64,
    /// Texels beyond which nothing is looked at.
    pub reach: f64,
}

/// What a point sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// The share of the light, 0..1; none where the search was given up.
    pub share: Option<f64>,
    /// Nodes or samples read.
    pub steps: u32,
    /// Patches loaded besides the point's own, four texels each.
    pub leaves: u32,
}

impl Lighting {
    /// What it knows of the map.
    #[must_use]
    pub fn bounds(self) -> Bounds {
        match self {
            Self::Hard | Self::Cone(..) | Self::Sky(..) => Bounds::CellMax,
            Self::HardWide => Bounds::Wide,
            Self::ParallaxPublished
            | Self::Parallax(_)
            | Self::Published
            | Self::FastHorizon(_)
            | Self::FastSky(..) => Bounds::None,
        }
    }

    /// The method whose textures it reads.
    fn method(self) -> Method {
        match self {
            Self::HardWide => Method::ShadowWide,
            _ => Method::ShadowHard,
        }
    }

    /// WGSL that answers it for points from a buffer: an entry point, and what it needs of the library. No texel is higher than
    /// `lid`, in steps.
    #[must_use]
    pub fn shader(self, scene: &Scene, lid: f64) -> String {
        let reach = float(scene.reach.min(LONGEST));
        let answer = self.answer(scene, lid);
        let answer = ANSWER.replace("LIFT", &float(LIFT)).replace("REACH", &reach).replace("SEEN", &answer);
        with_call(self.method(), "relief_answer(index, ray)", &answer)
    }

    /// What becomes of `own`, the heights around a point, and of `point`, the ray from there.
    fn answer(self, scene: &Scene, lid: f64) -> String {
        let (steps, radius, full) = (float(scene.steps), float(scene.sun.radius), float(lid.max(1.0)));
        let maps = "relief_heights, relief_bounds, relief_field";
        match self {
            Self::Hard | Self::HardWide => {
                let name = self.method();
                format!("relief_lit({name}_trace({maps}, shadow_under(point, {full}), own))")
            }
            Self::Parallax(samples) => format!(
                "relief_seen(shadow_soft_parallax_share(relief_heights, relief_field, \
                 shadow_under(point, {full}), {steps}, {radius}, {samples}u))"
            ),
            Self::ParallaxPublished => format!(
                "relief_seen(shadow_soft_parallax_published(relief_heights, relief_field, ray.cell, ray.origin.xy, {}, \
                 0.58, {full}))",
                published(scene, lid)
            ),
            Self::Published => {
                let light = published(scene, lid);
                let weights = "array<f32, 5>(2.0, 1.7, 1.4, 1.2, 1.0)";
                format!(
                    "relief_seen(shadow_fast_horizon_published(relief_heights, relief_field, ray.cell, ray.origin.xy, \
                     {light}, {weights}, 4.0, {full}))"
                )
            }
            Self::FastHorizon(taps) => {
                let point = format!("relief_field, point, {steps}, {radius}, {taps}u");
                format!("relief_seen(shadow_fast_horizon_share(relief_heights, {point}))")
            }
            Self::Cone(planes, coarse) => format!(
                "relief_seen(shadow_cone_share({maps}, point, own, {steps}, {radius}, {full}, {planes}u, {coarse:?}f))"
            ),
            Self::Sky(directions, turn, tolerance) => {
                let sky = sky(directions, turn, &steps);
                format!(
                    "relief_seen(occlusion_directions_search({maps}, point, own, {sky}, {full}, {directions}u, \
                     {tolerance:?}f))"
                )
            }
            Self::FastSky(directions, turn, taps) => {
                let sky = sky(directions, turn, &steps);
                let point = format!("relief_field, point, {sky}, {directions}u, {taps}u");
                format!("relief_seen(occlusion_directions_fast(relief_heights, {point}))")
            }
        }
    }
}

/// The published ones' light over the ground, in texels: a vector of length 1 in space times the depth of the relief.
fn published(scene: &Scene, lid: f64) -> String {
    format!("normalize(ray.direction.xy) * {}", float(lid / scene.steps / scene.sun.tangent.hypot(1.0)))
}

fn sky(directions: u32, turn: Turn, steps: &str) -> String {
    let turn = match turn {
        Turn::Fixed => "0.0f".to_owned(),
        // Multiples of the golden ratio.
        Turn::Jittered => {
            format!("fract(f32(index % 65536u) * 0.618034f) * {}", float(std::f64::consts::TAU / f64::from(directions)))
        }
    };
    format!("relief_normal(own, ray.origin.xy, {steps}), {steps}, {turn}")
}

/// A literal of a finite number.
fn float(value: f64) -> String {
    format!("{:?}f", value as f32)
}

/// Steps above the surface at which a ray starts: at least twice what rounding moves it.
pub const LIFT: f64 = 2.0;

/// From what is stored to what the library asks for, and back.
const ANSWER: &str = "
fn relief_answer(index: u32, ray: ReliefRay) -> ReliefHit {
    let own = relief_corners(relief_heights, relief_field, ray.cell, vec2i(0i));
    let point = shadow_ray(own, relief_field, ray.cell, ray.origin.xy, ray.direction, LIFT, REACH);
    return SEEN;
}

fn relief_seen(seen: ShadowSeen) -> ReliefHit {
    return ReliefHit(seen.share, seen.state, vec2i(0), seen.steps, seen.leaves);
}

fn relief_lit(hit: ReliefHit) -> ReliefHit {
    let state = select(RELIEF_HIT, RELIEF_UNRESOLVED, hit.state == RELIEF_UNRESOLVED);
    return ReliefHit(select(0.0, 1.0, hit.state == RELIEF_MISS), state, vec2i(0), hit.steps, hit.leaves);
}
";

/// A question about the light over one map, ready to be asked.
#[derive(Debug)]
pub struct Lighter<'a> {
    tracer: Tracer<'a>,
    heights: &'a Heights,
    scene: Scene,
}

impl<'a> Lighter<'a> {
    /// Uploads the map and compiles the method; `placed` is the map with the bounds of the method.
    ///
    /// # Errors
    /// [`RenderError::Refused`] where the device takes no part of it.
    pub fn new(
        gpu: &'a Gpu,
        heights: &'a Heights,
        placed: &Placed,
        lighting: Lighting,
        scene: Scene,
    ) -> Result<Self, RenderError> {
        let text = lighting.shader(&scene, placed.range[1]);
        let tracer = Tracer::compiled(gpu, heights, placed, lighting.method(), &text)?;
        Ok(Self { tracer, heights, scene })
    }

    /// What points of the surface see, and how long the device took. Positions in texels, on a clamped map inside it.
    ///
    /// # Errors
    /// [`RenderError::Lost`] where the device fails.
    pub fn see(&self, points: &[[f64; 2]]) -> Result<(Vec<Seen>, Duration), RenderError> {
        let sent: Vec<DeviceRay> = points.iter().map(|point| self.ray(*point)).collect();
        if sent.is_empty() {
            return Ok((Vec::new(), Duration::ZERO));
        }
        let (hits, time) = self.tracer.run(&sent)?;
        let seen = hits.iter().map(|hit| Seen {
            share: (hit.state != 2).then_some(f64::from(hit.t)),
            steps: hit.steps,
            leaves: hit.leaves,
        });
        Ok((seen.collect(), time))
    }

    /// Where a point is, and the way to the sun's middle: the shader makes a ray of it.
    fn ray(&self, [x, y]: [f64; 2]) -> DeviceRay {
        let Sun { towards: [east, north], tangent, .. } = self.scene.sun;
        let ray = Ray { origin: [x, y, 0.0], direction: [east, north, tangent * self.scene.steps] };
        Setup::at(self.heights, &ray).ray
    }
}
