//! The textures of height maps that methods and lights read.

use super::{Bounds, Extent, Method, coarse, patches, strip};

/// A texture over height maps of one size, a layer for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MapTexture {
    /// The heights, with mips.
    Heights,
    /// The heights of all mips, the four of a cell in one texel.
    Patches,
    /// What is known of them besides. Of [`Bounds::None`] there is one texel, for who binds something all the same.
    Bounds(Bounds),
}

impl MapTexture {
    /// The quadtree that shadow and occlusion read, beside the heights.
    pub const LIGHT: [Self; 2] = [Self::Heights, Self::Bounds(Bounds::CellMax)];

    /// A word for it, in names of variables and files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Heights => "heights",
            Self::Patches => "patches",
            Self::Bounds(Bounds::None | Bounds::CellMax) => "bounds",
            Self::Bounds(Bounds::TexelMax) => "texel_bounds",
            Self::Bounds(Bounds::Patches) => "patch_bounds",
            Self::Bounds(Bounds::Cells) => "cells",
            Self::Bounds(Bounds::Wide) => "wide_bounds",
            Self::Bounds(Bounds::Cones(_)) => "cones",
            Self::Bounds(Bounds::Quadrants) => "quadrant_cones",
        }
    }

    /// Its format in WebGPU.
    #[must_use]
    pub fn format(self) -> &'static str {
        match self {
            Self::Heights | Self::Bounds(Bounds::None | Bounds::CellMax | Bounds::TexelMax) => "r16uint",
            Self::Patches | Self::Bounds(Bounds::Quadrants) => "rg32uint",
            Self::Bounds(Bounds::Patches) => "r32uint",
            Self::Bounds(Bounds::Wide | Bounds::Cells) => "rgba32uint",
            Self::Bounds(Bounds::Cones(_)) => "rg16uint",
        }
    }

    /// Whether it is bound as a storage texture that is read, which takes WGSL's extension
    /// `readonly_and_readwrite_storage_textures`.
    #[must_use]
    pub fn is_storage(self) -> bool {
        matches!(self, Self::Patches | Self::Bounds(Bounds::Patches))
    }

    /// Its type in WGSL.
    #[must_use]
    pub fn wgsl(self) -> String {
        if self.is_storage() {
            format!("texture_storage_2d_array<{}, read>", self.format())
        } else {
            "texture_2d_array<u32>".into()
        }
    }

    /// Columns and rows of its first mip, over maps that tile and whose sides are powers of two.
    #[must_use]
    pub fn size(self, map: [u32; 2]) -> [u32; 2] {
        self.size_over(&Extent::tiling(map))
    }

    /// Its mips, over such maps.
    #[must_use]
    pub fn mips(self, map: [u32; 2]) -> u32 {
        self.mips_over(&Extent::tiling(map))
    }

    /// Columns and rows of its first mip, over any map.
    #[must_use]
    pub fn size_over(self, extent: &Extent) -> [u32; 2] {
        match self {
            Self::Heights | Self::Bounds(Bounds::Cones(_) | Bounds::Quadrants) => extent.filled,
            Self::Patches => patches::size(extent.filled, extent.mips > 1),
            Self::Bounds(Bounds::Cells) => coarse::size(extent.filled, extent.mips > 1),
            Self::Bounds(Bounds::None) => [1, 1],
            Self::Bounds(Bounds::CellMax | Bounds::TexelMax | Bounds::Patches) => extent.image(),
            Self::Bounds(Bounds::Wide) => strip::size(extent),
        }
    }

    /// Its mips, over any map.
    #[must_use]
    pub fn mips_over(self, extent: &Extent) -> u32 {
        match self {
            Self::Heights | Self::Bounds(Bounds::Cones(_) | Bounds::Quadrants) => extent.mips,
            _ => 1,
        }
    }

    /// With which bounds a map must be placed to have it.
    pub(super) fn placed_with(self) -> Bounds {
        match self {
            Self::Heights => Bounds::None,
            Self::Patches => Bounds::Patches,
            Self::Bounds(bounds) => bounds,
        }
    }
}

impl Method {
    /// The textures that it reads: the surface, unless bounds hold it, then bounds if it has any.
    #[must_use]
    pub fn reads(self) -> Vec<MapTexture> {
        let bounds = (self.bounds() != Bounds::None).then_some(MapTexture::Bounds(self.bounds()));
        self.bounds().surface().into_iter().chain(bounds).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::heightfield::cones::Cones;
    use crate::heightfield::{Border, Heights, Texels};
    use crate::relief::{Words, planes};

    const ALL: [MapTexture; 10] = [
        MapTexture::Heights,
        MapTexture::Patches,
        MapTexture::Bounds(Bounds::CellMax),
        MapTexture::Bounds(Bounds::TexelMax),
        MapTexture::Bounds(Bounds::Patches),
        MapTexture::Bounds(Bounds::Cells),
        MapTexture::Bounds(Bounds::Wide),
        MapTexture::Bounds(Bounds::Cones(Cones::Step)),
        MapTexture::Bounds(Bounds::Cones(Cones::Robust)),
        MapTexture::Bounds(Bounds::Quadrants),
    ];

    fn format(words: &Words) -> &'static str {
        match words {
            Words::R16(_) => "r16uint",
            Words::Rg16(_) => "rg16uint",
            Words::R32(_) => "r32uint",
            Words::Rg32(_) => "rg32uint",
            Words::Rgba32(_) => "rgba32uint",
        }
    }

    #[test]
    fn textures_are_as_large_as_they_say() {
        for map in [[1, 1], [2, 2], [4, 2], [16, 16], [8, 64], [128, 64]] {
            let texels = (0..map[0] * map[1]).map(|at| (at * 7919 % 65_521) as u16).collect();
            let heights = Heights::new(map, Border::Wrap, Texels::U16(texels)).unwrap();
            for (texture, plane) in ALL.into_iter().zip(planes(&heights, &ALL).unwrap()) {
                assert_eq!(plane.size, texture.size(map), "{texture:?} over {map:?}");
                assert_eq!(plane.mips() as u32, texture.mips(map), "{texture:?} over {map:?}");
                assert_eq!(format(&plane.words), texture.format(), "{texture:?}");
            }
        }
    }
}
