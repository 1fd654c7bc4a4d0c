//! The methods that there are.

use std::fmt;

use terrane_shaderlib::relief::Bounds;

/// A way to find the first hit of a ray, and its budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// `shaderlib/wgsl/relief/walk.wgsl`.
    Walk,
    /// `shaderlib/wgsl/relief/maximum_mipmaps.wgsl`.
    MaximumMipmaps,
    /// `shaderlib/wgsl/relief/shadow_hard.wgsl`: the walk from the finest node up, for rays that leave the ground.
    ShadowHard,
    /// `shaderlib/wgsl/relief/linear.wgsl`: steps, and halvings after them; 0 for one secant step (parallax occlusion mapping).
    Linear(u32, u32),
}

impl Method {
    /// Whether it finds the first hit of every ray.
    #[must_use]
    pub fn is_exact(self) -> bool {
        !matches!(self, Self::Linear(..))
    }

    /// What it knows of the map.
    #[must_use]
    pub fn bounds(self) -> Bounds {
        match self {
            Self::Walk | Self::MaximumMipmaps | Self::ShadowHard => Bounds::CellMax,
            Self::Linear(..) => Bounds::None,
        }
    }

    /// WGSL that calls it for `ray`.
    pub(super) fn call(self) -> String {
        match self {
            Self::Walk => "walk_trace(relief_heights, relief_bounds, relief_field, ray)".into(),
            Self::MaximumMipmaps => "maximum_mipmaps_trace(relief_heights, relief_bounds, relief_field, ray)".into(),
            Self::ShadowHard => "shadow_hard_trace(relief_heights, relief_bounds, relief_field, ray)".into(),
            Self::Linear(steps, halvings) => {
                format!("linear_trace(relief_heights, relief_field, ray, {steps}u, {halvings}u)")
            }
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Walk => to.write_str("walk"),
            Self::MaximumMipmaps => to.write_str("maximum_mipmaps"),
            Self::ShadowHard => to.write_str("shadow_hard"),
            Self::Linear(steps, 0) => write!(to, "linear_secant({steps})"),
            Self::Linear(steps, halvings) => write!(to, "linear_binary({steps}, {halvings})"),
        }
    }
}
