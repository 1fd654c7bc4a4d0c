//! Sandstone in beds: laminae that the weather has cut back unevenly, pits, breaks across the beds.

use super::super::cells::Cells;
use super::super::color::{Paint, Rgb, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{hash, mix as scramble, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;

/// A tile of about 4 m; beds lie along u, so that v is up a cliff.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size(), arguments.seed());
    let beds = (arguments.get("beds")) as u32;
    let bend = bend(n, seed);
    let height = shape(n, seed, beds, &bend).evened(n as f32 / 6.0, 0.4).normalised(0.0005, 0.9995);
    let sky = height.sky(n as f32 * 0.06, n as f32 * 0.05);
    let albedo = paint(&height, &sky, &bend, seed, beds).evened(n as f32 / 6.0, 0.29);
    Material { height, albedo }
}

/// How far a bed is shifted up or down at each place, in tiles.
fn bend(n: usize, seed: u32) -> Field {
    let (broad, fine) = (Noise::new(seed ^ 0x11, 2, 4), Noise::new(seed ^ 0x12, 9, 5));
    Field::build(n, |u, v| 0.035 * broad.fbm(u, v) + 0.013 * fine.fbm(u, v))
}

/// A bed at a place: which one, and how hard, 0..1.
struct Bed {
    id: u32,
    hard: f32,
}

/// Beds of different thickness, with laminae that lie flat or slant as a dune's lee did.
fn bed(seed: u32, beds: u32, u: f32, v: f32) -> Bed {
    // A column through the cells: the nearest point decides, so thickness varies with the jitter.
    let id = Cells::new(seed ^ 0x21, beds).stretched(1, beds).near(0.5, v).id;
    // Laminae close around the torus: their number along u and v is a multiple of the noise's period.
    const PERIOD: i32 = 6;
    let slant = ((scramble(id ^ 3) >> 16) as i32 % 5 - 2) * PERIOD;
    let along = (beds as i32 * 5 / PERIOD).max(1) * PERIOD;
    let laminae = Noise { seed: id, cells: (PERIOD as u32, 1), octaves: 3, gain: 0.6 };
    let lamina = laminae.fbm((u * slant as f32 + v * along as f32) / PERIOD as f32, 0.37);
    Bed { id, hard: 0.6 * unit(scramble(id ^ 5)) + 0.4 * (0.5 + 0.7 * lamina).clamp(0.0, 1.0) }
}

fn shape(n: usize, seed: u32, beds: u32, bend: &Field) -> Field {
    let rough = Noise::new(seed ^ 0x31, 16, 6).gain(0.62);
    let broad = Noise::new(seed ^ 0x32, 4, 4);
    Field::texels(n, |x, y| {
        let (u, v) = ((x as f32 + 0.5) / n as f32, (y as f32 + 0.5) / n as f32);
        let (r, b) = (rough.fbm(u, v), broad.fbm(u, v));
        let Bed { id, hard } = bed(seed, beds, u, v + bend.at(x, y));
        // Blocks break off at joints across the beds, each bed at its own places.
        let joint = Cells::new(scramble(id), 1).stretched(7, 1).near(u + 0.012 * r + 0.01 * b, 0.5);
        let block = 0.45 * (unit(scramble(joint.id ^ 9)) - 0.5);
        let split = (1.0 - step(0.0, 0.04 + 0.05 * r.max(0.0), joint.border)) * step(0.0, 0.3, b + 0.2);
        let pit = pits(seed, u + 0.01 * r, v + 0.01 * b, b) * step(0.8, 0.4, hard);
        0.9 * hard + block * step(0.35, 0.65, hard) + 0.35 * b + 0.17 * r - 0.2 * split * hard - 0.28 * pit
    })
    .blurred(n as f32 / 1600.0)
}

/// Hollows that salt has eaten: of all sizes, side by side in some places and none in others.
fn pits(seed: u32, u: f32, v: f32, where_: f32) -> f32 {
    let pit = |seed: u32, count: u32| {
        let near = Cells::new(seed, 1).stretched(count, count * 3 / 2).near(u, v);
        let r = unit(scramble(near.id));
        step(0.2 + 0.3 * r, 0.05, near.first) * step(0.3, 0.6, r)
    };
    (pit(seed ^ 0x41, 18)).max(0.7 * pit(seed ^ 0x42, 37)) * step(0.05, 0.35, where_)
}

fn paint(height: &Field, sky: &Field, bend: &Field, seed: u32, beds: u32) -> Paint {
    let n = height.size;
    let (stain, fine) = (Noise::new(seed ^ 0x51, 4, 5), Noise::new(seed ^ 0x52, 50, 4).gain(0.7));
    let streak = Noise::new(seed ^ 0x53, 1, 5).stretched(28, 3);
    let edge = height.above(n as f32 / 150.0);
    Paint::build(n, |x, y, u, v| {
        let Bed { id, hard } = bed(seed, beds, u, v + bend.at(x, y));
        let (s, f) = (stain.fbm(u, v), fine.fbm(u, v));
        let mut color = bed_color(id);
        color = mix(color, hex(0xb58d6b), 0.45 * step(0.3, 0.8, hard + 0.3 * s));
        color = mix(color, hex(0xbfa083), 0.4 * step(0.0, 0.6, s + 0.4 * f));
        // Desert varnish runs down from the ledges.
        color = mix(color, hex(0x5b4034), 0.45 * step(0.1, 0.55, streak.fbm(u, v) + 0.25 * s));
        let grain = unit(hash(seed ^ 0x54, x as u32, y as u32)) - 0.5;
        color = scale(color, 1.0 + 0.1 * grain + 0.14 * f + (edge.at(x, y) * 2.0).clamp(-0.2, 0.2));
        scale(color, 0.4 + 0.6 * step(0.25, 0.95, sky.at(x, y)))
    })
}

fn bed_color(id: u32) -> Rgb {
    match id >> 29 {
        0 | 1 => hex(0x9c7255),
        2 | 3 => hex(0xa98063),
        4 => hex(0xb99a7e),
        5 => hex(0x8b5f47),
        6 => hex(0xae8c70),
        _ => hex(0x966a4f),
    }
}
