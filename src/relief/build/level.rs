//! One level of whole numbers, as a pass reads or draws it.

use crate::render::Gpu;

/// A mip of a texture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level<'t> {
    pub(super) texture: &'t wgpu::Texture,
    pub(super) mip: u32,
    /// Its columns and rows; the mip may have more.
    pub(super) size: [u32; 2],
}

impl<'t> Level<'t> {
    /// A mip that is a level as it is.
    pub(super) fn whole(texture: &'t wgpu::Texture, mip: u32) -> Self {
        let size = texture.size().mip_level_size(mip, wgpu::TextureDimension::D2);
        Self { texture, mip, size: [size.width, size.height] }
    }

    pub(super) fn view(self) -> wgpu::TextureView {
        self.texture.create_view(&wgpu::TextureViewDescriptor {
            base_mip_level: self.mip,
            mip_level_count: Some(1),
            ..Default::default()
        })
    }
}

/// A texture that passes draw and read, and others may read as `usage` says.
pub(super) fn texture(
    gpu: &Gpu,
    format: wgpu::TextureFormat,
    [width, height]: [u32; 2],
    mip_level_count: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    use wgpu::TextureUsages as Usage;
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("relief"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | Usage::TEXTURE_BINDING | Usage::RENDER_ATTACHMENT | Usage::COPY_SRC,
        view_formats: &[],
    })
}
