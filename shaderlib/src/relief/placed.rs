//! A height map and its bounds, ready to be uploaded.

use std::fmt;

use super::{Field, atlas, mips, patches, strip};
use crate::heightfield::pyramid::{Bound, CHILDREN, Levels, Pyramid, Wide};
use crate::heightfield::{Border, Heights, Texels};

/// What a method knows of the empty space over a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Bounds {
    /// Nothing.
    None,
    /// A quadtree over cells: the largest height of the surface.
    CellMax,
    /// The same in 32-bit words, and the heights as patches: four to a texel.
    Patches,
    /// Sixteen children to a node.
    Wide,
}

/// Texels of an image.
#[derive(Clone, Debug, PartialEq)]
pub enum Words {
    /// `r16uint`, mip by mip.
    R16(Vec<Vec<u16>>),
    /// `r32uint`, for a storage texture.
    R32(Vec<u32>),
    /// `rg32uint`, for a storage texture.
    Rg32(Vec<[u32; 2]>),
    /// `rgba32uint`.
    Rgba32(Vec<[u32; 4]>),
}

/// An image for a shader's `texture_2d_array<u32>`.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// Columns and rows of the first mip.
    pub size: [u32; 2],
    /// Its texels.
    pub words: Words,
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
}

/// Why a map cannot be traced on a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unplaceable {
    /// Its heights are floats; shaders read 16-bit steps.
    Floats,
    /// It wraps and a side is no power of two.
    Wrap([u32; 2]),
}

impl fmt::Display for Unplaceable {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Floats => to.write_str("a map of floats: shaders read steps, quantise it to 16 bits"),
            Self::Wrap([width, height]) => {
                write!(to, "a map that wraps and has {width} x {height} texels: sides must be powers of two")
            }
        }
    }
}

impl std::error::Error for Unplaceable {}

/// One mip of a map, filled up to powers of two.
struct Mip {
    size: [u32; 2],
    texels: Vec<u16>,
}

impl Placed {
    /// Fills the map up to powers of two and builds the bounds of all its mips. After `limit` nodes a search is given up.
    ///
    /// # Errors
    /// Those of [`Unplaceable`].
    pub fn new(heights: &Heights, bounds: Bounds, limit: u32) -> Result<Self, Unplaceable> {
        let texels: Vec<u16> = match heights.texels() {
            Texels::U8(values) => values.iter().map(|value| u16::from(*value)).collect(),
            Texels::U16(values) => values.clone(),
            Texels::F32(_) => return Err(Unplaceable::Floats),
        };
        let size = heights.size();
        let wraps = heights.border() == Border::Wrap;
        if wraps && !size.iter().all(|side| side.is_power_of_two()) {
            return Err(Unplaceable::Wrap(size));
        }
        let range = texels
            .iter()
            .fold([f64::MAX, 0.0], |[low, high], height| [low.min(f64::from(*height)), high.max(f64::from(*height))]);
        let mips = mips(fill(&texels, size, size.map(u32::next_power_of_two)), size.map(u32::next_power_of_two), wraps);
        let fields = mips.iter().enumerate().map(|(mip, one)| {
            let sides = one.size.map(|side| side as i32 - 1);
            Field {
                wrap: if wraps { sides } else { [-1; 2] },
                last: if wraps { sides } else { size.map(|side| side as i32 - 1) },
                corner: atlas::corner(mips[0].size, mip as u32).map(|at| at as i32),
                top: one.size[0].min(one.size[1]).ilog2() as i32,
                limit,
                mip: mip as i32,
                layer: 0,
                patches: patches::corner(mips[0].size, mip as u32).map(|at| at as i32),
                unit: 0,
            }
        });
        let mut fields: Vec<Field> = fields.collect();
        let image = match bounds {
            Bounds::None => Plane { size: [1, 1], words: Words::R16(vec![vec![0]]) },
            Bounds::CellMax => quadtrees(&mips, |image| Words::R16(vec![image])),
            Bounds::Patches => quadtrees(&mips, |image| Words::R32(image.into_iter().map(u32::from).collect())),
            Bounds::Wide => wide(&mips, &mut fields),
        };
        let heights = if bounds == Bounds::Patches { all_patches(&mips) } else { texels_of(mips) };
        Ok(Self { heights, bounds: image, fields, range })
    }
}

fn texels_of(mips: Vec<Mip>) -> Plane {
    Plane { size: mips[0].size, words: Words::R16(mips.into_iter().map(|mip| mip.texels).collect()) }
}

