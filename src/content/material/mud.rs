//! Mud: dried into plates that curl at their borders, or wet with puddles in the hollows.

use super::super::cells::{Cells, Near};
use super::super::color::{Paint, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{hash, mix as scramble, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;

/// Height and what made it.
struct Ground {
    height: Field,
    /// 1 in the middle of a crack.
    crack: Field,
}

/// A tile of about 2 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed, wet) = (arguments.size(), arguments.seed(), arguments.get("wet"));
    let ground = shape(n, seed, arguments.get("cracks"));
    let height = ground.height.evened(n as f32 / 6.0, 0.35).normalised(0.0005, 0.9995);
    let sky = height.sky(n as f32 * 0.05, n as f32 * 0.04);
    let albedo = paint(&height, &ground.crack, &sky, seed, wet).evened(n as f32 / 7.0, 0.19 - 0.11 * wet);
    Material { height, albedo }
}

fn shape(n: usize, seed: u32, cracks: f32) -> Ground {
    let warp = Noise::new(seed ^ 0x11, 7, 5).gain(0.55);
    let (lumps, fine) = (Noise::new(seed ^ 0x12, 6, 5), Noise::new(seed ^ 0x13, 45, 5).gain(0.65));
    let dry = Noise::new(seed ^ 0x14, 3, 4);
    let at = |x: usize, y: usize| ((x as f32 + 0.5) / n as f32, (y as f32 + 0.5) / n as f32);
    let plates = |x: usize, y: usize| {
        let (u, v) = at(x, y);
        let (wu, wv) = (u + 0.022 * warp.fbm(u, v), v + 0.022 * warp.fbm(v + 0.3, u + 0.7));
        let opened = step(-0.7, 0.35, dry.fbm(u, v) + 1.4 * cracks - 0.8);
        (Cells::new(seed, 8).near(wu, wv), Cells::new(seed ^ 1, 25).near(wu, wv), opened)
    };
    let crack = Field::texels(n, |x, y| {
        let (large, small, opened) = plates(x, y);
        (gap(&large, 0.06 * opened)).max(0.65 * gap(&small, 0.075 * opened) * step(0.3, 0.9, opened)) * opened
    });
    let height = Field::texels(n, |x, y| {
        let (u, v) = at(x, y);
        let (large, small, opened) = plates(x, y);
        let curl = 0.14 * rim(&large, 0.22) + 0.05 * rim(&small, 0.25);
        let level = 0.14 * (unit(scramble(large.id)) - 0.5) + 0.05 * (unit(scramble(small.id)) - 0.5);
        let smooth = 0.55 * lumps.fbm(u, v) + 0.07 * fine.fbm(u, v);
        smooth + opened * (curl + level) - 0.5 * crack.at(x, y)
    });
    Ground { height, crack }
}

/// 1 in the middle of the gap between plates.
fn gap(near: &Near, width: f32) -> f32 {
    if width <= 0.002 { 0.0 } else { 1.0 - step(0.35 * width, width, near.border) }
}

/// The border of a drying plate rises.
fn rim(near: &Near, width: f32) -> f32 {
    let t = (1.0 - near.border / width).clamp(0.0, 1.0);
    t * t
}

fn paint(height: &Field, crack: &Field, sky: &Field, seed: u32, wet: f32) -> Paint {
    let n = height.size;
    let (broad, fine) = (Noise::new(seed ^ 0x21, 6, 5), Noise::new(seed ^ 0x22, 50, 5).gain(0.7));
    let low = height.blurred(n as f32 / 40.0);
    Paint::build(n, |x, y, u, v| {
        let (b, f) = (broad.fbm(u, v), fine.fbm(u, v));
        let mut color = mix(hex(0x8a7860), hex(0x9c8a72), step(-0.4, 0.5, b + 0.5 * f));
        color = mix(color, hex(0x75654f), 0.6 * step(0.0, 0.5, f));
        // Low ground stays damp longest.
        let damp = (step(0.62, 0.3, low.at(x, y) + 0.12 * b) * 0.75 + wet * 0.75).min(1.0);
        color = mix(color, hex(0x53442f), damp * (0.5 + 0.4 * wet));
        color = mix(color, hex(0x2c241b), 0.8 * crack.at(x, y));
        let grain = unit(hash(seed ^ 0x23, x as u32, y as u32)) - 0.5;
        scale(color, (1.0 + 0.12 * grain + 0.18 * f) * (0.4 + 0.6 * step(0.2, 0.95, sky.at(x, y))))
    })
}
