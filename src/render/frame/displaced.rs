//! Depth of displaced surfaces, in place of the ground's.

use terrane_shaderlib::hosts;

use super::targets::depth_state;
use crate::render::error::Result;
use crate::render::gpu::Gpu;

/// Puts the second colour of a picture's light where its depth is.
#[derive(Debug)]
pub(crate) struct Displaced {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
}

impl Displaced {
    /// For this colour.
    pub(crate) fn new(gpu: &Gpu, displaced: &wgpu::Texture) -> Result<Self> {
        gpu.checked("depth of relief", || {
            let pipeline = pipeline(gpu);
            let view = displaced.create_view(&wgpu::TextureViewDescriptor::default());
            let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("displaced depth"),
                layout: &pipeline.get_bind_group_layout(0),
                entries: &[wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) }],
            });
            Self { pipeline, group }
        })
    }

    /// Draws it.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}

fn pipeline(gpu: &Gpu) -> wgpu::RenderPipeline {
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("displaced depth"),
        source: wgpu::ShaderSource::Wgsl(hosts::join(hosts::WGPU_DEPTH).into()),
    });
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("displaced depth"),
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("depth_vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(depth_state(true, wgpu::CompareFunction::Always)),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("depth_fragment"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[],
        }),
        multiview_mask: None,
        cache: None,
    })
}
