//! The methods that there are.

use std::fmt;

use super::Bounds;

/// A way to find the first hit of a ray, and its budget.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// `shaderlib/wgsl/relief/walk.wgsl`.
    Walk,
    /// `shaderlib/wgsl/relief/sprint.wgsl`.
    Sprint,
    /// `shaderlib/wgsl/relief/wide.wgsl`.
    Wide,
    /// `shaderlib/wgsl/relief/maximum_mipmaps.wgsl`.
    MaximumMipmaps,
    /// `shaderlib/wgsl/relief/linear.wgsl`: steps, and halvings after them; 0 for one secant step (parallax occlusion mapping).
    Linear(u32, u32),
}

impl Method {
    /// The fastest exact one, by docs/relief/notebook.md.
    pub const BEST: Self = Self::Walk;

    /// Whether it finds the first hit of every ray.
    #[must_use]
    pub fn is_exact(self) -> bool {
        !matches!(self, Self::Linear(..))
    }

    /// What it knows of the map.
    #[must_use]
    pub fn bounds(self) -> Bounds {
        match self {
            Self::Walk | Self::MaximumMipmaps => Bounds::CellMax,
            Self::Sprint => Bounds::Patches,
            Self::Wide => Bounds::Wide,
            Self::Linear(..) => Bounds::None,
        }
    }

    /// The WGSL types of its textures: of heights, and of bounds.
    #[must_use]
    pub fn textures(self) -> [&'static str; 2] {
        match self {
            Self::Sprint => ["texture_storage_2d_array<rg32uint, read>", "texture_storage_2d_array<r32uint, read>"],
            _ => ["texture_2d_array<u32>"; 2],
        }
    }

    /// WGSL that calls it, from the names of the height texture, the bounds, the field and the ray.
    #[must_use]
    pub fn call(self, heights: &str, bounds: &str, field: &str, ray: &str) -> String {
        let exact = |name: &str| format!("{name}({heights}, {bounds}, {field}, {ray})");
        match self {
            Self::Walk => exact("walk_trace"),
            Self::Sprint => exact("sprint_trace"),
            Self::Wide => exact("wide_trace"),
            Self::MaximumMipmaps => exact("maximum_mipmaps_trace"),
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
            Self::Sprint => to.write_str("sprint"),
            Self::Wide => to.write_str("wide"),
            Self::MaximumMipmaps => to.write_str("maximum_mipmaps"),
            Self::Linear(steps, 0) => write!(to, "linear_secant({steps})"),
            Self::Linear(steps, halvings) => write!(to, "linear_binary({steps}, {halvings})"),
        }
    }
}
