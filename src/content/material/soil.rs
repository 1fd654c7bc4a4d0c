//! Bare soil: crumbs of all sizes, a few small stones, dead roots.

use super::super::canvas::{Canvas, Strand};
use super::super::color::{Paint, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{Random, hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;
use super::stone::{Fragment, Layer, Pebble, pile};

/// A tile of about 2 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size() * 2, arguments.seed());
    let (canvas, stones) = crumbs(n, seed, arguments.get("stones"));
    let rough = Noise::new(seed ^ 0x91, 60, 5).gain(0.7);
    let texel = n as f32 / 1024.0;
    let height = Field::build(n, |u, v| rough.fbm(u, v)).zip(&canvas.height, |r, h| h + 1.6 * texel * r).halved();
    let sky = height.sky(0.6, n as f32 * 0.015);
    let albedo = paint(&canvas, stones, &sky, seed).halved().evened(n as f32 / 16.0, 0.13);
    Material { height: height.evened(n as f32 / 12.0, 0.35).normalised(0.002, 0.9995), albedo }
}

/// The canvas, and the number of the first thing on it that is a stone.
fn crumbs(n: usize, seed: u32, stones: f32) -> (Canvas, std::ops::Range<u32>) {
    let side = n as f32;
    let (clods, fine) = (Noise::new(seed ^ 0x81, 7, 6), Noise::new(seed ^ 0x82, 40, 4).gain(0.7));
    let ground = Field::build(n, |u, v| (0.013 * clods.fbm(u, v) + 0.002 * fine.fbm(u, v)) * side);
    let mut canvas = Canvas::new(ground);
    let soil = [
        Layer { count: 6000, small: 0.0016, large: 0.006, power: 1.6, sunk: 0.5 },
        Layer { count: 900, small: 0.005, large: 0.024, power: 2.2, sunk: 0.6 },
    ];
    pile(&mut canvas, seed, &soil, |canvas, radius, sunk, center, random| {
        Pebble::new(radius, random).lay(canvas, center, sunk);
    });
    let first = canvas.laid() + 1;
    let grit = [Layer { count: (500.0 * stones) as u32, small: 0.002, large: 0.02, power: 1.8, sunk: 0.45 }];
    pile(&mut canvas, seed ^ 0x83, &grit, |canvas, radius, sunk, center, random| {
        Fragment::new(radius, random).lay(canvas, center, sunk);
    });
    let last = canvas.laid() + 1;
    for index in 0..220 {
        let mut random = Random::new(seed ^ 0x84, index);
        let root = canvas.place(index, &mut random);
        fibre(&mut canvas, root, &mut random);
    }
    (canvas, first..last)
}

fn fibre(canvas: &mut Canvas, root: (f32, f32), random: &mut Random) {
    let side = canvas.size() as f32;
    let width = side * random.between(0.0005, 0.001);
    let length = side * random.between(0.01, 0.04);
    let base = canvas.rest(root, length * 0.3);
    let strand = Strand { root, angle: random.angle(), bend: 2.2 * random.bell(), length, width };
    canvas.stroke(strand, |t| 1.0 - 0.5 * t, |_, q| base + width * (1.0 - q * q));
}

fn paint(canvas: &Canvas, stones: std::ops::Range<u32>, sky: &Field, seed: u32) -> Paint {
    let n = canvas.size();
    let (broad, fine) = (Noise::new(seed ^ 0x92, 6, 5), Noise::new(seed ^ 0x93, 90, 4).gain(0.7));
    let broad = Field::build(n / 2, |u, v| broad.fbm(u, v));
    let fine = Field::build(n / 2, |u, v| fine.fbm(u, v));
    Paint::build(n, |x, y, _, _| {
        let owner = canvas.owner[y * n + x];
        let (b, f) = (broad.coarse(x, y, n, 0), fine.coarse(x, y, n, 0));
        let r = unit(hash(seed, owner, 1));
        let open = step(0.1, 0.92, sky.coarse(x, y, n, 0));
        let mut color = mix(hex(0x6a5239), hex(0x86694a), step(-0.5, 0.5, b + 0.4 * f));
        if stones.contains(&owner) {
            color = mix(hex(0x837a6f), hex(0x9a9286), r);
        } else if owner >= stones.end {
            color = mix(hex(0x9a8460), hex(0x6f5a40), r);
        } else if owner > 0 {
            color = scale(color, 0.85 + 0.35 * r);
        }
        scale(color, (1.0 + 0.3 * f) * (0.3 + 0.7 * open))
    })
}
