//! Scree: angular fragments of all sizes, the small ones filling the gaps between the large ones.

use super::super::canvas::Canvas;
use super::super::color::{Paint, Rgb, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;
use super::stone::{Fragment, Layer, pile};

/// A tile of about 3 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size() * 2, arguments.seed());
    let canvas = heap(n, seed, arguments.get("largest"));
    let rough = Noise::new(seed ^ 0x91, 48, 5).gain(0.6);
    let texel = n as f32 / 1024.0;
    let height = Field::build(n, |u, v| rough.fbm(u, v)).zip(&canvas.height, |r, h| h + 2.2 * texel * r);
    let sky = height.halved().sky(0.5, n as f32 * 0.015);
    let albedo = paint(&canvas, &height, &sky, seed).halved().evened(n as f32 / 16.0, 0.21);
    Material { height: height.halved().evened(n as f32 / 12.0, 0.3).normalised(0.002, 0.9995), albedo }
}

fn heap(n: usize, seed: u32, largest: f32) -> Canvas {
    let ground = Noise::new(seed ^ 0x81, 9, 5);
    let mut canvas = Canvas::new(Field::build(n, |u, v| ground.fbm(u, v) * n as f32 * 0.006));
    let layers = [
        Layer { count: 9000, small: 0.0025, large: 0.008, power: 1.5, sunk: 0.3 },
        Layer { count: 3400, small: 0.007, large: largest, power: 1.8, sunk: 0.35 },
        Layer { count: 1600, small: 0.005, large: 0.4 * largest, power: 1.6, sunk: 0.2 },
    ];
    pile(&mut canvas, seed, &layers, |canvas, radius, sunk, center, random| {
        Fragment::new(radius, random).lay(canvas, center, sunk);
    });
    canvas
}

fn paint(canvas: &Canvas, height: &Field, sky: &Field, seed: u32) -> Paint {
    let n = canvas.size();
    let (stain, grain) = (Noise::new(seed ^ 0x92, 10, 6).gain(0.65), Noise::new(seed ^ 0x93, 90, 3));
    let stain = Field::build(n / 2, |u, v| stain.fbm(u, v));
    let grain = Field::build(n / 2, |u, v| grain.fbm(u, v));
    let edge = height.above(n as f32 / 350.0);
    let texel = n as f32 / 1024.0;
    Paint::build(n, |x, y, _, _| {
        let index = y * n + x;
        let owner = canvas.owner[index];
        // Each stone has its own piece of the pattern.
        let (s, g) = (stain.coarse(x, y, n, hash(seed, owner, 2)), grain.coarse(x, y, n, 0));
        let mut color = mix(stone(hash(seed, owner, 1)), hex(0x8d7d69), 0.4 * step(0.05, 0.5, s));
        if owner == 0 {
            color = mix(hex(0x6b6257), hex(0x857b6d), step(-0.4, 0.4, g));
        }
        color = scale(color, 1.0 + 0.16 * g + (edge.data[index] / texel * 0.035).clamp(-0.22, 0.3));
        let open = step(0.12, 0.9, sky.coarse(x, y, n, 0));
        // Fines and damp gather where little sky is seen.
        color = mix(hex(0x4e463c), color, 0.25 + 0.75 * open);
        scale(color, 0.3 + 0.7 * open)
    })
}

/// Mostly grey, some warm, a few rusty or nearly white.
fn stone(id: u32) -> Rgb {
    let base = match id >> 24 {
        0..=110 => hex(0x8b8884),
        111..=170 => hex(0x9b9389),
        171..=205 => hex(0x77736f),
        206..=228 => hex(0x8c8074),
        229..=244 => hex(0x82756a),
        _ => hex(0xbab5ab),
    };
    scale(base, 0.75 + 0.5 * unit(id.rotate_left(9)))
}
