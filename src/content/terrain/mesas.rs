//! Mesas in a desert: flat-lying beds, hard and soft, that rivers and frost have cut back; dunes on the plain between.

use rayon::prelude::*;

use super::super::color::step;
use super::super::field::Field;
use super::super::hash::{mix as scramble, unit};
use super::super::map::Map;
use super::super::noise::Noise;
use super::super::phasor::Phasor;
use super::super::recipe::Arguments;
use super::debris::{Weather, weather};
use super::land::Land;
use super::river::{Rock, cut};
use super::water::water;

/// One desert.
struct Desert {
    seed: u32,
    extent: f32,
    relief: f32,
    dunes: f32,
}

/// What differs from place to place in the same bed.
struct Beds {
    /// Metres by which beds lie lower here.
    lift: Field,
    /// How broken the rock is, about −1..1.
    rough: Field,
}

/// Thickness of a bed, metres.
const BED: f32 = 26.0;

/// Height map, running water, loose rock and sand.
pub fn make(arguments: &Arguments) -> Vec<Map> {
    let desert = Desert {
        seed: arguments.seed(),
        extent: arguments.get("extent"),
        relief: arguments.get("relief"),
        dunes: arguments.get("dunes"),
    };
    let mut land = desert.carve(arguments.size());
    let mut debris = vec![0.0; land.height.len()];
    let rounds = (50.0 * 2.0 / land.cell).clamp(10.0, 80.0) as u32;
    weather(&mut land, &mut debris, &Weather { rock: 1.3, rate: 0.18, rest: 0.62, rounds });
    let flow = cut(&mut land.clone(), &desert.rock(&land, &desert.beds(land.size)), 0.02, desert.seed, &mut Vec::new());
    let sand = desert.blow(&mut land);
    let deposit =
        Field { size: land.size, data: debris }.map(|depth| 1.0 - libm::expf(-depth * 0.6)).zip(&sand, f32::max);
    let heights = land.field();
    let low = heights.quantile(0.0);
    vec![
        Map::grey16(&heights.map(|height| (height - low) / desert.relief)),
        Map::grey8(&water(&land, &flow)),
        Map::grey8(&deposit),
    ]
}

impl Desert {
    fn carve(&self, size: usize) -> Land {
        let levels = (size / 256).max(1).ilog2();
        let mut land = Land::build(size >> levels, self.extent, |u, v| self.plateau(u, v));
        for level in 0..=levels {
            if level > 0 {
                land = self.roughened(&land.refined(), level);
            }
            let (mut load, beds) = (Vec::new(), self.beds(land.size));
            let (steps, time) = [(20, 1.6), (12, 1.0), (8, 0.6), (5, 0.4)][(level as usize).min(3)];
            for index in 0..steps {
                let rock = self.rock(&land, &beds);
                cut(&mut land, &rock, time, self.seed ^ (level * 1000 + index), &mut load);
            }
        }
        land
    }

    /// Tables over a plain that falls gently to the south-east, before anything is cut.
    fn plateau(&self, u: f32, v: f32) -> f32 {
        let (warp, shape) = (Noise::new(self.seed ^ 0x11, 4, 5).gain(0.55), Noise::new(self.seed ^ 0x12, 2, 6));
        let (a, b) = (warp.fbm(u, v), warp.fbm(v, u + 0.4));
        let table = shape.fbm(u + 0.1 * a, v + 0.1 * b);
        let plain = 24.0 * (1.0 - 0.5 * (u + v)) + 9.0 * a + 5.0 * b;
        let top = self.relief * (0.62 + 0.1 * b);
        let bench = 0.36 * step(-0.06, -0.048, table) + 0.64 * step(0.06, 0.072, table);
        plain + (top - plain) * bench
    }

    fn beds(&self, n: usize) -> Beds {
        let (tilt, rough) = (Noise::new(self.seed ^ 0x21, 3, 3), Noise::new(self.seed ^ 0x22, 24, 4).gain(0.65));
        Beds { lift: Field::build(n, |u, v| 7.0 * tilt.fbm(u, v)), rough: Field::build(n, |u, v| rough.fbm(u, v)) }
    }

