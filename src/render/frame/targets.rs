//! What is drawn into.

use crate::render::error::Result;
use crate::render::gpu::Gpu;

/// Radiance before the tone curve.
pub(crate) const RADIANCE: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Depth: 1 near, 0 at infinity.
pub(crate) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Depth of a displaced surface, before it is put in place of the ground's; 0 where there is none.
pub(crate) const DISPLACED: wgpu::TextureFormat = wgpu::TextureFormat::R32Float;

/// Radiance and depth of every sample.
#[derive(Debug)]
pub(crate) struct Targets {
    pub(crate) radiance: wgpu::Texture,
    pub(crate) depth: wgpu::Texture,
    /// Only where something is displaced.
    pub(crate) displaced: Option<wgpu::Texture>,
}

impl Targets {
    /// For a picture of that many samples across and down.
    pub(crate) fn new(gpu: &Gpu, width: u32, height: u32, displaced: bool) -> Result<Self> {
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
            radiance: texture(
                "radiance",
                RADIANCE,
                wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC,
            ),
            depth: texture("depth", DEPTH, wgpu::TextureUsages::COPY_SRC),
            displaced: displaced.then(|| {
                texture(
                    "displaced depth",
                    DISPLACED,
                    wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC,
                )
            }),
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

    /// A pass that keeps the depth and draws the first light of a picture.
    pub(crate) fn sky_pass<'e>(&self, encoder: &'e mut wgpu::CommandEncoder) -> wgpu::RenderPass<'e> {
        self.pass(encoder, &[(&self.radiance, true)])
    }

    /// A pass that keeps the depth and draws light of terrain on top of what is there: the first of them, or another.
    pub(crate) fn light_pass<'e>(&self, encoder: &'e mut wgpu::CommandEncoder, first: bool) -> wgpu::RenderPass<'e> {
        let displaced = self.displaced.iter().map(|displaced| (displaced, first));
        self.pass(encoder, &std::iter::once((&self.radiance, false)).chain(displaced).collect::<Vec<_>>())
    }

    /// A pass that writes depth alone, over what is there.
    pub(crate) fn displaced_pass<'e>(&self, encoder: &'e mut wgpu::CommandEncoder) -> wgpu::RenderPass<'e> {
        self.pass(encoder, &[])
    }

    /// A pass that draws light and depth of what stands on terrain, over what is there.
    pub(crate) fn objects_pass<'e>(&self, encoder: &'e mut wgpu::CommandEncoder) -> wgpu::RenderPass<'e> {
        self.pass(encoder, &[(&self.radiance, false)])
    }

    /// Colours, each cleared or not.
    fn pass<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        colors: &[(&wgpu::Texture, bool)],
    ) -> wgpu::RenderPass<'e> {
        let views: Vec<wgpu::TextureView> = colors.iter().map(|(texture, _)| whole(texture)).collect();
        let attachments = views.iter().zip(colors).map(|(view, (_, clear))| {
            let load = if *clear { wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT) } else { wgpu::LoadOp::Load };
            let ops = wgpu::Operations { load, store: wgpu::StoreOp::Store };
            Some(wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops })
        });
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("light"),
            color_attachments: &attachments.collect::<Vec<_>>(),
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
