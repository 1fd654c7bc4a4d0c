//! Graph files: RON, decoded with spans, resolved to typed graphs.

pub mod model;
