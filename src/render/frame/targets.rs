//! What is drawn into.

use crate::render::error::Result;
use crate::render::gpu::Gpu;

/// Radiance before the tone curve.
pub(crate) const RADIANCE: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Depth: 1 near, 0 at infinity.
pub(crate) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Radiance and depth of every sample.
#[derive(Debug)]
pub(crate) struct Targets {
    pub(crate) radiance: wgpu::Texture,
    pub(crate) depth: wgpu::Texture,
}

impl Targets {
    /// For a picture of that many samples across and down.
    pub(crate) fn new(gpu: &Gpu, width: u32, height: u32) -> Result<Self> {
        let texture = |label, format, usage| {
            gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: &[],
            })
        };
        gpu.checked("picture's memory", || Self {
            radiance: texture("radiance", RADIANCE, wgpu::TextureUsages::TEXTURE_BINDING),
            depth: texture("depth", DEPTH, wgpu::TextureUsages::COPY_SRC),
        })
    }

    /// A pass that clears the depth and draws nothing else.
    pub(crate) fn depth_pass<'e>(&self, encoder: &'e mut wgpu::CommandEncoder) -> wgpu::RenderPass<'e> {
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("depth"),
            depth_stencil_attachment: Some(depth_attachment(wgpu::LoadOp::Clear(0.0), &whole(&self.depth))),
            ..Default::default()
        })
    }

    /// A pass that keeps the depth and draws light: the first of a picture, or on top of others.
    pub(crate) fn light_pass<'e>(&self, encoder: &'e mut wgpu::CommandEncoder, first: bool) -> wgpu::RenderPass<'e> {
        let load = if first { wgpu::LoadOp::Clear(wgpu::Color::BLACK) } else { wgpu::LoadOp::Load };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("light"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &whole(&self.radiance),
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load, store: wgpu::StoreOp::Store },
            })],
            depth_stencil_attachment: Some(depth_attachment(wgpu::LoadOp::Load, &whole(&self.depth))),
            ..Default::default()
        })
    }
}

fn whole(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

fn depth_attachment(load: wgpu::LoadOp<f32>, view: &wgpu::TextureView) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    let depth_ops = Some(wgpu::Operations { load, store: wgpu::StoreOp::Store });
    wgpu::RenderPassDepthStencilAttachment { view, depth_ops, stencil_ops: None }
}

/// Depth state of a pipeline.
pub(crate) fn depth_state(write: bool, compare: wgpu::CompareFunction) -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: DEPTH,
        depth_write_enabled: Some(write),
        depth_compare: Some(compare),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    }
}
