//! The node library: WGSL files joined to one text, parsed once by naga, read as node kinds.

mod kind;

pub use kind::{Example, Kind, Overload, Port};
