//! Cone maps: for every texel or cell, the widest cone of empty space that stands on the ground there.
//!
//! A cone is as steep as the steepest way up from its tip. For round cones what is steepest is looked for in a quadtree of maxima,
//! the nearest nodes first, and a node whose largest height would not be steeper stays closed: the result is that over all
//! texels. For square ones it is the highest of squares that grow, which takes a hundredth of the time.

mod change;
mod code;
mod falling;
mod map;
mod mirror;
mod node_row;
mod part;
mod quadrant;
mod report;
mod rings;
mod round;
mod square;
mod stored;
mod windows;

pub use change::shares;
pub(crate) use change::{changed, tip};
pub use code::Format;
pub use map::{ConeMap, Cones};
pub(crate) use part::{Part, each, standing};
pub use report::{Report, report};
pub use rings::{NEAR, Ring, rings};
pub(crate) use stored::Stored;
pub use stored::{RATIO, SLOPE, STEEPER};

#[cfg(test)]
mod tests;
