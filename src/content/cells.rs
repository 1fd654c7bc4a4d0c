//! Worley's cells on a torus: one jittered point per lattice cell, repeating after 1 in u and v.

use super::hash::{hash, unit};

/// A lattice of jittered points.
#[derive(Clone, Copy, Debug)]
pub struct Cells {
    /// Another seed, other points.
    pub seed: u32,
    /// Points along u and v.
    pub count: (u32, u32),
    /// How far points stray from the middle of their cell. 0..1
    pub jitter: f32,
}

/// What lies around a place. Lengths are in lattice cells.
#[derive(Clone, Copy, Debug)]
pub struct Near {
    /// Distance to the nearest point.
    pub first: f32,
    /// Distance to the second nearest point.
    pub second: f32,
    /// Distance to the border between the two nearest, 0 on it.
    pub border: f32,
    /// Hash of the nearest point: its identity.
    pub id: u32,
    /// From the nearest point to the place.
    pub offset: (f32, f32),
}

impl Cells {
    /// As many points along u as along v, strayed as far as they may.
    pub fn new(seed: u32, count: u32) -> Self {
        Self { seed, count: (count, count), jitter: 1.0 }
    }

    /// Stretched: different numbers of points along u and v.
    pub fn stretched(self, u: u32, v: u32) -> Self {
        Self { count: (u, v), ..self }
    }

    /// With another jitter.
    pub fn jitter(self, jitter: f32) -> Self {
        Self { jitter, ..self }
    }

    /// Calls `visit(id, dx, dy)` for the points of the 3×3 cells around a place, `(dx, dy)` from point to place.
    pub fn visit(&self, u: f32, v: f32, mut visit: impl FnMut(u32, f32, f32)) {
        let (x, y) = (u * self.count.0 as f32, v * self.count.1 as f32);
        let (fx, fy) = (x.floor(), y.floor());
        for j in -1..=1 {
            for i in -1..=1 {
                let cx = (fx as i32 + i).rem_euclid(self.count.0 as i32) as u32;
                let cy = (fy as i32 + j).rem_euclid(self.count.1 as i32) as u32;
                let id = hash(self.seed, cx, cy);
                let px = fx + i as f32 + 0.5 + (unit(id << 16) - 0.5) * self.jitter;
                let py = fy + j as f32 + 0.5 + (unit(id) - 0.5) * self.jitter;
                visit(id, x - px, y - py);
            }
        }
    }

    /// The nearest points.
    pub fn near(&self, u: f32, v: f32) -> Near {
        let mut points = [(0_u32, 0.0_f32, 0.0_f32, 0.0_f32); 9];
        let (mut n, mut best, mut second) = (0, 0, f32::MAX);
        self.visit(u, v, |id, dx, dy| {
            let square = dx * dx + dy * dy;
            points[n] = (id, dx, dy, square);
            if n == 0 || square < points[best].3 {
                second = if n == 0 { f32::MAX } else { points[best].3 };
                best = n;
            } else if square < second {
                second = square;
            }
            n += 1;
        });
        let (id, dx, dy, square) = points[best];
        Near { first: square.sqrt(), second: second.sqrt(), border: border(&points, best), id, offset: (dx, dy) }
    }
}

/// Distance to the nearest bisector between the nearest point and any other.
fn border(points: &[(u32, f32, f32, f32); 9], best: usize) -> f32 {
    let (_, bx, by, _) = points[best];
    let mut nearest = f32::MAX;
    for (index, &(_, dx, dy, _)) in points.iter().enumerate() {
        let (ex, ey) = (bx - dx, by - dy);
        let length = (ex * ex + ey * ey).sqrt();
        if index != best && length > 1e-6 {
            let (mx, my) = (0.5 * (bx + dx), 0.5 * (by + dy));
            nearest = nearest.min(-(mx * ex + my * ey) / length);
        }
    }
    nearest.max(0.0)
}
