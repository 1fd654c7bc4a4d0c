//! Sand that the wind has rippled: gentle windward sides, steep lee sides, coarse grains on the crests.

use super::super::color::{Paint, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::phasor::{Phasor, Waves};
use super::super::recipe::Arguments;

/// A tile of about 2 m; the wind blows along +u.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size(), arguments.seed());
    let waves = stripes(n, seed, arguments.get("count"));
    let (crest, height) = shape(n, seed, &waves);
    let albedo = paint(n, seed, &crest, &height).evened(n as f32 / 8.0, 0.36);
    Material { height: height.normalised(0.0, 1.0), albedo }
}

fn stripes(n: usize, seed: u32, count: f32) -> Waves {
    let packets = (count * 0.45).round().max(3.0) as u32;
    let waves = Phasor { seed, frequency: count, angle: 0.0, spread: 0.5, packets }.waves(n);
    // A ripple's crest line is lightly wavy.
    let wave = Noise::new(seed ^ 0x11, 5, 3);
    let (du, dv) = (Field::build(n, |u, v| wave.fbm(u, v)), Field::build(n, |u, v| wave.fbm(v, u + 0.4)));
    let warp = |field: &Field| {
        Field::texels(n, |x, y| {
            let (u, v) = ((x as f32 + 0.5) / n as f32, (y as f32 + 0.5) / n as f32);
            nearest(field, u + 0.02 * du.at(x, y), v + 0.02 * dv.at(x, y))
        })
    };
    Waves { phase: warp(&waves.phase), strength: warp(&waves.strength) }
}

/// The texel itself: a phase must not be averaged over its jump from 1 to 0.
fn nearest(field: &Field, u: f32, v: f32) -> f32 {
    let n = field.size as f32;
    field.wrapped((u * n).floor() as i32, (v * n).floor() as i32)
}

/// How near to a crest, and the height.
fn shape(n: usize, seed: u32, waves: &Waves) -> (Field, Field) {
    let profile = |t: f32| if t < 0.68 { step(0.0, 0.68, t) } else { step(1.0, 0.68, t) };
    let top = waves.strength.quantile(0.9);
    let crest = waves.phase.zip(&waves.strength, |t, s| profile(t) * (0.3 + 0.7 * (s / top).clamp(0.0, 1.0)));
    let crest = crest.blurred(n as f32 / 700.0);
    let (broad, fine) = (Noise::new(seed ^ 0x21, 4, 4), Noise::new(seed ^ 0x22, 40, 5).gain(0.7));
    let height = Field::texels(n, |x, y| {
        let (u, v) = ((x as f32 + 0.5) / n as f32, (y as f32 + 0.5) / n as f32);
        let grain = unit(hash(seed, x as u32, y as u32)) - 0.5;
        crest.at(x, y) + 0.25 * broad.fbm(u, v) + 0.06 * fine.fbm(u, v) + 0.03 * grain
    });
    (crest, height)
}

fn paint(n: usize, seed: u32, crest: &Field, height: &Field) -> Paint {
    let (broad, fine) = (Noise::new(seed ^ 0x31, 5, 4), Noise::new(seed ^ 0x32, 60, 4).gain(0.7));
    let hollow = height.above(n as f32 / 60.0);
    Paint::build(n, |x, y, u, v| {
        let (b, f) = (broad.fbm(u, v), fine.fbm(u, v));
        let mut color = mix(hex(0xb89a70), hex(0xcbb088), step(-0.4, 0.5, b + 0.4 * f));
        // Coarse, darker grains roll to the crests; fine, bright dust lies in the troughs.
        color = mix(color, hex(0xa88a63), 0.45 * step(0.55, 0.95, crest.at(x, y) + 0.2 * f));
        let grain = hash(seed ^ 0x33, x as u32, y as u32);
        color = match grain >> 24 {
            0..=9 => mix(color, hex(0x5e4a38), 0.6),
            10..=24 => mix(color, hex(0xe6d8bd), 0.6),
            _ => color,
        };
        let shade = 1.0 + (hollow.at(x, y) * 0.5).clamp(-0.18, 0.12);
        scale(color, shade * (0.9 + 0.2 * unit(grain.rotate_left(11))))
    })
}
