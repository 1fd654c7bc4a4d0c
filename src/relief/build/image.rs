//! The textures that shaders read: of each mip of a map what is drawn, where it belongs.

use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::heightfield::cones::Cones;
use terrane_shaderlib::heightfield::pyramid::Bound;
use terrane_shaderlib::relief::{Bounds, COARSE, Extent, MapTexture, Region};

use super::cones::{Coarse, Ground, Rounds, Squares, Ways};
use super::level::{Level, texture};
use super::mips::Mips;
use super::passes::{Pass, Passes};
use super::quadtrees::Drawn;
use super::strip::Strip;

/// One of them.
#[derive(Debug)]
pub(super) struct Image {
    pub(super) texture: wgpu::Texture,
    drawing: Drawing,
}

/// What is drawn of a mip.
#[derive(Debug)]
enum Drawing {
    /// Nothing: it is the texture of the heights, or that of no bounds.
    Nothing,
    /// The four heights of each cell.
    Patches(Pass),
    /// Every level of the quadtree of a bound.
    Quadtrees(Bound, Pass),
    /// Nodes over every second level of the quadtree of cells.
    Wide(Strip),
    /// Square cones over all cells.
    Squares(Box<Squares>),
    /// The same in one half of each texel of an image for all mips and coarse nodes, and patches in the other.
    Cells(Box<(Squares, Coarse, Pass)>),
    /// Round cones over all texels.
    Rounds(Box<Rounds>),
}

/// What has been drawn of a mip.
pub(super) struct Change<'t> {
    pub(super) mip: u32,
    pub(super) heights: Level<'t>,
    /// Its texels that may be others.
    pub(super) texels: &'t [Region],
    /// The cells whose surface may be another.
    pub(super) cells: Vec<Region>,
    /// Every quadtree over it.
    pub(super) quadtrees: Vec<(Bound, Vec<Drawn<'t>>)>,
}

/// The pyramid that a texture is drawn from; `None` for one that is drawn from heights alone.
pub(super) fn bound(texture: MapTexture) -> Option<Bound> {
    match texture {
        MapTexture::Bounds(Bounds::CellMax | Bounds::Patches | Bounds::Cells | Bounds::Wide) => Some(Bound::CellMax),
        MapTexture::Bounds(Bounds::TexelMax) => Some(Bound::TexelMax),
        _ => None,
    }
}

impl Image {
    /// Room for one of a map.
    pub(super) fn new(
        passes: &Passes<'_>,
        (extent, border): (&Extent, Border),
        mips: &Mips,
        wanted: MapTexture,
    ) -> Self {
        if wanted == MapTexture::Heights {
            return Self { texture: mips.texture.clone(), drawing: Drawing::Nothing };
        }
        let format = format(wanted);
        let squares = |ways: Ways| Drawing::Squares(Box::new(Squares::new(passes, format, (extent, border), ways)));
        let rounds = |cones: Cones| Drawing::Rounds(Box::new(Rounds::new(passes, format, (extent, border), cones)));
        let wraps = [("build_wraps", f64::from(u8::from(extent.wraps)))];
        let drawing = match (wanted, bound(wanted)) {
            (MapTexture::Patches, _) => Drawing::Patches(passes.pass("build_patches", format, &wraps)),
            (MapTexture::Bounds(Bounds::Wide), _) => Drawing::Wide(Strip::new(passes, format, extent)),
            (MapTexture::Bounds(Bounds::Cones(cones @ (Cones::Step | Cones::Relaxed))), _) => rounds(cones),
            (MapTexture::Bounds(Bounds::Cones(Cones::Robust)), _) => squares(Ways::All),
            (MapTexture::Bounds(Bounds::Cones(Cones::Quadrant(number))), _) => squares(Ways::Quadrant(number)),
            (MapTexture::Bounds(Bounds::Quadrants), _) => squares(Ways::Quadrants),
            (MapTexture::Bounds(Bounds::Cells), _) => {
                let part = |write_mask| wgpu::ColorTargetState { format, blend: None, write_mask };
                let cones = part(wgpu::ColorWrites::RED | wgpu::ColorWrites::GREEN);
                let patches = part(wgpu::ColorWrites::BLUE | wgpu::ColorWrites::ALPHA);
                Drawing::Cells(Box::new((
                    Squares::new(passes, cones.clone(), (extent, border), Ways::Quadrants),
                    Coarse::new(passes, cones, (extent, border)),
                    passes.pass("build_patches", patches, &wraps),
                )))
            }
            (_, Some(bound)) => Drawing::Quadtrees(bound, passes.pass("build_same", format, &[])),
            (_, None) => Drawing::Nothing,
        };
        let usage =
            if wanted.is_storage() { wgpu::TextureUsages::STORAGE_BINDING } else { wgpu::TextureUsages::empty() };
        let texture = texture(passes.gpu, format, wanted.size_over(extent), wanted.mips_over(extent), usage);
        Self { texture, drawing }
    }

