//! Things that lie on and over each other: each texel keeps what is highest there.

use super::field::Field;
use super::hash::Random;

/// What a shape is at a texel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hit {
    /// In texels, as all lengths here.
    pub height: f32,
    /// Along the thing, 0..1.
    pub along: f32,
    /// Across the thing, −1..1.
    pub across: f32,
}

/// A tile on which shapes are laid.
#[derive(Clone, Debug)]
pub struct Canvas {
    /// The highest surface, in texels.
    pub height: Field,
    /// What the highest surface belongs to: the number of the shape, counted from 1; 0 is the ground.
    pub owner: Vec<u32>,
    /// Where on its shape the highest surface is: along and across.
    pub place: Vec<(f32, f32)>,
    /// For each thing that was laid, its radius or width in texels; 0 for the ground.
    extents: Vec<f32>,
}

/// A curved strip: a blade, a needle, a twig.
#[derive(Clone, Copy, Debug)]
pub struct Strand {
    /// One end, in texels.
    pub root: (f32, f32),
    /// Direction at the root, radians.
    pub angle: f32,
    /// Radians by which the direction turns from end to end.
    pub bend: f32,
    /// In texels.
    pub length: f32,
    /// Greatest distance of a border from the middle line, in texels.
    pub width: f32,
}

impl Canvas {
    /// Bare ground, its height in texels.
    pub fn new(ground: Field) -> Self {
        let size = ground.size;
        Self { owner: vec![0; size * size], place: vec![(0.0, 0.0); size * size], height: ground, extents: vec![0.0] }
    }

    /// Texels along a side.
    pub fn size(&self) -> usize {
        self.height.size
    }

    /// How many things have been laid: the number of the last one.
    pub fn laid(&self) -> u32 {
        self.extents.len() as u32 - 1
    }

    /// A place for the next thing: shared out over the tile, so that neither gaps nor heaps come about by chance.
    pub fn place(&self, index: u32, random: &mut Random) -> (f32, f32) {
        // The R2 sequence (Roberts 2018) in whole numbers, then shaken.
        let spread = |step: u32| index.wrapping_mul(step) as f32 / 4_294_967_296.0;
        let n = self.size() as f32;
        ((spread(3_242_174_889) + 0.08 * random.bell()) * n, (spread(2_447_445_414) + 0.08 * random.bell()) * n)
    }

    /// Lays one shape, wrapping at the border; `shape(dx, dy)` is asked at offsets from the centre in texels.
    pub fn lay(&mut self, center: (f32, f32), reach: f32, shape: impl Fn(f32, f32) -> Option<Hit>) {
        self.extents.push(reach);
        for y in (center.1 - reach).floor() as i32..=(center.1 + reach).ceil() as i32 {
            let dy = y as f32 + 0.5 - center.1;
            for x in (center.0 - reach).floor() as i32..=(center.0 + reach).ceil() as i32 {
                if let Some(hit) = shape(x as f32 + 0.5 - center.0, dy) {
                    self.put(x, y, hit);
                }
            }
        }
    }

    /// Lays a strand. `width(along)` is relative to the strand's, `shape(along, across)` gives heights.
    pub fn stroke(&mut self, strand: Strand, width: impl Fn(f32) -> f32, shape: impl Fn(f32, f32) -> f32) {
        self.extents.push(strand.width);
        let steps = (strand.length / 0.7).ceil().max(2.0) as u32;
        let (mut x, mut y) = strand.root;
        let step = strand.length / steps as f32;
        // The direction is turned by a small rotation per step: one sine for each strand, not for each texel.
        let (mut cos, mut sin) = (libm::cosf(strand.angle), libm::sinf(strand.angle));
        let turn = strand.bend / steps as f32;
        let (turn_cos, turn_sin) = (libm::cosf(turn), libm::sinf(turn));
        for i in 0..=steps {
            let along = i as f32 / steps as f32;
            let half = strand.width * width(along);
            let count = (half / 0.7).ceil() as i32;
            for j in -count..=count {
                let offset = if count == 0 { 0.0 } else { half * j as f32 / count as f32 };
                let across = if half > 0.0 { offset / half } else { 0.0 };
                let (px, py) = (x - sin * offset, y + cos * offset);
                self.put(px.floor() as i32, py.floor() as i32, Hit { height: shape(along, across), along, across });
            }
            x += cos * step;
            y += sin * step;
            (cos, sin) = (cos * turn_cos - sin * turn_sin, sin * turn_cos + cos * turn_sin);
        }
    }

    fn put(&mut self, x: i32, y: i32, hit: Hit) {
        let n = self.size() as i32;
        let index = (y.rem_euclid(n) * n + x.rem_euclid(n)) as usize;
        if hit.height > self.height.data[index] {
            self.height.data[index] = hit.height;
            self.owner[index] = self.laid();
            self.place[index] = (hit.along, hit.across);
        }
    }

    /// Radius or width of what lies at a place; 0 for the ground.
    pub fn extent_at(&self, (x, y): (f32, f32)) -> f32 {
        let n = self.size() as i32;
        let index = (y as i32).rem_euclid(n) * n + (x as i32).rem_euclid(n);
        self.extents[self.owner[index as usize] as usize]
    }

    /// What a thing of a radius comes to rest on: the mean height of 13 places under it, raised towards the highest.
    pub fn rest(&self, center: (f32, f32), radius: f32) -> f32 {
        let (mut sum, mut top) = (0.0, f32::MIN);
        for (dx, dy) in PLACES {
            let x = (center.0 + dx * radius).floor() as i32;
            let y = (center.1 + dy * radius).floor() as i32;
            let height = self.height.wrapped(x, y);
            sum += height;
            top = top.max(height);
        }
        0.65 * (sum / PLACES.len() as f32) + 0.35 * top
    }
}

/// Where a resting thing touches what is under it, in its radius.
#[rustfmt::skip]
const PLACES: [(f32, f32); 13] = [
    (0.0, 0.0), (0.5, 0.0), (-0.5, 0.0), (0.0, 0.5), (0.0, -0.5), (0.6, 0.6), (-0.6, 0.6), (0.6, -0.6), (-0.6, -0.6),
    (0.9, 0.0), (-0.9, 0.0), (0.0, 0.9), (0.0, -0.9),
];
