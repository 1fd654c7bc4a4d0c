//! A sea of sand: ridges that fork and end, steep in the lee, riding on swells of older dunes.

use super::super::color::step;
use super::super::field::Field;
use super::super::map::Map;
use super::super::noise::Noise;
use super::super::phasor::Phasor;
use super::super::recipe::Arguments;
use super::debris::{Weather, weather};
use super::land::Land;

/// One kind of dune: their distance and height in metres, and which way they wander.
struct Dunes {
    distance: f32,
    height: f32,
    angle: f32,
    seed: u32,
}

/// Height map, the interdune hollows where water would gather, and how much of the ground is slip face.
pub fn make(arguments: &Arguments) -> Vec<Map> {
    let (n, seed) = (arguments.size(), arguments.seed());
    let (extent, relief, height) = (arguments.get("extent"), arguments.get("relief"), arguments.get("height"));
    let great = Dunes { distance: height * 9.0, height, angle: 0.45, seed };
    let small = Dunes { distance: height * 2.2, height: 0.16 * height, angle: 0.75, seed: seed ^ 0x5a };
    let swell = Noise::new(seed ^ 0x11, 2, 4);
    let mut field = Field::build(n, |u, v| (0.5 + 0.8 * swell.fbm(u, v)) * 0.6 * relief);
    for dunes in [great, small] {
        field = field.zip(&dunes.crests(n, extent), |a, b| a + b);
    }
    let mut land = Land { size: n, cell: extent / n as f32, height: field.data };
    // Sand rests at 34 degrees, whatever the waves say.
    let mut sand = vec![1000.0; n * n];
    let rounds = (40.0 * 2.0 / land.cell).clamp(4.0, 60.0) as u32;
    weather(&mut land, &mut sand, &Weather { rock: 100.0, rate: 0.0, rest: 0.66, rounds });
    maps(&land, relief)
}

fn maps(land: &Land, relief: f32) -> Vec<Map> {
    let heights = land.field();
    let low = heights.quantile(0.0);
    let hollow = heights.above(60.0 / land.cell).map(|above| step(1.0, -6.0, above));
    let slip = Field { size: land.size, data: land.steepness() }.map(|steep| step(0.45, 0.6, steep));
    vec![Map::grey16(&heights.map(|height| (height - low) / relief)), Map::grey8(&hollow), Map::grey8(&slip)]
}

impl Dunes {
    fn crests(&self, n: usize, extent: f32) -> Field {
        let frequency = extent / self.distance;
        let packets = ((frequency * 0.42) as u32).max(3);
        let waves = Phasor { seed: self.seed, frequency, angle: self.angle, spread: 0.6, packets }.waves(n);
        let top = waves.strength.quantile(0.9);
        let patch = Noise::new(self.seed ^ 0x21, 3, 3);
        let sharp = Field::build(n, |u, v| 0.65 + 0.7 * patch.fbm(u, v));
        let crest = waves.phase.zip(&waves.strength, |t, strength| {
            let profile = if t < 0.76 { t / 0.76 * step(-0.5, 0.76, t) } else { 1.0 - (t - 0.76) / 0.24 };
            profile * (strength / top).clamp(0.0, 1.0)
        });
        let crest = crest.blurred(self.distance * 0.012 * n as f32 / extent);
        crest.zip(&sharp, |crest, sharp| crest * sharp.clamp(0.1, 1.0) * self.height)
    }
}
