//! Loose stones: angular fragments and rounded pebbles, to be laid on a canvas.

use super::super::canvas::{Canvas, Hit};
use super::super::hash::Random;

/// A fragment: what is left of a plate between cuts.
#[derive(Clone, Debug)]
pub struct Fragment {
    /// Largest distance from the middle, in texels.
    radius: f32,
    /// Height of the upper face over the middle, and its slopes.
    top: (f32, f32, f32),
    /// Direction of each side, its distance, and how steeply it falls.
    sides: Vec<(f32, f32, f32, f32)>,
}

impl Fragment {
    /// A random fragment of about a radius in texels.
    pub fn new(radius: f32, random: &mut Random) -> Self {
        let count = 5 + (random.unit() * 4.0) as usize;
        let (turn, stretch) = (random.angle(), random.between(0.55, 1.0));
        let lean = random.angle();
        let sides = (0..count).map(|i| side(i, count, turn, (lean, stretch), radius, random)).collect();
        let tilt = 0.42;
        let top = (radius * random.between(0.35, 0.75), tilt * random.bell(), tilt * random.bell());
        Self { radius, top, sides }
    }

    /// Lays it on what is there, sunk by a part of its height.
    pub fn lay(&self, canvas: &mut Canvas, center: (f32, f32), sunk: f32) {
        let base = canvas.rest(center, self.radius * 0.6) - sunk * self.top.0;
        canvas.lay(center, self.radius * 1.1, |dx, dy| self.at(base, dx, dy));
    }

    fn at(&self, base: f32, dx: f32, dy: f32) -> Option<Hit> {
        let mut height = self.top.0 + self.top.1 * dx + self.top.2 * dy;
        let mut face = 0;
        for (index, &(nx, ny, distance, steep)) in self.sides.iter().enumerate() {
            let side = (distance - nx * dx - ny * dy) * steep;
            if side < height {
                height = side;
                face = index + 1;
            }
        }
        let across = face as f32 / 8.0 - 0.5;
        (height > 0.0).then(|| Hit { height: base + height, along: height / self.top.0, across })
    }
}

fn side(
    index: usize,
    count: usize,
    turn: f32,
    (lean, stretch): (f32, f32),
    radius: f32,
    random: &mut Random,
) -> (f32, f32, f32, f32) {
    let angle = turn + (index as f32 + 0.7 * random.bell()) * (std::f32::consts::TAU / count as f32);
    let (nx, ny) = (libm::cosf(angle), libm::sinf(angle));
    let along = nx * libm::cosf(lean) + ny * libm::sinf(lean);
    let distance = radius * (stretch + (1.0 - stretch) * along * along) * random.between(0.62, 0.95);
    (nx, ny, distance, random.between(0.6, 3.2))
}

/// A pebble: a flattened, slightly bent ellipsoid.
#[derive(Clone, Debug)]
pub struct Pebble {
    radius: f32,
    /// Cosine and sine of its long axis.
    axis: (f32, f32),
    /// Short half axis over long one.
    stretch: f32,
    height: f32,
    /// Amplitudes of bumps along the outline.
    bumps: (f32, f32, f32),
    /// How much the upper side is flattened, 0..1.
    flat: f32,
}

impl Pebble {
    /// A random pebble of a radius in texels.
    pub fn new(radius: f32, random: &mut Random) -> Self {
        let angle = random.angle();
        let stretch = random.between(0.6, 0.98);
        Self {
            radius,
            axis: (libm::cosf(angle), libm::sinf(angle)),
            stretch,
            height: radius * stretch * random.between(0.45, 0.8),
            bumps: (0.4 * random.bell(), 0.3 * random.bell(), 0.25 * random.bell()),
            flat: random.unit(),
        }
    }

    /// Lays it on what is there, sunk by a part of its height.
    pub fn lay(&self, canvas: &mut Canvas, center: (f32, f32), sunk: f32) {
        let base = canvas.rest(center, self.radius * 0.6) - sunk * self.height;
        canvas.lay(center, self.radius * 1.25, |dx, dy| self.at(base, dx, dy));
    }

    fn at(&self, base: f32, dx: f32, dy: f32) -> Option<Hit> {
        let x = (self.axis.0 * dx + self.axis.1 * dy) / self.radius;
        let y = (self.axis.0 * dy - self.axis.1 * dx) / (self.radius * self.stretch);
        let round = x * x + y * y;
        // Bumps of the outline: an egg, a triangle, a square. They fade outside, so that the outline stays closed.
        let lumps = self.bumps.0 * x + (self.bumps.1 * (x * x - 3.0 * y * y) * x + self.bumps.2 * (x * x - y * y));
        let q = round * (1.0 + lumps.clamp(-0.3, 0.3));
        let dome = (1.0 - q).max(0.0).sqrt();
        let height = self.height * (dome + (dome * (2.0 - dome) - dome) * self.flat * 0.8);
        (q < 1.0).then_some(Hit { height: base + height, along: dome, across: x })
    }
}

/// A layer of stones: how many, between which radii (in sides of the tile), how fast numbers fall with size, how deep
/// they are sunk.
#[derive(Clone, Copy, Debug)]
pub struct Layer {
    /// How many.
    pub count: u32,
    /// The smallest radius.
    pub small: f32,
    /// The largest radius.
    pub large: f32,
    /// Exponent of the size distribution.
    pub power: f32,
    /// In heights of the stone.
    pub sunk: f32,
}

/// Lays stones layer by layer, in each the large ones first. Small ones seldom stay on large ones.
pub fn pile(
    canvas: &mut Canvas,
    seed: u32,
    layers: &[Layer],
    lay: impl Fn(&mut Canvas, f32, f32, (f32, f32), &mut Random),
) {
    let side = canvas.size() as f32;
    let mut first = 0;
    for layer in layers {
        for (radius, id, mut random) in sorted(layer, seed, first) {
            let radius = radius * side;
            let center = canvas.place(id, &mut random);
            if canvas.extent_at(center) > 2.4 * radius && random.unit() < 0.85 {
                continue;
            }
            lay(canvas, radius, layer.sunk, center, &mut random);
        }
        first += layer.count;
    }
}

fn sorted(layer: &Layer, seed: u32, first: u32) -> Vec<(f32, u32, Random)> {
    let stone = |id: u32| {
        let mut random = Random::new(seed, id);
        (random.size(layer.small, layer.large, layer.power), id, random)
    };
    let mut stones: Vec<_> = (first..first + layer.count).map(stone).collect();
    stones.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    stones
}
