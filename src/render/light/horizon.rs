//! How high the terrain stands in one direction, for every texel, in time proportional to the texels.
//!
//! Parallel lines sweep the map away from the light, one texel column after the other. Each carries the upper convex hull
//! of the heights behind it: what lies under the hull can hide nothing from anything farther on, so a place's horizon is
//! the hull's tangent.
//! Source: Timonen and Westerholm, "Scalable Height Field Self-Shadowing", Computer Graphics Forum 29(2), 2010. Deviations:
//! the paper samples at the lines; here a texel lies between two lines, asks both hulls from its own height, and weights
//! the answers by distance. What is nearer than [`NEAR`] steps is walked on the texel's own line: there half a texel
//! aside is a large angle.

use glam::DVec2;
use rayon::prelude::*;

use crate::render::height_field::HeightField;

/// Terrain to sweep, and how far the land around it goes on as its mirror image.
#[derive(Clone, Copy, Debug)]
pub struct Land<'a> {
    /// The terrain.
    pub field: &'a HeightField,
    /// Metres over which land beyond the border still throws shadows; 0 for a terrain that stands alone.
    pub beyond: f64,
}

/// The tangent of a horizon where nothing stands in the way: 76 degrees below the horizontal.
pub const OPEN: f32 = -4.0;

/// Steps that each texel walks itself.
const NEAR: i64 = 8;

/// Horizons of one direction.
#[derive(Clone, Debug)]
pub struct Horizons {
    /// Tangent of the angle above the horizontal for each texel, row by row; at least [`OPEN`].
    pub tangents: Vec<f32>,
}

impl Horizons {
    /// Horizons as seen towards `direction` (x east, z south; its length does not matter). `done` is called as lines are
    /// finished, with their number.
    #[must_use]
    pub fn new(land: Land<'_>, direction: DVec2, done: &(dyn Fn(u64) + Sync)) -> Self {
        let field = land.field;
        let sweep = Sweep::new(land, direction).laid_out();
        let lines: Vec<Line> = (0..sweep.lines)
            .into_par_iter()
            .map(|line| {
                let line = sweep.line(line);
                done(1);
                line
            })
            .collect();
        let columns = field.size()[0] as usize;
        let mut tangents = vec![0.0; field.texels().len()];
        tangents.par_chunks_mut(columns).enumerate().for_each(|(row, tangents)| {
            for (column, tangent) in tangents.iter_mut().enumerate() {
                *tangent = sweep.texel(&lines, column as i64, row as i64);
            }
        });
        Self { tangents }
    }

    /// Lines of a sweep: what `done` adds up to.
    #[must_use]
    pub fn lines(land: Land<'_>, direction: DVec2) -> u64 {
        Sweep::new(land, direction).lines as u64
    }
}

/// Both answers of a line, for each step.
struct Line {
    /// For the texel on the line or the next one on the low side.
    low: Vec<f32>,
    /// For the next texel on the high side.
    high: Vec<f32>,
}

/// The geometry of one direction. A line advances by one texel on the *major* axis per step and by `slope` texels on the
/// *minor* axis; step 0 is at the end of the map that faces the light.
struct Sweep<'a> {
    field: &'a HeightField,
    major: usize,
    /// Whether step 0 is at the high end of the major axis.
    from_high: bool,
    /// The map with steps side by side: lines walk along memory.
    heights: Vec<f32>,
    slope: f64,
    /// Texels on the major and minor axis.
    steps: i64,
    across: i64,
    /// Metres per step.
    stride: f64,
    /// Minor coordinate of line 0 at step 0.
    first: i64,
    lines: usize,
    /// Steps before the map, and texels beside it, whose heights count.
    ahead: i64,
    aside: i64,
}

impl<'a> Sweep<'a> {
    fn new(Land { field, beyond }: Land<'a>, direction: DVec2) -> Self {
        let texels = [direction.x / field.spacing()[0], direction.y / field.spacing()[1]];
        let major = usize::from(texels[1].abs() > texels[0].abs());
        let minor = 1 - major;
        let slope = if texels[major] == 0.0 { 0.0 } else { -texels[minor] / texels[major].abs() };
        let (steps, across) = (i64::from(field.size()[major]), i64::from(field.size()[minor]));
        // A line that starts beside the map enters it later; one more line on either side for the texels on the border.
        let drift = slope * (steps - 1) as f64;
        let first = -(drift.max(0.0).ceil() as i64) - 1;
        let last = across + (-drift).max(0.0).ceil() as i64;
        let stride = field.spacing()[major].hypot(slope * field.spacing()[minor]);
        let from_high = texels[major] > 0.0;
        let ahead = (beyond / stride).ceil() as i64;
        let aside = (ahead as f64 * slope.abs()).ceil() as i64;
        let lines = (last - first + 1) as usize;
        let heights = Vec::new();
        Self { field, major, from_high, heights, slope, steps, across, stride, first, lines, ahead, aside }
    }

