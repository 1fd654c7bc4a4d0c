//! Snow that the wind has packed: sastrugi cut into it, drifts behind them, a crust with fine grain.

use super::super::color::{Paint, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;

/// A tile of about 6 m; the wind blows along +u.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size(), arguments.seed());
    let height = shape(n, seed, arguments.get("wind")).normalised(0.0003, 0.9997);
    let sky = height.sky(n as f32 * 0.05, n as f32 * 0.05);
    let albedo = paint(n, seed, &height, &sky).evened(n as f32 / 8.0, 0.84);
    Material { height, albedo }
}

fn shape(n: usize, seed: u32, wind: f32) -> Field {
    let warp = Noise::new(seed ^ 0x11, 3, 5);
    let drift = Noise::new(seed ^ 0x12, 1, 4).stretched(3, 5);
    let tongue = Noise::new(seed ^ 0x13, 1, 5).stretched(4, 13).gain(0.5);
    let ripple = Noise::new(seed ^ 0x14, 1, 4).stretched(11, 34).gain(0.55);
    let crust = Noise::new(seed ^ 0x15, 60, 4).gain(0.7);
    Field::texels(n, |x, y| {
        let (u, v) = ((x as f32 + 0.5) / n as f32, (y as f32 + 0.5) / n as f32);
        let (a, b) = (warp.fbm(u, v), warp.fbm(v + 0.5, u + 0.2));
        let (wu, wv) = (u + 0.06 * a, v + 0.045 * b);
        let soft = drift.fbm(wu, wv);
        // Tongues: eroded from below upwind, so one end is a sharp lip. The shear makes the lip.
        let t = tongue.fbm(wu, wv);
        let t = tongue.fbm(wu + 0.035 * t, wv);
        let lip = step(-0.05, 0.3, t) * 0.35 + (t * 1.4).max(-0.35);
        let groove = ripple.ridged(wu + 0.02 * t, wv + 0.01 * b);
        let hard = step(-0.2, 0.35, soft + 0.5 * a);
        let grain = unit(hash(seed, x as u32, y as u32)) - 0.5;
        soft * 0.9 + wind * hard * (0.8 * lip - 0.32 * groove) + 0.035 * crust.fbm(u, v) + 0.012 * grain
    })
    .blurred(n as f32 / 1400.0)
}

fn paint(n: usize, seed: u32, height: &Field, sky: &Field) -> Paint {
    let (age, dirt) = (Noise::new(seed ^ 0x21, 5, 5), Noise::new(seed ^ 0x22, 30, 5).gain(0.7));
    let edge = height.above(n as f32 / 120.0);
    Paint::build(n, |x, y, u, v| {
        let old = step(-0.3, 0.5, age.fbm(u, v));
        let mut color = mix(hex(0xf3f5f8), hex(0xe9eef3), old);
        color = mix(color, hex(0xdfe8f2), 0.8 * step(0.92, 0.55, sky.at(x, y)));
        // Dust settles where the wind has cut old layers free.
        color = mix(color, hex(0xd9d6d0), 0.35 * step(0.25, 0.75, dirt.fbm(u, v) + 0.25 * old - 2.0 * edge.at(x, y)));
        let grain = unit(hash(seed ^ 0x23, x as u32, y as u32)) - 0.5;
        scale(color, 1.0 + 0.02 * grain + (edge.at(x, y) * 0.5).clamp(-0.06, 0.03))
    })
}
