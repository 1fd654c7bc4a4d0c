//! Grass from above: tufts of bent blades, dead ones below, living ones over them.

use super::super::canvas::{Canvas, Strand};
use super::super::color::{Paint, Rgb, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{Random, hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;

/// A tile of about 1.5 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed, dry) = (arguments.size() * 2, arguments.seed(), arguments.get("dry"));
    let canvas = meadow(n, seed, arguments.get("length"), arguments.get("cover"));
    let half = canvas.height.halved();
    let sky = half.sky(0.3, n as f32 * 0.012);
    let albedo = paint(&canvas, &sky, seed, dry).halved().evened(n as f32 / 16.0, 0.075 + 0.11 * dry);
    Material { height: half.evened(n as f32 / 12.0, 0.4).normalised(0.002, 0.9995), albedo }
}

fn meadow(n: usize, seed: u32, length: f32, cover: f32) -> Canvas {
    let side = n as f32;
    let soil = Noise::new(seed ^ 0x11, 12, 6).gain(0.6);
    let mut canvas = Canvas::new(Field::build(n, |u, v| soil.fbm(u, v) * side * 0.004));
    let flow = Noise::new(seed ^ 0x12, 3, 3);
    let thick = Noise::new(seed ^ 0x13, 5, 4);
    let tufts = (2600.0 * cover) as u32;
    for index in 0..tufts {
        let mut random = Random::new(seed, index);
        let center = canvas.place(index, &mut random);
        let (u, v) = (center.0 / side, center.1 / side);
        let lean = flow.fbm(u, v) * 3.0;
        let vigour = (0.75 + 0.6 * thick.fbm(u, v) + 0.25 * random.bell()).clamp(0.3, 1.3);
        let blades = (22.0 * vigour) as u32;
        for _ in 0..blades {
            blade(&mut canvas, center, lean, vigour * length * side, &mut random);
        }
    }
    canvas
}

/// One blade of a tuft: it starts near the middle, rises, and bends over.
fn blade(canvas: &mut Canvas, tuft: (f32, f32), lean: f32, length: f32, random: &mut Random) {
    let side = canvas.size() as f32;
    let out = random.angle();
    let angle = if random.unit() < 0.45 { lean + 1.3 * random.bell() } else { out };
    let stray = 0.006 * side * random.unit().sqrt();
    let length = length * random.between(0.35, 1.0);
    let strand = Strand {
        root: (tuft.0 + stray * libm::cosf(out), tuft.1 + stray * libm::sinf(out)),
        angle,
        bend: 1.1 * random.bell(),
        length,
        width: side * random.between(0.0007, 0.0016),
    };
    let (rise, top) = (length * random.between(0.25, 0.7), random.between(0.55, 1.0));
    let fold = strand.width * 0.8;
    canvas.stroke(
        strand,
        |t| (1.0 - t * t).sqrt() * (0.55 + 0.45 * (t * 4.0).min(1.0)),
        |t, q| rise * (1.0 - (t / top - 1.0) * (t / top - 1.0)) + fold * (q.abs() - 0.5),
    );
}

fn paint(canvas: &Canvas, sky: &Field, seed: u32, dry: f32) -> Paint {
    let n = canvas.size();
    let (soil, patch) = (Noise::new(seed ^ 0x21, 40, 4).gain(0.7), Noise::new(seed ^ 0x22, 5, 4));
    let soil = Field::build(n / 2, |u, v| soil.fbm(u, v));
    let patch = Field::build(n / 2, |u, v| patch.fbm(u, v));
    Paint::build(n, |x, y, _, _| {
        let index = y * n + x;
        let open = step(0.05, 0.85, sky.coarse(x, y, n, 0));
        let owner = canvas.owner[index];
        if owner == 0 {
            let color = mix(hex(0x3f3324), hex(0x5d4d38), step(-0.4, 0.5, soil.coarse(x, y, n, 0)));
            return scale(color, 0.35 + 0.65 * open);
        }
        let (along, across) = canvas.place[index];
        let color = leaf(hash(seed, owner, 1), dry + 0.25 * patch.coarse(x, y, n, 0), along);
        let rib = 1.0 + 0.18 * step(0.35, 0.0, across.abs()) + 0.1 * across;
        scale(color, rib * (0.25 + 0.75 * open) * (0.55 + 0.45 * step(0.0, 0.5, along)))
    })
}

/// A blade's colour at a place along it; dead blades are straw, living ones yellow towards the tip.
fn leaf(id: u32, dry: f32, along: f32) -> Rgb {
    let (r, s) = (unit(id), unit(id.rotate_left(12)));
    if s < 0.12 + 0.8 * dry {
        let straw = mix(hex(0xb59d68), hex(0x8d744a), r);
        return mix(scale(straw, 0.8), straw, along);
    }
    let green = mix(hex(0x4d6a2a), hex(0x75883f), r);
    let tip = mix(green, hex(0xa39a55), 0.25 + 0.5 * dry.clamp(0.0, 1.0));
    mix(scale(green, 0.75), tip, along * along)
}
