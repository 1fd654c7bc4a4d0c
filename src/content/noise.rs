//! Gradient noise on a torus: every function of `(u, v)` repeats after 1 in both directions, without a seam.

use std::sync::OnceLock;

use super::hash::{hash, mix, unit};

/// A sum of octaves of gradient noise over a tile.
#[derive(Clone, Copy, Debug)]
pub struct Noise {
    /// Another seed, another noise.
    pub seed: u32,
    /// Cells of the lowest octave along u and v.
    pub cells: (u32, u32),
    /// Number of octaves; each has twice the cells.
    pub octaves: u32,
    /// Amplitude of an octave relative to the one before it. 0..1
    pub gain: f32,
}

impl Noise {
    /// Octaves of half the amplitude each.
    pub fn new(seed: u32, cells: u32, octaves: u32) -> Self {
        Self { seed, cells: (cells, cells), octaves, gain: 0.5 }
    }

    /// Stretched: different numbers of cells along u and v.
    pub fn stretched(self, u: u32, v: u32) -> Self {
        Self { cells: (u, v), ..self }
    }

    /// With another gain.
    pub fn gain(self, gain: f32) -> Self {
        Self { gain, ..self }
    }

    /// Fractal noise, about −1..1.
    pub fn fbm(&self, u: f32, v: f32) -> f32 {
        self.sum(u, v, |n, _| n)
    }

    /// Sharp crests: 1 on them, towards 0 between them. Crests gather detail (Musgrave's ridged multifractal).
    pub fn ridged(&self, u: f32, v: f32) -> f32 {
        let mut weight = 1.0_f32;
        self.sum(u, v, |n, _| {
            let crest = 1.0 - n.abs();
            let value = crest * crest * weight;
            weight = (value * 2.0).clamp(0.0, 1.0);
            value
        })
    }

    /// Rounded bumps with sharp creases between them. 0..1
    pub fn billow(&self, u: f32, v: f32) -> f32 {
        self.sum(u, v, |n, _| n.abs())
    }

    fn sum(&self, u: f32, v: f32, mut shape: impl FnMut(f32, u32) -> f32) -> f32 {
        let (mut total, mut amplitude, mut weight) = (0.0, 1.0, 0.0);
        for octave in 0..self.octaves {
            let seed = mix(self.seed.wrapping_add(octave.wrapping_mul(0x85eb_ca6b)));
            let cells = (self.cells.0 << octave, self.cells.1 << octave);
            // Octaves are shifted against each other, or the zeros of all would meet on the lattice of the first.
            let (du, dv) = (unit(mix(seed ^ 1)), unit(mix(seed ^ 2)));
            total += amplitude * shape(gradient(seed, cells, u + du, v + dv), octave);
            weight += amplitude;
            amplitude *= self.gain;
        }
        total / weight
    }
}

/// One octave of Perlin's noise with quintic interpolation, about −1..1, with so many cells to a tile.
pub fn gradient(seed: u32, cells: (u32, u32), u: f32, v: f32) -> f32 {
    let (x, y) = (u * cells.0 as f32, v * cells.1 as f32);
    let (fx, fy) = (x.floor(), y.floor());
    let (px, py) = (x - fx, y - fy);
    let corner = |i: i32, j: i32| {
        let cx = (fx as i32 + i).rem_euclid(cells.0 as i32) as u32;
        let cy = (fy as i32 + j).rem_euclid(cells.1 as i32) as u32;
        let (gx, gy) = directions()[(hash(seed, cx, cy) >> 24) as usize];
        gx * (px - i as f32) + gy * (py - j as f32)
    };
    let (sx, sy) = (fade(px), fade(py));
    let low = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * sx;
    let high = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * sx;
    (low + (high - low) * sy) * 1.5
}

fn fade(t: f32) -> f32 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// 256 directions, evenly around the circle.
fn directions() -> &'static [(f32, f32); 256] {
    static TABLE: OnceLock<[(f32, f32); 256]> = OnceLock::new();
    TABLE.get_or_init(|| {
        std::array::from_fn(|i| {
            let angle = (i as f32 + 0.5) * (std::f32::consts::TAU / 256.0);
            (libm::cosf(angle), libm::sinf(angle))
        })
    })
}
