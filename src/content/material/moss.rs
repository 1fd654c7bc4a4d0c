//! Moss: cushions of tiny shoots, each a star of leaves seen from above.

use super::super::canvas::{Canvas, Hit};
use super::super::cells::Cells;
use super::super::color::{Paint, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{Random, hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;

/// A tile of about 1 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size() * 2, arguments.seed());
    let canvas = cushions(n, seed);
    let half = canvas.height.halved();
    let sky = half.sky(0.5, n as f32 * 0.02);
    let albedo = paint(&canvas, &sky, seed, arguments.get("dry")).halved().evened(n as f32 / 14.0, 0.075);
    Material { height: half.evened(n as f32 / 12.0, 0.35).normalised(0.002, 0.9995), albedo }
}

fn cushions(n: usize, seed: u32) -> Canvas {
    let side = n as f32;
    let warp = Noise::new(seed ^ 0x11, 6, 4);
    let broad = Noise::new(seed ^ 0x12, 4, 4);
    let dome = |seed: u32, count: u32, u: f32, v: f32| {
        let near = Cells::new(seed, count).near(u, v);
        (1.0 - 0.9 * near.first * near.first).max(0.0).sqrt() * (0.6 + 0.4 * unit(near.id))
    };
    let ground = Field::build(n / 2, |u, v| {
        let (wu, wv) = (u + 0.03 * warp.fbm(u, v), v + 0.03 * warp.fbm(v, u + 0.5));
        let large = dome(seed ^ 1, 6, wu, wv) * 0.03 + dome(seed ^ 2, 15, wu, wv) * 0.018;
        (large + dome(seed ^ 3, 37, wu, wv) * 0.006 + 0.012 * broad.fbm(u, v)) * side
    });
    let mut canvas = Canvas::new(Field::build(n, |u, v| ground.sample(u, v)));
    for index in 0..60_000 {
        let mut random = Random::new(seed, index);
        let center = canvas.place(index, &mut random);
        shoot(&mut canvas, &ground, center, &mut random);
    }
    canvas
}

/// A rosette: leaves radiate, and the middle stands highest.
fn shoot(canvas: &mut Canvas, ground: &Field, center: (f32, f32), random: &mut Random) {
    let side = canvas.size() as f32;
    let base = ground.sample(center.0 / side, center.1 / side) + side * 0.0022 * random.bell();
    let radius = side * random.between(0.0018, 0.0038);
    let (turn, leaves) = (random.angle(), 5.0 + (random.unit() * 3.0).floor());
    canvas.lay(center, radius, |dx, dy| {
        let r = (dx * dx + dy * dy).sqrt() / radius;
        let angle = libm::atan2f(dy, dx) * leaves * 0.5 + turn;
        let star = libm::sinf(angle).abs();
        let edge = 0.35 + 0.65 * star;
        (r < edge).then_some(Hit { height: base + radius * (1.2 - 1.0 * r + 0.2 * star), along: r, across: star })
    });
}

fn paint(canvas: &Canvas, sky: &Field, seed: u32, dry: f32) -> Paint {
    let n = canvas.size();
    let patch = Noise::new(seed ^ 0x21, 6, 5);
    let patch = Field::build(n / 2, |u, v| patch.fbm(u, v));
    Paint::build(n, |x, y, _, _| {
        let index = y * n + x;
        let open = step(0.1, 0.92, sky.coarse(x, y, n, 0));
        let (owner, (along, across)) = (canvas.owner[index], canvas.place[index]);
        let r = unit(hash(seed, owner, 1));
        let age = step(-0.35, 0.45, patch.coarse(x, y, n, 0) + 0.3 * (r - 0.5) + dry - 0.3);
        let green = mix(mix(hex(0x4f6424), hex(0x6f7a2c), r), hex(0x8a7f3e), 0.7 * age);
        let tip = mix(green, hex(0xa3a852), 0.5 * (1.0 - age));
        let color = if owner == 0 { hex(0x2f2a18) } else { mix(tip, scale(green, 0.6), along) };
        scale(color, (0.85 + 0.3 * across) * (0.22 + 0.78 * open))
    })
}
