//! Phasor noise on a torus: stripes of one wavelength that fork and end as sand ripples do.
//! Source: Tricard et al., "Procedural Phasor Noise", 2019, sections 3 and 4.

use super::field::Field;
use super::hash::Random;

/// Many small wave packets, summed.
#[derive(Clone, Copy, Debug)]
pub struct Phasor {
    /// Another seed, other stripes.
    pub seed: u32,
    /// Stripes across the tile.
    pub frequency: f32,
    /// Direction in which the stripes follow each other, radians.
    pub angle: f32,
    /// How far directions stray, radians.
    pub spread: f32,
    /// Packets along a side of the tile: many packets make short stripes.
    pub packets: u32,
}

/// Phase and strength of the stripes.
#[derive(Clone, Debug)]
pub struct Waves {
    /// Where in a stripe a texel is, 0..1.
    pub phase: Field,
    /// How well the packets agree, 0 where stripes fork, about 1 elsewhere.
    pub strength: Field,
}

/// One packet: centre in tile units, wave vector in radians per tile, phase.
struct Packet {
    center: (f32, f32),
    wave: (f32, f32),
    phase: f32,
}

impl Phasor {
    /// Evaluates the noise on a grid.
    pub fn waves(&self, size: usize) -> Waves {
        let packets = self.scatter();
        let parts = |part: fn(f32) -> f32| Field::build(size, |u, v| self.sum(&packets, u, v, part));
        let (real, imaginary) = (parts(libm::cosf), parts(libm::sinf));
        let phase = real.zip(&imaginary, |re, im| libm::atan2f(im, re) / std::f32::consts::TAU + 0.5);
        let strength = real.zip(&imaginary, |re, im| (re * re + im * im).sqrt());
        Waves { phase, strength }
    }

    fn scatter(&self) -> Vec<Packet> {
        let n = self.packets;
        (0..n * n)
            .map(|i| {
                let mut random = Random::new(self.seed, i);
                let center = (((i % n) as f32 + random.unit()) / n as f32, ((i / n) as f32 + random.unit()) / n as f32);
                let angle = self.angle + self.spread * random.bell();
                let wave = std::f32::consts::TAU * self.frequency * random.between(0.93, 1.07);
                Packet { center, wave: (wave * libm::cosf(angle), wave * libm::sinf(angle)), phase: random.angle() }
            })
            .collect()
    }

    fn sum(&self, packets: &[Packet], u: f32, v: f32, part: fn(f32) -> f32) -> f32 {
        let n = self.packets as i32;
        let (cx, cy) = ((u * n as f32) as i32, (v * n as f32) as i32);
        let mut total = 0.0;
        for j in -2..=2 {
            for i in -2..=2 {
                let packet = &packets[((cy + j).rem_euclid(n) * n + (cx + i).rem_euclid(n)) as usize];
                let (dx, dy) = (nearest(u - packet.center.0), nearest(v - packet.center.1));
                let square = (dx * dx + dy * dy) * (n * n) as f32;
                if square < 4.0 {
                    let fall = (1.0 - square / 4.0) * (1.0 - square / 4.0);
                    total += fall * fall * part(packet.wave.0 * dx + packet.wave.1 * dy + packet.phase);
                }
            }
        }
        total
    }
}

/// The shortest way around the torus.
fn nearest(d: f32) -> f32 {
    d - d.round()
}
