//! An alpine range: rising rock, cut by rivers, widened by ice, broken by frost.

use super::super::color::step;
use super::super::field::Field;
use super::super::map::Map;
use super::super::noise::Noise;
use super::super::recipe::Arguments;
use super::crags::{Crags, carve};
use super::debris::{Weather, weather};
use super::flow::Flow;
use super::land::Land;
use super::river::{Rock, cut};
use super::valley::{Valley, widen};
use super::water::water;

/// One range: its noises, and how long it has been rising at each resolution.
struct Range {
    seed: u32,
    extent: f32,
    relief: f32,
}

/// Height map (0 is the lowest outlet, 1 the argument `relief` above it), running water, loose rock.
pub fn make(arguments: &Arguments) -> Vec<Map> {
    let range = Range { seed: arguments.seed(), extent: arguments.get("extent"), relief: arguments.get("relief") };
    let (land, flow, debris) = range.raise(arguments.size());
    let heights = land.field();
    let low = heights.quantile(0.0);
    vec![
        Map::grey16(&heights.map(|height| (height - low) / range.relief)),
        Map::grey8(&water(&land, &flow)),
        Map::grey8(&Field { size: land.size, data: debris }.map(|depth| 1.0 - libm::expf(-depth * 0.6))),
    ]
}

impl Range {
    fn raise(&self, size: usize) -> (Land, Flow, Vec<f32>) {
        let levels = (size / 128).max(1).ilog2();
        let rough = Noise::new(self.seed ^ 0x11, 6, 5);
        let mut land = Land::build(size >> levels, self.extent, |u, v| 30.0 + 30.0 * rough.fbm(u, v));
        for level in 0..=levels {
            if level > 0 {
                land = self.roughened(&land.refined(), level);
            }
            let rock = self.rock(land.size);
            let mut load = Vec::new();
            let (steps, time) = [(120, 12.0), (40, 8.0), (20, 4.0), (10, 1.5), (6, 0.5)][(level as usize).min(4)];
            for index in 0..steps {
                let flow = cut(&mut land, &rock, time, self.seed ^ (level * 1000 + index), &mut load);
                if index + 4 == steps && (2..=3).contains(&level) {
                    widen(&mut land, &flow, &Valley { area: 1.0e6, width: 32.0, rise: 0.02, bend: 120.0 });
                }
            }
        }
        let mut debris = vec![0.0; land.height.len()];
        let rounds = (60.0 * 2.0 / land.cell).clamp(10.0, 90.0) as u32;
        weather(&mut land, &mut debris, &Weather { rock: 0.95, rate: 0.35, rest: 0.64, rounds });
        carve(&mut land, &debris, &Crags { seed: self.seed ^ 0x61, apart: 90.0, depth: 26.0, steep: (0.6, 1.05) });
        let flow = cut(&mut land, &self.rock(size), 0.02, self.seed, &mut Vec::new());
        (land, flow, debris)
    }

    fn rock(&self, n: usize) -> Rock {
        let hard = Noise::new(self.seed ^ 0x21, 5, (n as u32 / 10).max(2).ilog2()).gain(0.62);
        Rock {
            outlet: (0..n * n).map(|index| self.outlet(index % n, index / n, n)).collect(),
            uplift: Field::build(n, |u, v| self.uplift(u, v)).data,
            erodibility: vec![0.034; n * n],
            stable: Field::build(n, |u, v| (0.68 + 1.3 * hard.fbm(u, v)).max(0.42)).data,
        }
    }

    /// Rivers leave in the south and in the east; all other borders are divides.
    fn outlet(&self, x: usize, y: usize, n: usize) -> bool {
        let (u, v) = (x as f32 / n as f32, y as f32 / n as f32);
        (y == n - 1 && (0.30..0.36).contains(&u)) || (x == n - 1 && (0.27..0.31).contains(&v))
    }

    /// Massifs rise fast, the land between them slowly.
    fn uplift(&self, u: f32, v: f32) -> f32 {
        let (warp, massif) = (Noise::new(self.seed ^ 0x31, 3, 3), Noise::new(self.seed ^ 0x32, 2, 3));
        let (a, b) = (warp.fbm(u, v), warp.fbm(v, u + 0.4));
        let ridge = massif.ridged(u + 0.12 * a, v + 0.12 * b);
        0.35 + 1.1 * step(0.15, 0.95, ridge)
    }

    /// Detail that the coarser land could not hold: rock breaks unevenly where it is steep.
    fn roughened(&self, land: &Land, level: u32) -> Land {
        let n = land.size;
        let crook = Noise::new(self.seed ^ (0x51 + level), (n / 16) as u32, 3).gain(0.7);
        let mut land = land.warped(&crook, 3.0 * land.cell);
        let noise = Noise::new(self.seed ^ (0x41 + level), (n / 8) as u32, 3).gain(0.6);
        let steep = land.steepness();
        let detail = Field::build(n, |u, v| noise.fbm(u, v));
        for ((height, steep), detail) in land.height.iter_mut().zip(&steep).zip(&detail.data) {
            *height += detail * land.cell * (0.06 + 0.55 * step(0.3, 1.0, *steep));
        }
        land
    }
}
