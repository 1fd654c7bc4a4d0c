//! Materials: a height map and an albedo map each, tiling.
pub mod bricks;
pub mod cracked_rock;
pub mod forest_floor;
pub mod grass;
pub mod moss;
pub mod mud;
pub mod pebbles;
pub mod ripples;
pub mod sandstone;
pub mod scree;
pub mod snow;
pub mod soil;
pub mod stone;
