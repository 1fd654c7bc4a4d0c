//! A map placed by the device itself: the textures of [`terrane_shaderlib::relief::Placed`], equal to the last bit.

mod passes;
mod read;

use terrane_shaderlib::heightfield::{Heights, Texels};
use terrane_shaderlib::relief::{Extent, Region, Unplaceable, halved};

use self::passes::{Pass, Passes};
use crate::render::{Gpu, RenderError};

/// A map, its mips and the bounds of all of them, as textures that shaders read.
#[derive(Debug)]
pub struct Built<'a> {
    gpu: &'a Gpu,
    extent: Extent,
    passes: Passes,
    /// The map as it came.
    source: wgpu::Texture,
    heights: wgpu::Texture,
    /// The quadtree of one mip at a time: its level k is this texture's mip `mip + k`.
    quadtree: wgpu::Texture,
    bounds: wgpu::Texture,
}

const SIXTEEN: wgpu::TextureFormat = wgpu::TextureFormat::R16Uint;

impl<'a> Built<'a> {
    /// Uploads a map and builds everything over it.
    ///
    /// # Errors
    /// [`RenderError::Scene`] for a map of floats; what the device has against it.
    pub fn new(gpu: &'a Gpu, heights: &Heights) -> Result<Self, RenderError> {
        let (format, _) = bytes(heights)?;
        let extent = Extent::new(heights);
        let passes = Passes::new(gpu, extent.is_tiled())?;
        let levels = extent.levels(0);
        let built = gpu.checked("relief's bounds", || {
            use wgpu::TextureUsages as Usage;
            let drawn = Usage::TEXTURE_BINDING | Usage::RENDER_ATTACHMENT | Usage::COPY_SRC;
            let texture = |format, size, mips, usage| texture(gpu, format, size, mips, usage);
            Self {
                gpu,
                extent,
                passes,
                source: texture(format, extent.size, 1, Usage::TEXTURE_BINDING | Usage::COPY_DST),
                heights: texture(SIXTEEN, extent.filled, extent.mips, drawn),
                quadtree: texture(SIXTEEN, extent.filled, levels, drawn | Usage::COPY_DST),
                bounds: texture(SIXTEEN, extent.image(), 1, Usage::TEXTURE_BINDING | Usage::COPY_DST | Usage::COPY_SRC),
            }
        })?;
        built.update(heights, &extent.size.map(|side| 0..side))?;
        Ok(built)
    }

    /// Brings what depends on a rectangle of changed texels up to date: columns and rows inside the map.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    ///
    /// # Panics
    /// If the map has another size or border than that which was built.
    pub fn update(&self, heights: &Heights, texels: &Region) -> Result<(), RenderError> {
        assert_eq!(self.extent, Extent::new(heights), "a map of another size or border");
        if texels.iter().any(std::ops::Range::is_empty) {
            return Ok(());
        }
        self.upload(heights, texels)?;
        self.gpu.checked("relief's bounds", || {
            let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            let mut changed = self.extent.texels(texels);
            self.draw(&mut encoder, Pass::Fill, (&self.source, 0), (&self.heights, 0), &changed);
            for mip in 0..self.extent.mips {
                if mip > 0 {
                    changed = halved(&changed);
                    self.draw(&mut encoder, Pass::Mip, (&self.heights, mip - 1), (&self.heights, mip), &changed);
                }
                self.bounds_of(&mut encoder, mip, self.extent.cells(mip, &changed));
            }
            self.gpu.queue.submit([encoder.finish()]);
        })
    }

    /// The heights with their mips, and the image of the bounds.
    #[must_use]
    pub fn textures(&self) -> [&wgpu::Texture; 2] {
        [&self.heights, &self.bounds]
    }

    /// What the device has made, texel by texel: the mips of the heights, and the image of the bounds.
    ///
    /// # Errors
    /// [`RenderError::Lost`] where the device fails.
    pub fn read(&self) -> Result<(Vec<Vec<u16>>, Vec<u16>), RenderError> {
        let mips = (0..self.extent.mips).map(|mip| read::texels(self.gpu, &self.heights, mip));
        Ok((mips.collect::<Result<_, _>>()?, read::texels(self.gpu, &self.bounds, 0)?))
    }

