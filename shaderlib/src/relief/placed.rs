//! A height map and its bounds, ready to be uploaded.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::dirty::Extent;
use super::mips::{self, Mip};
use super::{Field, MapTexture, Plane, Words, atlas, coarse, cones, patches, strip, update};
use crate::heightfield::cones::Cones;
use crate::heightfield::pyramid::{Bound, CHILDREN, Wide};
use crate::heightfield::{Heights, Texels};

/// What a method knows of the empty space over a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Bounds {
    /// Nothing.
    None,
    /// A quadtree over cells: the largest height of the surface.
    CellMax,
    /// A quadtree over texels: the largest of them, as Drobot and as Schröders and van Gulik have it. Not of the surface
    /// between them. A texel's node is where that of the cell is of which it is the first corner.
    TexelMax,
    /// A cone over each texel or cell, beside the height of its tip.
    Cones(Cones),
    /// The four cones of [`Cones::Quadrant`] over each cell, beside the height of their tip.
    Quadrants,
    /// The same as `CellMax` in 32-bit words, and the heights as patches: four to a texel.
    Patches,
    /// All that a search from cone to cone asks of a cell in one texel: the cones of `Quadrants`, and its patch. Those of all mips
    /// in one image, and such cones over nodes of [`COARSE`](super::COARSE).
    Cells,
    /// Sixteen children to a node.
    Wide,
}

impl Bounds {
    /// What methods read of the surface beside them; nothing where they hold it themselves.
    #[must_use]
    pub fn surface(self) -> Option<MapTexture> {
        match self {
            Self::Patches => Some(MapTexture::Patches),
            Self::Cells => None,
            _ => Some(MapTexture::Heights),
        }
    }
}

/// What a device needs of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The heights, with mips if the map wraps.
    pub heights: Plane,
    /// What the method knows of them, of all mips.
    pub bounds: Plane,
    /// How each mip is read.
    pub fields: Vec<Field>,
    /// The lowest and the highest height.
    pub range: [f64; 2],
    /// Whether the map wraps though a side is no power of two: it stands there once, with its first column and row again at its
    /// end, and has no mips; rays are cut at the borders of its tiles (`wgsl/relief/tiled.wgsl`).
    pub tiled: bool,
}

/// Why a map cannot be traced on a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unplaceable {
    /// Its heights are floats; shaders read 16-bit steps.
    Floats,
}

impl fmt::Display for Unplaceable {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Floats => to.write_str("a map of floats: shaders read steps, quantise it to 16 bits"),
        }
    }
}

impl std::error::Error for Unplaceable {}

impl Placed {
    /// Fills the map up to powers of two and builds the bounds of all its mips. After `limit` nodes a search is given up.
    ///
    /// # Errors
    /// Those of [`Unplaceable`].
    pub fn new(heights: &Heights, bounds: Bounds, limit: u32) -> Result<Self, Unplaceable> {
        Self::watched(heights, bounds, limit, &|_, _| ())
    }

    /// The same for bounds that take long: `progress` is told, from any thread, how much of a mip is done and how much there
    /// is of it.
    ///
    /// # Errors
    /// Those of [`Unplaceable`].
    pub fn watched(
        heights: &Heights,
        bounds: Bounds,
        limit: u32,
        progress: &(dyn Fn(u64, u64) + Sync),
    ) -> Result<Self, Unplaceable> {
        let texels: Vec<u16> = match heights.texels() {
            Texels::U8(values) => values.iter().map(|value| u16::from(*value)).collect(),
            Texels::U16(values) => values.clone(),
            Texels::F32(_) => return Err(Unplaceable::Floats),
        };
        let extent = Extent::new(heights);
        let (tiled, wraps) = (extent.is_tiled(), extent.wraps);
        let range = update::range(&texels);
        let mips = mips::all(fill(&texels, &extent), extent.filled, wraps);
        let fields = mips.iter().enumerate().map(|(mip, one)| {
            let sides = one.size.map(|side| side as i32 - 1);
            Field {
                wrap: if wraps { sides } else { [-1; 2] },
                last: extent.last.map(|last| (last >> mip) as i32),
                corner: atlas::corner(mips[0].size, mip as u32).map(|at| at as i32),
                top: one.size[0].min(one.size[1]).ilog2() as i32,
                limit,
                mip: mip as i32,
                layer: 0,
                patches: patches::corner(mips[0].size, mip as u32).map(|at| at as i32),
                unit: 0,
                coarse: coarse::begin(mips[0].size, mip as u32, coarse::LARGE),
            }
        });
        let mut fields: Vec<Field> = fields.collect();
        let image = match bounds {
            Bounds::None => Plane { size: [1, 1], words: Words::R16(vec![vec![0]]) },
            Bounds::CellMax => quadtrees(&mips, Bound::CellMax, |image| Words::R16(vec![image])),
            Bounds::TexelMax => quadtrees(&mips, Bound::TexelMax, |image| Words::R16(vec![image])),
            Bounds::Patches => {
                let words = |image: Vec<u16>| Words::R32(image.into_iter().map(u32::from).collect());
                quadtrees(&mips, Bound::CellMax, words)
            }
            Bounds::Wide => wide(&mips, &mut fields),
            Bounds::Cells => cones::cells(heights, &mips, progress),
            Bounds::Quadrants => cones::quadrants(heights, &mips, progress),
            Bounds::Cones(cones) => cones::plane(heights, &mips, cones, progress),
        };
        let heights = if bounds == Bounds::Patches { all_patches(&mips, wraps) } else { texels_of(mips) };
        Ok(Self { heights, bounds: image, fields, range, tiled })
    }

