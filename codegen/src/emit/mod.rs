//! WGSL text: the authors' own functions, sliced verbatim, and one `let` for each value, named by its graph path.

mod arguments;
mod compose;
mod core;
mod host;
mod names;
mod probe;
mod relief;
mod text;

pub use self::core::core;
pub(crate) use self::core::frame;
pub use host::{MATERIAL_GROUP, host};
pub(crate) use host::{array_binding, relief_binding, sampler_binding};
pub use probe::{Probe, probe};
pub(crate) use relief::relief_arguments;
pub use text::{Place, Shader};

/// A layer whose weight is not above this is skipped: the error of any output is below this part of its range, for each
/// layer that is skipped.
pub const VISIBLE: f32 = 1.0 / 512.0;
