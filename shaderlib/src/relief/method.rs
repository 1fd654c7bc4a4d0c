//! The methods that there are.

use std::fmt;

use super::{Bounds, Displacement};
use crate::heightfield::cones::Cones;

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
    /// `shaderlib/wgsl/relief/shadow_hard.wgsl`: the walk from the finest node up, for rays that leave the ground.
    ShadowHard,
    /// `shaderlib/wgsl/relief/shadow_wide.wgsl`: the same over the bounds of `Wide`.
    ShadowWide,
    /// `shaderlib/wgsl/relief/linear.wgsl`: steps, and halvings after them; 0 for one secant step (parallax occlusion mapping).
    Linear(u32, u32),
    /// `shaderlib/wgsl/relief/parallax_offset.wgsl`: a texel is as wide as so many steps are high.
    ParallaxOffset(u32),
    /// `shaderlib/wgsl/relief/quadtree_displacement.wgsl`.
    QuadtreeDisplacement(Displacement),
    /// `shaderlib/wgsl/relief/quadtree_displacement_repaired.wgsl`.
    QuadtreeDisplacementRepaired,
    /// `shaderlib/wgsl/relief/quadtree_relief.wgsl`: the finest level that is read, 0 by the text, 1 by the algorithm.
    QuadtreeRelief(u32),
    /// The same made exact.
    QuadtreeReliefExact,
    /// `shaderlib/wgsl/relief/robust_cone.wgsl`.
    RobustCone,
    /// `shaderlib/wgsl/relief/leap.wgsl`: `StrideQuadrants` with one load to a cell.
    Leap,
    /// `shaderlib/wgsl/relief/stride.wgsl`: `RobustCone` in one loop, for GPUs.
    Stride,
    /// `shaderlib/wgsl/relief/stride_quadrants.wgsl`: that over cones of a quadrant.
    StrideQuadrants,
    /// `shaderlib/wgsl/relief/cone_step.wgsl`: steps, or 0 to go on until the ray is in the ground.
    ConeStep(u32),
    /// `shaderlib/wgsl/relief/relaxed_cone.wgsl`: steps, and halvings after them.
    RelaxedCone(u32, u32),
}

/// What runs a shader. Which method is fastest differs: a CPU counts arithmetic, a GPU waits for what it loads, and in a loop for
/// the last of many lanes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Platform {
    /// A graphics processor.
    #[default]
    Gpu,
    /// A processor that draws by itself: llvmpipe, SwiftShader, WARP.
    Cpu,
}

impl Method {
    /// The exact one that finds hits fastest on a GPU, by docs/relief/notebook.md. On a CPU `Sprint` and `Leap` find hits sooner than the
    /// walk, but need textures of their own beside the quadtree that light reads, and a scene takes as long.
    #[must_use]
    pub fn fastest(platform: Platform) -> Self {
        match platform {
            Platform::Gpu => Self::Leap,
            Platform::Cpu => Self::Walk,
        }
    }

    /// Whether it finds the first hit of every ray.
    #[must_use]
    pub fn is_exact(self) -> bool {
        let cones = matches!(self.bounds(), Bounds::Cones(Cones::Robust) | Bounds::Quadrants | Bounds::Cells);
        cones || matches!(self.bounds(), Bounds::CellMax | Bounds::Patches | Bounds::Wide)
    }

    /// What it knows of the map.
    #[must_use]
    pub fn bounds(self) -> Bounds {
        match self {
            Self::Walk
            | Self::MaximumMipmaps
            | Self::ShadowHard
            | Self::QuadtreeDisplacementRepaired
            | Self::QuadtreeReliefExact => Bounds::CellMax,
            Self::Sprint => Bounds::Patches,
            Self::Wide | Self::ShadowWide => Bounds::Wide,
            Self::QuadtreeDisplacement(_) | Self::QuadtreeRelief(_) => Bounds::TexelMax,
            Self::Linear(..) | Self::ParallaxOffset(_) => Bounds::None,
            Self::RobustCone | Self::Stride => Bounds::Cones(Cones::Robust),
            Self::StrideQuadrants => Bounds::Quadrants,
            Self::Leap => Bounds::Cells,
            Self::ConeStep(_) => Bounds::Cones(Cones::Step),
            Self::RelaxedCone(..) => Bounds::Cones(Cones::Relaxed),
        }
    }