    /// With the map in memory as lines need it.
    fn laid_out(mut self) -> Self {
        let (steps, texels) = (self.steps, self.steps * self.across);
        self.heights = (0..texels).into_par_iter().map(|i| self.texel_height(i % steps, i / steps)).collect();
        self
    }

    /// Whole and broken part of a line's drift after some steps; every line has the same.
    fn drift(&self, step: i64) -> (i64, f64) {
        let drift = self.slope * step as f64;
        (drift.floor() as i64, drift - drift.floor())
    }

    fn height(&self, step: i64, minor: i64) -> f64 {
        let inside = (0..self.steps).contains(&step) && (0..self.across).contains(&minor);
        f64::from(if inside {
            self.heights[(minor * self.steps + step) as usize]
        } else {
            self.texel_height(step, minor)
        })
    }

    fn texel_height(&self, step: i64, minor: i64) -> f32 {
        let major = if self.from_high { self.steps - 1 - step } else { step };
        let texel = if self.major == 0 { [major, minor] } else { [minor, major] };
        self.field.mirrored(texel[0], texel[1])
    }

    fn line(&self, line: usize) -> Line {
        let mut hull = Hull::default();
        let mut answers = Line { low: vec![OPEN; self.steps as usize], high: vec![OPEN; self.steps as usize] };
        (-self.ahead - NEAR..-NEAR).for_each(|step| self.lift(&mut hull, line, step));
        for step in 0..self.steps {
            self.lift(&mut hull, line, step - NEAR);
            let (whole, part) = self.drift(step);
            let low = self.first + line as i64 + whole;
            if low < -1 || low >= self.across {
                continue;
            }
            let along = step as f64 * self.stride;
            let own = self.between(step, low, part);
            answers.low[step as usize] = hull.tangent(along, self.seen_from(step, low, part, own));
            answers.high[step as usize] = hull.tangent(along, self.seen_from(step, low + 1, part, own));
        }
        answers
    }

    /// Adds the line's place at a step to its hull.
    fn lift(&self, hull: &mut Hull, line: usize, step: i64) {
        let (whole, part) = self.drift(step);
        let low = self.first + line as i64 + whole;
        if step >= -self.ahead && low >= -1 - self.aside && low < self.across + self.aside {
            hull.push(step as f64 * self.stride, self.between(step, low, part));
        }
    }

    /// The height between two neighbours on the minor axis.
    fn between(&self, step: i64, low: i64, part: f64) -> f64 {
        let (low, high) = (self.height(step, low), self.height(step, low + 1));
        low + (high - low) * part
    }

    /// From which height a texel looks along a line beside it whose own height there is `own`: as far over the line as
    /// the texel is over the mean of its two lines, so that on an even slope both lines answer alike.
    fn seen_from(&self, step: i64, minor: i64, part: f64, own: f64) -> f64 {
        let mean = self.between(step, minor, part) * (1.0 - part) + self.between(step, minor - 1, part) * part;
        self.height(step, minor) + own - mean
    }

    /// The horizon of a texel among the nearest places on its own line.
    fn near(&self, step: i64, minor: i64) -> f32 {
        let height = self.height(step, minor);
        let slope = |back: i64| {
            let drift = minor as f64 - self.slope * back as f64;
            let low = drift.floor();
            let aside = self.aside as f64;
            let inside = step + self.ahead >= back && drift >= -aside && drift <= (self.across - 1) as f64 + aside;
            inside.then(|| (self.between(step - back, low as i64, drift - low) - height) / (back as f64 * self.stride))
        };
        (1..=NEAR).filter_map(slope).fold(f64::from(OPEN), f64::max) as f32
    }

    fn texel(&self, lines: &[Line], column: i64, row: i64) -> f32 {
        let (major, minor) = if self.major == 0 { (column, row) } else { (row, column) };
        let step = if self.from_high { self.steps - 1 - major } else { major };
        let (whole, part) = self.drift(step);
        let line = (minor - whole - self.first) as usize;
        let (above, below) = (lines[line].low[step as usize], lines[line - 1].high[step as usize]);
        (above + (below - above) * part as f32).max(self.near(step, minor))
    }
}

/// Upper convex hull of points in the order of their distance along the line.
#[derive(Default)]
struct Hull {
    points: Vec<DVec2>,
}

impl Hull {
    /// Slope from a place behind the last point to the hull's tangent point. Seen from there the slopes along a concave
    /// chain rise to one maximum and fall again.
    fn tangent(&self, along: f64, height: f64) -> f32 {
        let mut best = f64::from(OPEN);
        for point in self.points.iter().rev() {
            let slope = (point.y - height) / (along - point.x);
            if slope < best {
                break;
            }
            best = slope;
        }
        best as f32
    }

    fn push(&mut self, along: f64, height: f64) {
        let point = DVec2::new(along, height);
        while let [.., before, last] = self.points[..] {
            // Left of or on the chord: the last point is under it.
            if (last - before).perp_dot(point - before) < 0.0 {
                break;
            }
            self.points.pop();
        }
        self.points.push(point);
    }
}