    /// Hard beds stand as walls and resist rivers, soft ones are slopes; sand and gravel of the plain are softest.
    fn rock(&self, land: &Land, beds: &Beds) -> Rock {
        let n = land.size;
        let hard = |index: usize| self.hardness(land.height[index] + beds.lift.data[index]);
        let hard: Vec<f32> = (0..n * n).into_par_iter().map(hard).collect();
        let stable = |(hard, rough): (&f32, &f32)| (0.62 + 5.0 * hard * hard) * (1.0 + 0.45 * rough);
        Rock {
            outlet: (0..n * n).map(|index| index / n == n - 1 || index % n == n - 1).collect(),
            uplift: vec![0.0; n * n],
            erodibility: hard.par_iter().map(|hard| 0.03 * (1.0 - 0.96 * hard)).collect(),
            stable: hard.par_iter().zip(&beds.rough.data).map(stable).collect(),
        }
    }

    /// 0 shale, 1 massive sandstone, by height in metres.
    fn hardness(&self, height: f32) -> f32 {
        let bed = height / BED;
        let (below, t) = (bed.floor(), bed - bed.floor());
        let of = |index: f32| {
            let r = unit(scramble(self.seed ^ (index as i32 as u32).wrapping_mul(0x9e37_79b9)));
            if index as i32 & 1 == 0 { 0.55 + 0.45 * r } else { 0.35 * r }
        };
        of(below) + (of(below + 1.0) - of(below)) * step(0.8, 1.0, t)
    }

    fn roughened(&self, land: &Land, level: u32) -> Land {
        let n = land.size;
        let crook = Noise::new(self.seed ^ (0x51 + level), (n / 14) as u32, 4).gain(0.7);
        let mut land = land.warped(&crook, 3.5 * land.cell);
        let noise = Noise::new(self.seed ^ (0x41 + level), (n / 8) as u32, 3).gain(0.6);
        let steep = land.steepness();
        let detail = Field::build(n, |u, v| noise.fbm(u, v));
        for ((height, steep), detail) in land.height.iter_mut().zip(&steep).zip(&detail.data) {
            *height += detail * land.cell * (0.05 + 0.35 * step(0.3, 1.2, *steep));
        }
        land
    }

    /// Blows sand into dunes where the plain is open; returns how deep it lies, 0..1.
    fn blow(&self, land: &mut Land) -> Field {
        let n = land.size;
        let count = self.extent / 95.0;
        let waves = Phasor {
            seed: self.seed ^ 0x61,
            frequency: count,
            angle: 0.5,
            spread: 0.55,
            packets: (count * 0.4) as u32,
        }
        .waves(n);
        let steep = Field { size: n, data: land.steepness() };
        let (near, patch) = (steep.blurred(60.0 / land.cell), Noise::new(self.seed ^ 0x62, 3, 3));
        let top = waves.strength.quantile(0.9);
        let sand = Field::texels(n, |x, y| {
            let (u, v) = ((x as f32 + 0.5) / n as f32, (y as f32 + 0.5) / n as f32);
            let open = step(0.16, 0.05, near.at(x, y));
            let low = step(0.3, 0.15, land.height[y * n + x] / self.relief);
            open * low * step(0.0, 0.35, patch.fbm(u, v) + 0.25)
        });
        let crest = Field::texels(n, |x, y| {
            let t = waves.phase.at(x, y);
            let profile = if t < 0.74 { step(-0.15, 0.74, t) } else { 1.0 - (t - 0.74) / 0.26 };
            profile * (waves.strength.at(x, y) / top).clamp(0.0, 1.0)
        })
        .blurred(3.0 / land.cell);
        for ((height, sand), crest) in land.height.iter_mut().zip(&sand.data).zip(&crest.data) {
            *height += sand * (1.0 + self.dunes * crest);
        }
        sand
    }
}
