//! The nodes on the graphics device: examples hold there too, and every result is one that WGSL's accuracy table allows.

mod device;
mod examples;
mod judged;
mod wrong;
