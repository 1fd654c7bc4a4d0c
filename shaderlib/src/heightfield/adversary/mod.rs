//! Maps and rays on which methods fail: made from a seed, the same on every machine.

mod aims;
mod maps;
mod random;
mod rays;

pub use aims::{AIMS, Aim};
pub use maps::{Depth, LANDS, Land, SIZES, map};
pub use random::Random;
pub use rays::{Case, Rays};

#[cfg(test)]
mod tests;
