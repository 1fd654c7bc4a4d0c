//! One method over one view of one map.

use super::errors::Errors;
use terrane_shaderlib::relief::Method;

use crate::relief::Timing;

/// What was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The map.
    pub map: String,
    /// Its texels a side.
    pub side: u32,
    /// How deep the relief is, over the side.
    pub depth: f64,
    /// Degrees above the ground.
    pub elevation: f64,
    /// The method.
    pub method: Method,
    /// What its time is.
    pub timing: Timing,
    /// Nanoseconds a ray, all cores together.
    pub time: f64,
    /// Time over that of `maximum_mipmaps`, round by round.
    pub ratio: f64,
    /// Time over that of the exact method that takes the least, round by round.
    pub over_exact: f64,
    /// Nodes or samples a ray: mean, what one in a hundred exceeds, most.
    pub steps: [f64; 3],
    /// Patches intersected, a ray.
    pub leaves: f64,
    /// Against the reference.
    pub errors: Errors,
}

impl Row {
    /// Nodes and patches, or samples, a ray.
    #[must_use]
    pub fn loads(&self) -> f64 {
        self.steps[0] + self.leaves
    }

    /// The map and the view, in words.
    #[must_use]
    pub fn scene(&self) -> String {
        format!("{}, {}, depth {}, {}°", self.map, self.side, self.depth, self.elevation)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::errors::Spread;
    use super::*;

    /// A row on the map `map` with a time, and an error of which the 99th part in a hundred is half.
    pub(in super::super) fn row(map: &str, elevation: f64, method: Method, time: f64, max: f64) -> Row {
        let facing = Spread { mean: 0.1 * max, p99: 0.5 * max, p999: 0.8 * max, max };
        Row {
            map: map.into(),
            side: 1024,
            depth: 0.05,
            elevation,
            method,
            timing: Timing::Processor,
            time,
            ratio: time / 80.0,
            over_exact: time / 40.0,
            steps: [time / 5.0, time / 2.0, time],
            leaves: 1.25,
            errors: Errors { distance: Spread { max: 2.0 * max, ..facing }, facing, ..Errors::default() },
        }
    }
}
