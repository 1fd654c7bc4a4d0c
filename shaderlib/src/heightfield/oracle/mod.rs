//! The oracle: what a ray meets, decided in whole numbers, without a single rounding.
//!
//! It knows 8- and 16-bit maps and rays in fixed point. Everything that it is asked is the sign of a whole number: times
//! are fractions, a touch is a discriminant of 0, and borders belong to both of their cells.

mod form;
mod limits;
mod time;
mod walk;
mod wide;

use std::cmp::Ordering;

pub use limits::OracleError;
pub use time::Time;

use super::{FixedRay, Heights};

/// A map and a ray, about which questions have exact answers.
#[derive(Clone, Copy, Debug)]
pub struct Oracle<'a> {
    heights: &'a Heights,
    ray: FixedRay,
    end: Time,
    /// In 2^−32 steps.
    lift: i32,
    /// The origin's cell, and the rest in 1/256.
    base: [i64; 2],
    fraction: [i64; 2],
}

impl<'a> Oracle<'a> {
    /// For a ray from its origin until a time. Every question is about that part of it.
    ///
    /// # Errors
    /// Those of [`OracleError`]: what is larger does not fit the arithmetic.
    pub fn new(heights: &'a Heights, ray: FixedRay, end: Time) -> Result<Self, OracleError> {
        limits::check(heights, &ray, end)?;
        let [x, y, _] = ray.origin;
        Ok(Self { heights, ray, end, lift: 0, base: [x >> 8, y >> 8], fraction: [x & 255, y & 255] })
    }

    /// The same with the ray higher, or lower, by so many 2^−32 steps.
    ///
    /// Between the answers for a little higher and a little lower lie those of everybody who may round a little.
    #[must_use]
    pub fn lifted(self, lift: i32) -> Self {
        Self { lift, ..self }
    }

    /// The unwrapped cell in which the ray first is on the surface or below it.
    ///
    /// The walk begins in the cell to the right of and below the origin; later a point on a border is in the cell that
    /// the ray comes from.
    #[must_use]
    pub fn first_cell(&self) -> Option<[i64; 2]> {
        self.first_cell_until(self.end)
    }

    /// The same for a part of the ray, until a time. After the end nothing is looked for.
    #[must_use]
    pub fn first_cell_until(&self, t: Time) -> Option<[i64; 2]> {
        let [x, y] = self.crossing(t)?;
        Some([self.base[0] + x, self.base[1] + y])
    }

    /// Whether the ray is on the surface or below it anywhere until a time, that one included.
    #[must_use]
    pub fn crosses_before(&self, t: Time) -> bool {
        self.crossing(t).is_some()
    }

    /// How the ray's height compares with the surface at a time; nothing beside a clamped map, or after the end.
    #[must_use]
    pub fn sign_at(&self, t: Time) -> Option<Ordering> {
        let (start, end) = self.span(self.end)?;
        (start <= t && t <= end).then(|| self.form(self.place(t).cell).sign(t))
    }
}

#[cfg(test)]
mod tests;