    /// The quadtree over some cells of a mip, moved to where it belongs level by level.
    fn bounds_of(&self, encoder: &mut wgpu::CommandEncoder, mip: u32, cells: Vec<Region>) {
        let mut nodes = cells;
        for level in 0..self.extent.levels(mip) {
            let target = (&self.quadtree, mip + level);
            if level == 0 {
                self.draw(encoder, Pass::Cells, (&self.heights, mip), target, &nodes);
            } else {
                let parents = halved(&nodes);
                // What lies beside the drawn children is of the mip that was built there last, until it is fetched.
                for children in parents.iter().map(doubled).filter(|children| !nodes.contains(children)) {
                    self.copy(encoder, (mip, level - 1), &children, Way::Back);
                }
                nodes = parents;
                self.draw(encoder, Pass::Nodes, (&self.quadtree, mip + level - 1), target, &nodes);
            }
            nodes.iter().for_each(|region| self.copy(encoder, (mip, level), region, Way::There));
        }
    }

    fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        pass: Pass,
        from: (&wgpu::Texture, u32),
        to: (&wgpu::Texture, u32),
        regions: &[Region],
    ) {
        self.passes.draw(self.gpu, encoder, pass, [view(from), view(to)], regions);
    }

    /// A region of a level of a mip's quadtree, to the image of all bounds or back.
    fn copy(&self, encoder: &mut wgpu::CommandEncoder, (mip, level): (u32, u32), [x, y]: &Region, way: Way) {
        let at = |texture, mip_level, [x, y]: [u32; 2]| wgpu::TexelCopyTextureInfo {
            texture,
            mip_level,
            origin: wgpu::Origin3d { x, y, z: 0 },
            aspect: wgpu::TextureAspect::All,
        };
        let size = wgpu::Extent3d { width: x.end - x.start, height: y.end - y.start, depth_or_array_layers: 1 };
        let place = self.extent.place(mip, level);
        let alone = at(&self.quadtree, mip + level, [x.start, y.start]);
        let among = at(&self.bounds, 0, [place[0] + x.start, place[1] + y.start]);
        let (from, to) = if way == Way::There { (alone, among) } else { (among, alone) };
        encoder.copy_texture_to_texture(from, to, size);
    }

    /// The rows of a rectangle, from its first column on.
    fn upload(&self, heights: &Heights, [x, y]: &Region) -> Result<(), RenderError> {
        let (format, bytes) = bytes(heights)?;
        assert_eq!(self.source.format(), format, "a map of other texels");
        let texel = bytes.len() as u32 / (self.extent.size[0] * self.extent.size[1]);
        let stride = self.extent.size[0] * texel;
        let mut target = self.source.as_image_copy();
        target.origin = wgpu::Origin3d { x: x.start, y: y.start, z: 0 };
        let layout = wgpu::TexelCopyBufferLayout {
            offset: u64::from(y.start) * u64::from(stride) + u64::from(x.start * texel),
            bytes_per_row: Some(stride),
            rows_per_image: None,
        };
        let size = wgpu::Extent3d { width: x.end - x.start, height: y.end - y.start, depth_or_array_layers: 1 };
        self.gpu.checked("relief's map", || self.gpu.queue.write_texture(target, bytes, layout, size))
    }
}

/// Between the quadtree of one mip and the image of all bounds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    There,
    Back,
}

/// The children of some nodes.
fn doubled(region: &Region) -> Region {
    region.clone().map(|range| 2 * range.start..2 * range.end)
}

/// The texels of a map as a device takes them.
fn bytes(heights: &Heights) -> Result<(wgpu::TextureFormat, &[u8]), RenderError> {
    match heights.texels() {
        Texels::U8(values) => Ok((wgpu::TextureFormat::R8Uint, values)),
        Texels::U16(values) => Ok((SIXTEEN, bytemuck::cast_slice(values))),
        Texels::F32(_) => Err(RenderError::Scene(Unplaceable::Floats.to_string())),
    }
}

fn texture(
    gpu: &Gpu,
    format: wgpu::TextureFormat,
    [width, height]: [u32; 2],
    mip_level_count: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

fn view((texture, mip): (&wgpu::Texture, u32)) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        base_mip_level: mip,
        mip_level_count: Some(1),
        ..Default::default()
    })
}
