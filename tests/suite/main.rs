//! The one integration-test binary.

mod skip;
mod tint;
