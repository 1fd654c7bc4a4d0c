//! The floor of a conifer wood: needles, twigs, leaves, scales of cones, dark humus between them.

use super::super::canvas::{Canvas, Hit, Strand};
use super::super::color::{Paint, Rgb, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{Random, hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;

/// What lies there, by the number that the canvas gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Litter {
    Humus,
    Needle,
    Twig,
    Leaf,
    Scale,
}

/// A tile of about 1.5 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size() * 2, arguments.seed());
    let (canvas, kinds) = litter(n, seed, arguments.get("leaves"));
    let half = canvas.height.halved();
    let sky = half.sky(0.6, n as f32 * 0.015);
    let albedo = paint(&canvas, &kinds, &sky, seed).halved().evened(n as f32 / 16.0, 0.095);
    Material { height: half.evened(n as f32 / 12.0, 0.35).normalised(0.002, 0.9995), albedo }
}

fn litter(n: usize, seed: u32, leaves: f32) -> (Canvas, Vec<Litter>) {
    let side = n as f32;
    let (humus, lumps) = (Noise::new(seed ^ 0x11, 30, 6).gain(0.65), Noise::new(seed ^ 0x12, 6, 4));
    let ground = Field::build(n, |u, v| (0.004 * humus.fbm(u, v) + 0.012 * lumps.fbm(u, v)) * side);
    let mut canvas = Canvas::new(ground);
    let mut kinds = vec![Litter::Humus];
    let mut index = 0;
    let mut layer = |canvas: &mut Canvas, kind: Litter, count: f32, one: fn(&mut Canvas, (f32, f32), &mut Random)| {
        for _ in 0..count as u32 {
            let mut random = Random::new(seed, index);
            let center = canvas.place(index, &mut random);
            one(canvas, center, &mut random);
            kinds.push(kind);
            index += 1;
        }
    };
    layer(&mut canvas, Litter::Scale, 1500.0, scale_of_cone);
    layer(&mut canvas, Litter::Needle, 9000.0, needle);
    layer(&mut canvas, Litter::Leaf, 260.0 * leaves, leaf);
    layer(&mut canvas, Litter::Twig, 170.0, twig);
    layer(&mut canvas, Litter::Needle, 8000.0, needle);
    layer(&mut canvas, Litter::Leaf, 90.0 * leaves, leaf);
    layer(&mut canvas, Litter::Twig, 45.0, twig);
    layer(&mut canvas, Litter::Needle, 3000.0, needle);
    (canvas, kinds)
}

fn needle(canvas: &mut Canvas, root: (f32, f32), random: &mut Random) {
    let side = canvas.size() as f32;
    let width = side * random.between(0.0006, 0.001);
    let length = side * random.between(0.014, 0.03);
    let base = canvas.rest(root, length * 0.4);
    let strand = Strand { root, angle: random.angle(), bend: 0.5 * random.bell(), length, width };
    let tilt = width * 3.0 * random.bell();
    canvas.stroke(
        strand,
        |t| (4.0 * t * (1.0 - t)).sqrt().sqrt(),
        |t, q| base + tilt * (t - 0.5) + width * (1.0 - q * q),
    );
}

fn twig(canvas: &mut Canvas, root: (f32, f32), random: &mut Random) {
    let side = canvas.size() as f32;
    let width = side * random.size(0.0012, 0.0055, 1.5);
    let length = width * random.between(18.0, 45.0);
    let base = canvas.rest(root, width * 3.0);
    let strand = Strand { root, angle: random.angle(), bend: 0.5 * random.bell(), length, width };
    let (knot, phase) = (random.between(3.0, 7.0), random.angle());
    canvas.stroke(
        strand,
        |t| (1.0 - 0.45 * t) * (0.88 + 0.12 * libm::sinf(t * knot * 6.0 + phase)),
        |_, q| base + width * (1.6 * (1.0 - q * q).max(0.0).sqrt() - 0.3),
    );
}

fn leaf(canvas: &mut Canvas, root: (f32, f32), random: &mut Random) {
    let side = canvas.size() as f32;
    let length = side * random.between(0.022, 0.05);
    let width = length * random.between(0.2, 0.34);
    let base = canvas.rest(root, length * 0.4);
    let strand = Strand { root, angle: random.angle(), bend: 0.9 * random.bell(), length, width };
    let (curl, wave, phase) = (width * random.between(0.1, 0.6), random.between(2.0, 5.0), random.angle());
    canvas.stroke(
        strand,
        |t| libm::sqrtf(libm::sinf(t * std::f32::consts::PI).max(0.0)) * (1.0 - 0.45 * t),
        |t, q| base + curl * q * q + 0.1 * width * libm::sinf(t * wave * 3.0 + phase) + 0.06 * width,
    );
}

fn scale_of_cone(canvas: &mut Canvas, center: (f32, f32), random: &mut Random) {
    let side = canvas.size() as f32;
    let radius = side * random.between(0.002, 0.006);
    let base = canvas.rest(center, radius);
    let (tx, ty) = (0.5 * random.bell(), 0.5 * random.bell());
    canvas.lay(center, radius, |dx, dy| {
        let r = (dx * dx * 1.6 + dy * dy).sqrt() / radius;
        let lobe = 0.75 + 0.25 * libm::cosf(3.0 * libm::atan2f(dy, dx));
        (r < lobe).then_some(Hit { height: base + tx * dx + ty * dy + radius * 0.3 * (1.0 - r), along: r, across: 0.0 })
    });
}

fn paint(canvas: &Canvas, kinds: &[Litter], sky: &Field, seed: u32) -> Paint {
    let n = canvas.size();
    let grain = Noise::new(seed ^ 0x21, 70, 4).gain(0.7);
    let grain = Field::build(n / 2, |u, v| grain.fbm(u, v));
    Paint::build(n, |x, y, _, _| {
        let index = y * n + x;
        let (owner, g) = (canvas.owner[index], grain.coarse(x, y, n, 0));
        let open = step(0.05, 0.9, sky.coarse(x, y, n, 0));
        let color = color_of(kinds[owner as usize], hash(seed, owner, 1), canvas.place[index]);
        scale(color, (1.0 + 0.35 * g) * (0.3 + 0.7 * open))
    })
}

fn color_of(kind: Litter, id: u32, (along, across): (f32, f32)) -> Rgb {
    let r = unit(id);
    match kind {
        Litter::Humus => mix(hex(0x3a2c1f), hex(0x4f3d2c), r),
        Litter::Needle => mix(mix(hex(0x7a5533), hex(0xa5814f), r), hex(0x6a6b3c), f32::from(u8::from(id & 15 == 0))),
        Litter::Twig => scale(mix(hex(0x6e6255), hex(0x8d8072), r), 0.8 + 0.35 * (1.0 - across * across)),
        Litter::Scale => scale(mix(hex(0x5c3f29), hex(0x7a5a3c), r), 1.15 - 0.4 * along),
        Litter::Leaf => {
            let blade = mix(mix(hex(0x8a5a2c), hex(0xa98349), r), hex(0x5e4027), unit(id.rotate_left(13)) * 0.7);
            scale(blade, 1.0 + 0.25 * step(0.12, 0.0, across.abs()) - 0.2 * step(0.6, 1.0, across.abs()))
        }
    }
}