    /// WGSL that calls it, from the names of the height texture, the bounds, the field and the ray.
    #[must_use]
    pub fn call(self, heights: &str, bounds: &str, field: &str, ray: &str) -> String {
        let exact = |name: &str| format!("{name}({heights}, {bounds}, {field}, {ray})");
        let own = format!("relief_corners({heights}, {field}, {ray}.cell, vec2i(0i))");
        let leaving = |name: &str| format!("{name}({heights}, {bounds}, {field}, {ray}, {own})");
        match self {
            Self::Walk => exact("walk_trace"),
            Self::Sprint => exact("sprint_trace"),
            Self::Wide => exact("wide_trace"),
            Self::MaximumMipmaps => exact("maximum_mipmaps_trace"),
            Self::ShadowHard => leaving("shadow_hard_trace"),
            Self::ShadowWide => leaving("shadow_wide_trace"),
            Self::RobustCone => exact("robust_cone_trace"),
            Self::Leap => format!("leap_trace({bounds}, {field}, {ray})"),
            Self::Stride => exact("stride_trace"),
            Self::StrideQuadrants => exact("stride_quadrants_trace"),
            Self::ConeStep(steps) => format!("cone_step_trace({heights}, {bounds}, {field}, {ray}, {steps}u)"),
            Self::RelaxedCone(steps, halvings) => {
                format!("relaxed_cone_trace({heights}, {bounds}, {field}, {ray}, {steps}u, {halvings}u)")
            }
            Self::Linear(steps, halvings) => {
                format!("linear_trace({heights}, {field}, {ray}, {steps}u, {halvings}u)")
            }
            Self::ParallaxOffset(steep) => format!("parallax_offset_trace({heights}, {field}, {ray}, {steep}.0f)"),
            Self::QuadtreeDisplacement(switches) => {
                format!("quadtree_displacement_trace({heights}, {bounds}, {field}, {ray}, {})", switches.wgsl())
            }
            Self::QuadtreeDisplacementRepaired => exact("quadtree_displacement_repaired_trace"),
            Self::QuadtreeRelief(finest) => format!("quadtree_relief_trace({bounds}, {field}, {ray}, {finest}i)"),
            Self::QuadtreeReliefExact => exact("quadtree_relief_exact_trace"),
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
            Self::ShadowHard => to.write_str("shadow_hard"),
            Self::ShadowWide => to.write_str("shadow_wide"),
            Self::RobustCone => to.write_str("robust_cone"),
            Self::Leap => to.write_str("leap"),
            Self::Stride => to.write_str("stride"),
            Self::StrideQuadrants => to.write_str("stride_quadrants"),
            Self::ConeStep(0) => to.write_str("cone_step"),
            Self::ConeStep(steps) => write!(to, "cone_step({steps})"),
            Self::RelaxedCone(steps, halvings) => write!(to, "relaxed_cone({steps}, {halvings})"),
            Self::Linear(steps, 0) => write!(to, "linear_secant({steps})"),
            Self::Linear(steps, halvings) => write!(to, "linear_binary({steps}, {halvings})"),
            Self::ParallaxOffset(steep) => write!(to, "parallax_offset({steep})"),
            Self::QuadtreeDisplacement(switches) => write!(to, "quadtree_displacement{switches}"),
            Self::QuadtreeDisplacementRepaired => to.write_str("quadtree_displacement_repaired"),
            Self::QuadtreeRelief(finest) => write!(to, "quadtree_relief({finest})"),
            Self::QuadtreeReliefExact => to.write_str("quadtree_relief_exact"),
        }
    }
}
