//! How cones are stored.

use super::code::Format;
use super::map::Cones;

/// How [`Cones::Step`] and [`Cones::Relaxed`] are stored: the ratio of a cone, texels for each unit of height, rounded down.
pub const RATIO: Format = Format { least: -18 };

/// How [`Cones::Robust`] and [`Cones::Quadrant`] are stored: the slope of a cone, units of height for each texel, rounded up.
pub const SLOPE: Format = Format { least: -14 };

/// What square cones are steeper than they need be: 2^-14 so that a shader's roundings cannot leave them, and 2^-21 for the four
/// roundings of a slope in f32.
pub const STEEPER: f32 = 1.0 + 1.0 / (1 << 14) as f32 + 1.0 / (1 << 21) as f32;

/// More than f64 rounds in a few operations, and far less than a code.
const ROUNDING: f64 = 1e-12;

/// The way from slopes, in steps of the map for each texel, to codes and back.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stored {
    pub(crate) cones: Cones,
    /// Steps to a unit of height.
    pub(crate) unit: f64,
}

impl Stored {
    /// Of a round cone.
    pub(super) fn round(&self, slope: f64) -> u16 {
        RATIO.down(self.unit / slope)
    }

    /// Of a square cone, whose slope was found in f32.
    pub(super) fn square(&self, slope: f32) -> u16 {
        SLOPE.up(f64::from(slope / self.unit as f32 * STEEPER))
    }

    /// Of a slope that may be any cone's.
    pub(super) fn code(&self, slope: f64) -> u16 {
        if self.cones.are_square() { self.square(slope as f32) } else { self.round(slope) }
    }

    /// Whether a slope that has a code can be what another code stands for. The gentlest code is that of no slope as well.
    pub(crate) fn is_as_steep(&self, code: u16, as_known: u16) -> bool {
        match self.cones.are_square() {
            true => code > 0 && code >= as_known,
            false => code < u16::MAX && code <= as_known,
        }
    }

    /// What a shader decodes.
    pub(super) fn slope(&self, code: u16) -> f64 {
        match self.cones {
            Cones::Step | Cones::Relaxed => self.unit / f64::from(RATIO.value(code)),
            Cones::Robust | Cones::Quadrant(_) => self.unit * f64::from(SLOPE.value(code)),
        }
    }

    /// No slope of a round cone up to this has the code of a steeper one.
    pub(super) fn ceiling(&self, code: u16) -> f64 {
        self.slope(code) * (1.0 - ROUNDING)
    }
}