/// Filled up a map wraps, whatever it did: nothing is asked of the patches behind its border.
fn all_patches(mips: &[Mip]) -> Plane {
    let size = patches::size(mips[0].size, mips.len() > 1);
    let mut image = vec![[0; 2]; size[0] as usize * size[1] as usize];
    for (index, mip) in mips.iter().enumerate() {
        patches::write(&mut image, size[0], patches::corner(mips[0].size, index as u32), &mip.texels, mip.size);
    }
    Plane { size, words: Words::Rg32(image) }
}

/// The map and its mips; one that ends at its border has none.
fn mips(texels: Vec<u16>, size: [u32; 2], wraps: bool) -> Vec<Mip> {
    let mut mips = vec![Mip { size, texels }];
    while let Some(finer) = mips.last().filter(|finer| wraps && finer.size[0].min(finer.size[1]) > 1) {
        let coarser = Mip { size: finer.size.map(|side| side / 2), texels: mips::halve(&finer.texels, finer.size) };
        mips.push(coarser);
    }
    mips
}

fn quadtrees(mips: &[Mip], words: impl Fn(Vec<u16>) -> Words) -> Plane {
    let size = atlas::size(mips[0].size);
    let mut image = vec![0; size[0] as usize * size[1] as usize];
    for (index, mip) in mips.iter().enumerate() {
        let top = mip.size[0].min(mip.size[1]).ilog2() as usize;
        let corner = atlas::corner(mips[0].size, index as u32);
        atlas::write(&mut image, size[0], corner, &quadtree(mip)[..=top]);
    }
    Plane { size, words: words(image) }
}

/// The strip of all mips, and how their fields read it: `corner` is the first node and log2 of the columns of cells.
fn wide(mips: &[Mip], fields: &mut [Field]) -> Plane {
    let pyramids: Vec<Wide> = mips.iter().map(wide_of).collect();
    let counts: Vec<Vec<usize>> =
        pyramids.iter().map(|mip| mip.levels.iter().map(|level| level.values.len()).collect()).collect();
    let firsts = strip::corners(&counts);
    for ((field, pyramid), (first, mip)) in fields.iter_mut().zip(&pyramids).zip(firsts.iter().zip(mips)) {
        field.corner = [*first as i32, mip.size[0].max(CHILDREN).ilog2() as i32];
        field.top = pyramid.levels.len() as i32;
        field.unit = pyramid.shift as i32;
    }
    let image = strip::image(&pyramids, &firsts);
    let size = [strip::COLUMNS as u32, (image.len() / strip::COLUMNS) as u32];
    Plane { size, words: Words::Rgba32(image) }
}

/// The levels whose nodes the map has whole. A map of fewer cells than children is repeated.
fn wide_of(mip: &Mip) -> Wide {
    let size = mip.size.map(|side| side.max(CHILDREN));
    let columns = |y: u32| (0..size[0]).map(move |x| y % mip.size[1] * mip.size[0] + x % mip.size[0]);
    let texels = (0..size[1]).flat_map(columns).map(|index| mip.texels[index as usize]).collect();
    let whole = Heights::new(size, Border::Wrap, Texels::U16(texels))
        .expect("a power of two is in range where no smaller side was beyond it");
    let mut pyramid = Wide::new(&whole).expect("16-bit heights are steps");
    pyramid.levels.truncate((size[0].min(size[1]).ilog2() / 2) as usize);
    pyramid
}

/// Filled up a map wraps, whatever it did: the nodes behind the border are held against the first column as well, which
/// bounds them all the same.
fn quadtree(mip: &Mip) -> Vec<crate::heightfield::pyramid::Level<u16>> {
    let whole = Heights::new(mip.size, Border::Wrap, Texels::U16(mip.texels.clone()))
        .expect("a power of two is in range where no smaller side was beyond it");
    match Pyramid::new(&whole, Bound::CellMax).into_levels() {
        Levels::U16(levels) => levels,
        Levels::U8(_) | Levels::F32(_) => unreachable!("a pyramid has the texels of its map"),
    }
}

/// The last column and the last row again, as often as it takes.
fn fill(values: &[u16], size: [u32; 2], wanted: [u32; 2]) -> Vec<u16> {
    let [width, height] = size.map(|side| side as usize);
    let rows = (0..wanted[1] as usize).map(|y| &values[y.min(height - 1) * width..][..width]);
    rows.flat_map(|row| (0..wanted[0] as usize).map(move |x| row[x.min(width - 1)])).collect()
}
