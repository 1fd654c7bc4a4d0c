//! The one integration-test binary.

mod accepted;
mod content;
mod embed;
mod emitted;
mod house;
mod library;
mod measure;
mod output;
mod picture;
mod random;
mod relief;
mod render;
mod scratch;
mod skip;
mod tint;