    /// Draws what has changed of a mip.
    pub(super) fn update(&self, encoder: &mut wgpu::CommandEncoder, extent: &Extent, change: &Change<'_>) {
        let image = Level::whole(&self.texture, 0);
        match &self.drawing {
            Drawing::Nothing => {}
            Drawing::Patches(pass) => {
                pass.draw_at(encoder, [change.heights, image], extent.patches(change.mip), &change.cells);
            }
            Drawing::Quadtrees(bound, pass) => {
                for (level, (from, nodes)) in change.levels(*bound).iter().enumerate() {
                    pass.draw_at(encoder, [*from, image], extent.place(change.mip, level as u32), nodes);
                }
            }
            Drawing::Squares(squares) => {
                squares.update(encoder, &change.ground(Level::whole(&self.texture, change.mip), [0, 0]));
            }
            Drawing::Cells(cells) => {
                let (squares, coarse, patches) = &**cells;
                let corner = extent.patches(change.mip);
                squares.update(encoder, &change.ground(image, corner));
                patches.draw_at(encoder, [change.heights, image], corner, &change.cells);
                let levels = change.levels(Bound::CellMax);
                if let (Some(corner), Some((nodes, _))) = (extent.coarse(change.mip), levels.get(COARSE as usize)) {
                    coarse.update(encoder, &change.ground(image, corner), *nodes, &change.cells);
                }
            }
            Drawing::Rounds(rounds) => {
                rounds.update(encoder, &change.ground(Level::whole(&self.texture, change.mip), [0, 0]));
            }
            Drawing::Wide(strip) => strip.update(encoder, image, change.mip, change.levels(Bound::CellMax)),
        }
    }
}

impl<'t> Change<'t> {
    /// What cones stand on that are drawn at a corner of an image.
    fn ground(&self, image: Level<'t>, corner: [u32; 2]) -> Ground<'t> {
        Ground { mip: self.mip, heights: self.heights, texels: self.texels, image, corner, size: self.heights.size }
    }

    /// The levels of a quadtree over it.
    fn levels(&self, bound: Bound) -> &[Drawn<'t>] {
        self.quadtrees.iter().find(|(other, _)| *other == bound).map_or(&[], |(_, levels)| levels)
    }
}

fn format(texture: MapTexture) -> wgpu::TextureFormat {
    match texture {
        MapTexture::Patches | MapTexture::Bounds(Bounds::Quadrants) => wgpu::TextureFormat::Rg32Uint,
        MapTexture::Bounds(Bounds::Cones(_)) => wgpu::TextureFormat::Rg16Uint,
        MapTexture::Bounds(Bounds::Patches) => wgpu::TextureFormat::R32Uint,
        MapTexture::Bounds(Bounds::Wide | Bounds::Cells) => wgpu::TextureFormat::Rgba32Uint,
        _ => wgpu::TextureFormat::R16Uint,
    }
}
