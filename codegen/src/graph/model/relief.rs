//! Displaced surfaces: of a material, and how a terrain traces and shadows them.

use terrane_shaderlib::relief::{Method, Platform};

use super::Input;
use crate::diagnostic::Span;

/// The displaced surface of a material.
#[derive(Clone, Debug)]
pub struct Relief {
    /// Position in [`Graph::textures`](super::Graph::textures).
    pub texture: usize,
    /// A `Coord`.
    pub uv: Input,
    /// Metres from height 1 down to height 0.
    pub depth: f32,
    /// The entry in the file.
    pub span: Span,
}

/// How a terrain traces the displaced surface of its materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReliefTrace {
    /// Which tracer.
    pub method: ReliefMethod,
    /// Where along the ray the masks are evaluated.
    pub weights: ReliefWeights,
    /// Metres from the eye: where relief begins to fade into normal mapping, and where it is gone.
    pub fade: (f32, f32),
    /// The sun's shadow of the displaced surface on itself.
    pub shadow: ReliefShadow,
    /// Directions of the sky's occlusion by the displaced surface, 0 for none.
    pub occlusion: u32,
}

/// Which tracer finds the displaced surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ReliefMethod {
    /// The exact one for the platform, [`Method::fastest`](terrane_shaderlib::relief::Method::fastest); where the ray's whole way
    /// through the relief is shorter than the error, a single look.
    Auto {
        /// Texels of the height map, 0.001..64.
        max_error: f32,
    },
    /// This one, everywhere.
    Fixed(Method),
}

impl ReliefMethod {
    /// The method of `shaderlib/wgsl/relief` that searches.
    pub fn search(self, platform: Platform) -> Method {
        match self {
            Self::Auto { .. } => Method::fastest(platform),
            Self::Fixed(method) => method,
        }
    }
}

/// Where along a ray the masks of the layers are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefWeights {
    /// Once, where the ray enters: cheap, layers may float at seams.
    Entry,
    /// At every step, exact.
    AlongRay,
}

/// The sun's shadow at the scale of a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefShadow {
    /// None.
    Off,
    /// A ray to the middle of the sun.
    Hard,
    /// A cone: the further the blocker, the softer.
    Cone {
        /// Vertical planes in which the sun's disc is cut, 1..=16: more than one tells blockers apart that are narrower than it.
        planes: u32,
    },
}

impl ReliefTrace {
    /// For a surface that is shown alone: exact, and never faded.
    pub const ALONE: Self = Self {
        method: ReliefMethod::Auto { max_error: 0.5 },
        weights: ReliefWeights::Entry,
        fade: (1e6, 2e6),
        shadow: ReliefShadow::Cone { planes: 1 },
        occlusion: 4,
    };
}
