//! A map after a part of it has changed.

use super::dirty::{Extent, Region};
use super::mips::Mip;
use crate::heightfield::Heights;

/// The mips of a map, and which of their texels may be others.
pub(super) struct Changed<'a> {
    pub(super) heights: &'a Heights,
    pub(super) extent: &'a Extent,
    /// Before the change, for bounds that ask.
    pub(super) before: &'a [Mip],
    pub(super) after: &'a [Mip],
    pub(super) texels: &'a [Vec<Region>],
}