    /// Lets searches from cone to cone begin over coarse nodes on every mip that has some, however small: what a map of
    /// [`LARGE`](super::LARGE) texels does by itself, for tests on maps that can be judged.
    #[must_use]
    pub fn begun_over_nodes(mut self) -> Self {
        let map = self.fields[0].last.map(|last| (last as u32 + 1).next_power_of_two());
        for (mip, field) in (0..).zip(&mut self.fields) {
            field.coarse = coarse::begin(map, mip, 0);
        }
        self
    }

    fn plane(&self, texture: MapTexture) -> &Plane {
        match texture {
            MapTexture::Heights | MapTexture::Patches => &self.heights,
            MapTexture::Bounds(_) => &self.bounds,
        }
    }
}

/// The textures of a map that shaders read with fields of their own.
///
/// # Errors
/// Those of [`Unplaceable`].
pub fn planes(heights: &Heights, textures: &[MapTexture]) -> Result<Vec<Plane>, Unplaceable> {
    // Heights come with any bounds but patches.
    let other = |texture: &&MapTexture| !matches!(texture.placed_with(), Bounds::None | Bounds::Patches);
    let beside = textures.iter().find(other).map_or(Bounds::None, |texture| texture.placed_with());
    let with = |texture: MapTexture| if texture == MapTexture::Heights { beside } else { texture.placed_with() };
    let all: BTreeSet<Bounds> = textures.iter().map(|texture| with(*texture)).collect();
    // The limit is one of the fields.
    let placed = all.into_iter().map(|bounds| Ok((bounds, Placed::new(heights, bounds, 0)?)));
    let placed: BTreeMap<Bounds, Placed> = placed.collect::<Result<_, _>>()?;
    Ok(textures.iter().map(|texture| placed[&with(*texture)].plane(*texture).clone()).collect())
}

fn texels_of(mips: Vec<Mip>) -> Plane {
    Plane { size: mips[0].size, words: Words::R16(mips.into_iter().map(|mip| mip.texels).collect()) }
}

fn all_patches(mips: &[Mip], wraps: bool) -> Plane {
    let size = patches::size(mips[0].size, mips.len() > 1);
    let mut image = vec![[0; 2]; size[0] as usize * size[1] as usize];
    for (index, mip) in mips.iter().enumerate() {
        let corner = patches::corner(mips[0].size, index as u32);
        patches::write(&mut image, size[0], corner, (mip, wraps), &mip.size.map(|side| 0..side), |texel, patch| {
            *texel = patch
        });
    }
    Plane { size, words: Words::Rg32(vec![image]) }
}

fn quadtrees(mips: &[Mip], bound: Bound, words: impl Fn(Vec<u16>) -> Words) -> Plane {
    let size = atlas::size(mips[0].size);
    let mut image = vec![0; size[0] as usize * size[1] as usize];
    for (index, mip) in mips.iter().enumerate() {
        let top = mip.size[0].min(mip.size[1]).ilog2() as usize;
        let corner = atlas::corner(mips[0].size, index as u32);
        atlas::write(&mut image, size[0], corner, &mip.quadtree(bound)[..=top]);
    }
    Plane { size, words: words(image) }
}

/// The strip of all mips, and how their fields read it: `corner` is the first node and log2 of the columns of cells.
fn wide(mips: &[Mip], fields: &mut [Field]) -> Plane {
    let pyramids: Vec<Wide> = mips.iter().map(wide_of).collect();
    let counts: Vec<Vec<usize>> = mips.iter().map(|mip| strip::counts(mip.size)).collect();
    let firsts = strip::corners(&counts);
    for ((field, pyramid), (first, mip)) in fields.iter_mut().zip(&pyramids).zip(firsts.iter().zip(mips)) {
        field.corner = [*first as i32, mip.size[0].max(CHILDREN).ilog2() as i32];
        field.top = pyramid.levels.len() as i32;
        field.unit = pyramid.unit as i32;
    }
    let image = strip::image(&pyramids, &firsts);
    let size = [strip::COLUMNS as u32, (image.len() / strip::COLUMNS) as u32];
    Plane { size, words: Words::Rgba32(image) }
}

/// The levels whose nodes the map has whole.
fn wide_of(mip: &Mip) -> Wide {
    let repeated = strip::repeated(mip);
    let heights = repeated.as_ref().unwrap_or(mip).heights();
    let mut pyramid = Wide::new(&heights).expect("16-bit heights are steps");
    pyramid.levels.truncate(strip::counts(mip.size).len());
    pyramid
}

/// The texels of the first mip.
fn fill(values: &[u16], extent: &Extent) -> Vec<u16> {
    let columns: Vec<usize> = (0..extent.filled[0]).map(|x| extent.source(0, x) as usize).collect();
    let width = extent.size[0] as usize;
    let rows = (0..extent.filled[1]).map(|y| &values[extent.source(1, y) as usize * width..][..width]);
    rows.flat_map(|row| columns.iter().map(|x| row[*x])).collect()
}
