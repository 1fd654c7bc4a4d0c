//! The methods that there are.

use std::fmt;

use super::Bounds;
use crate::heightfield::cones::Cones;

/// A way to find the first hit of a ray, and its budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// `shaderlib/wgsl/relief/walk.wgsl`.
    Walk,
    /// `shaderlib/wgsl/relief/maximum_mipmaps.wgsl`.
    MaximumMipmaps,
    /// `shaderlib/wgsl/relief/linear.wgsl`: steps, and halvings after them; 0 for one secant step (parallax occlusion mapping).
    Linear(u32, u32),
    /// `shaderlib/wgsl/relief/robust_cone.wgsl`.
    RobustCone,
    /// `shaderlib/wgsl/relief/cone_step.wgsl`: steps, or 0 to go on until the ray is in the ground.
    ConeStep(u32),
    /// `shaderlib/wgsl/relief/relaxed_cone.wgsl`: steps, and halvings after them.
    RelaxedCone(u32, u32),
}

impl Method {
    /// The fastest exact one, by docs/relief/notebook.md.
    pub const BEST: Self = Self::Walk;

    /// Whether it finds the first hit of every ray.
    #[must_use]
    pub fn is_exact(self) -> bool {
        !matches!(self, Self::Linear(..) | Self::ConeStep(_) | Self::RelaxedCone(..))
    }

    /// What it knows of the map.
    #[must_use]
    pub fn bounds(self) -> Bounds {
        match self {
            Self::Walk | Self::MaximumMipmaps => Bounds::CellMax,
            Self::Linear(..) => Bounds::None,
            Self::RobustCone => Bounds::Cones(Cones::Robust),
            Self::ConeStep(_) => Bounds::Cones(Cones::Step),
            Self::RelaxedCone(..) => Bounds::Cones(Cones::Relaxed),
        }
    }

    /// WGSL that calls it, from the names of the height texture, the bounds, the field and the ray.
    #[must_use]
    pub fn call(self, heights: &str, bounds: &str, field: &str, ray: &str) -> String {
        let exact = |name: &str| format!("{name}({heights}, {bounds}, {field}, {ray})");
        match self {
            Self::Walk => exact("walk_trace"),
            Self::MaximumMipmaps => exact("maximum_mipmaps_trace"),
            Self::RobustCone => exact("robust_cone_trace"),
            Self::ConeStep(steps) => format!("cone_step_trace({heights}, {bounds}, {field}, {ray}, {steps}u)"),
            Self::RelaxedCone(steps, halvings) => {
                format!("relaxed_cone_trace({heights}, {bounds}, {field}, {ray}, {steps}u, {halvings}u)")
            }
            Self::Linear(steps, halvings) => {
                format!("linear_trace({heights}, {field}, {ray}, {steps}u, {halvings}u)")
            }
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Walk => to.write_str("walk"),
            Self::MaximumMipmaps => to.write_str("maximum_mipmaps"),
            Self::RobustCone => to.write_str("robust_cone"),
            Self::ConeStep(0) => to.write_str("cone_step"),
            Self::ConeStep(steps) => write!(to, "cone_step({steps})"),
            Self::RelaxedCone(steps, halvings) => write!(to, "relaxed_cone({steps}, {halvings})"),
            Self::Linear(steps, 0) => write!(to, "linear_secant({steps})"),
            Self::Linear(steps, halvings) => write!(to, "linear_binary({steps}, {halvings})"),
        }
    }
}
