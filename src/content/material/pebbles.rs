//! River stones: rounded by water, of many rocks, with sand between them.

use super::super::canvas::Canvas;
use super::super::color::{Paint, Rgb, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;
use super::stone::{Layer, Pebble, pile};

/// A tile of about 2 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size() * 2, arguments.seed());
    let canvas = bed(n, seed, arguments.get("largest"), arguments.get("sand"));
    let rough = Noise::new(seed ^ 0x91, 80, 4).gain(0.6);
    let texel = n as f32 / 1024.0;
    let height = Field::build(n, |u, v| rough.fbm(u, v)).zip(&canvas.height, |r, h| h + 0.7 * texel * r);
    let sky = height.halved().sky(0.5, n as f32 * 0.015);
    let albedo = paint(&canvas, &sky, seed).halved().evened(n as f32 / 16.0, 0.19);
    Material { height: height.halved().evened(n as f32 / 12.0, 0.3).normalised(0.002, 0.9998), albedo }
}

fn bed(n: usize, seed: u32, largest: f32, sand: f32) -> Canvas {
    let side = n as f32;
    let (ground, grain) = (Noise::new(seed ^ 0x81, 7, 4), Noise::new(seed ^ 0x82, 120, 3));
    let level = (sand - 0.25) * 0.02;
    let mut canvas =
        Canvas::new(Field::build(n, |u, v| (ground.fbm(u, v) * 0.008 + grain.fbm(u, v) * 0.0008 + level) * side));
    let layers = [
        Layer { count: 5000, small: 0.003, large: 0.007, power: 1.3, sunk: 0.45 },
        Layer { count: 2600, small: 0.007, large: largest, power: 1.6, sunk: 0.4 },
        Layer { count: 1800, small: 0.004, large: 0.3 * largest, power: 1.5, sunk: 0.35 },
    ];
    pile(&mut canvas, seed, &layers, |canvas, radius, sunk, center, random| {
        Pebble::new(radius, random).lay(canvas, center, sunk);
    });
    canvas
}

fn paint(canvas: &Canvas, sky: &Field, seed: u32) -> Paint {
    let n = canvas.size();
    let (mottle, grain) = (Noise::new(seed ^ 0x92, 24, 5).gain(0.65), Noise::new(seed ^ 0x93, 140, 3));
    let vein = Noise::new(seed ^ 0x94, 12, 4);
    let mottle = Field::build(n / 2, |u, v| mottle.fbm(u, v));
    let grain = Field::build(n / 2, |u, v| grain.fbm(u, v));
    let vein = Field::build(n / 2, |u, v| 1.0 - step(0.0, 0.05, vein.fbm(u, v).abs()));
    Paint::build(n, |x, y, _, _| {
        let index = y * n + x;
        let (owner, g) = (canvas.owner[index], grain.coarse(x, y, n, 0));
        let open = step(0.1, 0.92, sky.coarse(x, y, n, 0));
        let sand = scale(mix(hex(0x8a7a63), hex(0xa3937a), step(-0.4, 0.4, g)), 0.85 + 0.3 * (g + 0.5).clamp(0.0, 1.0));
        if owner == 0 {
            return scale(sand, 0.4 + 0.6 * open);
        }
        // Each stone has its own piece of the pattern.
        let (id, shift) = (hash(seed, owner, 1), hash(seed, owner, 2));
        let mut color = scale(stone(id), 1.0 + 0.3 * mottle.coarse(x, y, n, shift) + 0.12 * g);
        if id & 7 == 0 {
            color = mix(color, hex(0xbfb9ad), 0.8 * vein.coarse(x, y, n, shift));
        }
        // Dust and dried silt lie around the foot of a stone.
        color = mix(color, sand, 0.55 * step(0.55, 0.15, canvas.place[index].0));
        scale(color, 0.28 + 0.72 * open)
    })
}

fn stone(id: u32) -> Rgb {
    let base = match id >> 24 {
        0..=70 => hex(0x82817f),
        71..=120 => hex(0x8f8a80),
        121..=160 => hex(0x6a6a6b),
        161..=190 => hex(0x877d70),
        191..=210 => hex(0x75665d),
        211..=228 => hex(0x4f5152),
        229..=243 => hex(0x7c8079),
        _ => hex(0xb2ada3),
    };
    scale(base, 0.72 + 0.56 * unit(id.rotate_left(9)))
}
