//! What the oracle can decide: the limits that keep its numbers in 128 bits.

use std::fmt;

use super::time::Time;
use crate::heightfield::{Border, FixedRay, Heights, Texels};

/// Largest component of a direction, in 1/256.
const FASTEST: u32 = 1 << 24;
/// Largest height of an origin, in 1/256.
const HIGHEST: u64 = 1 << 40;
/// Largest way along x or y from the origin, in cells, and a clamped map's largest distance. With its 2^13 cells, and one
/// for the border, no cell is 2^18 or more from the origin's: that is what the bits are counted with.
const FARTHEST: i64 = 1 << 17;

/// Why the oracle cannot answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OracleError {
    /// The heights are floating-point numbers.
    NotWhole,
    /// A component of the direction is above 2^24.
    Direction(i32),
    /// The origin's height is above 2^40, that is 2^32 steps.
    Height(i64),
    /// The way until the end leads over more than 2^17 cells, or the clamped map is as far away.
    Far,
}

impl fmt::Display for OracleError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotWhole => write!(to, "the heights are no whole numbers"),
            Self::Direction(rate) => write!(to, "a direction of {rate} is longer than {FASTEST}"),
            Self::Height(height) => write!(to, "an origin at {height} is higher than {HIGHEST}"),
            Self::Far => write!(to, "the ray is longer or farther away than {FARTHEST} cells"),
        }
    }
}

impl std::error::Error for OracleError {}

pub(super) fn check(heights: &Heights, ray: &FixedRay, end: Time) -> Result<(), OracleError> {
    if matches!(heights.texels(), Texels::F32(_)) {
        return Err(OracleError::NotWhole);
    }
    if let Some(rate) = ray.direction.into_iter().find(|rate| rate.unsigned_abs() > FASTEST) {
        return Err(OracleError::Direction(rate));
    }
    if ray.origin[2].unsigned_abs() > HIGHEST {
        return Err(OracleError::Height(ray.origin[2]));
    }
    let far = [0, 1].into_iter().any(|axis| match heights.border() {
        Border::Clamp => (ray.origin[axis] >> 8).unsigned_abs() > FARTHEST as u64,
        // 24 + 40 bits against 25 + 40.
        Border::Wrap => i128::from(ray.direction[axis]).abs() * end.p() > i128::from(FARTHEST << 8) * end.q(),
    });
    if far { Err(OracleError::Far) } else { Ok(()) }
}
