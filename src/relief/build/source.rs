//! The map as it came, on the device.

use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::Region;

use super::level::{Level, texture};
use crate::render::{Gpu, RenderError};

/// A texture of the map's own texels; of floats it has the bits.
#[derive(Debug)]
pub(super) struct Source {
    border: Border,
    texture: wgpu::Texture,
}

impl Source {
    /// Room for a map.
    pub(super) fn new(gpu: &Gpu, heights: &Heights) -> Self {
        let (format, _) = bytes(heights);
        let texture = texture(gpu, format, heights.size(), 1, wgpu::TextureUsages::COPY_DST);
        Self { border: heights.border(), texture }
    }

    pub(super) fn format(&self) -> wgpu::TextureFormat {
        self.texture.format()
    }

    pub(super) fn level(&self) -> Level<'_> {
        Level::whole(&self.texture, 0)
    }

    /// The rows of a rectangle, from its first column on.
    ///
    /// # Panics
    /// If the map has another size or border, or texels of another kind.
    pub(super) fn upload(&self, gpu: &Gpu, heights: &Heights, [x, y]: &Region) -> Result<(), RenderError> {
        let (format, bytes) = bytes(heights);
        let size = heights.size();
        assert_eq!((self.level().size, self.border), (size, heights.border()), "a map of another size or border");
        assert_eq!(self.format(), format, "a map of other texels");
        let texel = bytes.len() as u32 / (size[0] * size[1]);
        let stride = size[0] * texel;
        let mut target = self.texture.as_image_copy();
        target.origin = wgpu::Origin3d { x: x.start, y: y.start, z: 0 };
        let layout = wgpu::TexelCopyBufferLayout {
            offset: u64::from(y.start) * u64::from(stride) + u64::from(x.start * texel),
            bytes_per_row: Some(stride),
            rows_per_image: None,
        };
        let size = wgpu::Extent3d { width: x.end - x.start, height: y.end - y.start, depth_or_array_layers: 1 };
        gpu.checked("relief's map", || gpu.queue.write_texture(target, bytes, layout, size))
    }
}

/// The texels of a map as a device takes them.
fn bytes(heights: &Heights) -> (wgpu::TextureFormat, &[u8]) {
    match heights.texels() {
        Texels::U8(values) => (wgpu::TextureFormat::R8Uint, values),
        Texels::U16(values) => (wgpu::TextureFormat::R16Uint, bytemuck::cast_slice(values)),
        Texels::F32(values) => (wgpu::TextureFormat::R32Uint, bytemuck::cast_slice(values)),
    }
}
