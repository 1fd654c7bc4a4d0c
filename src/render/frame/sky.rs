//! The sky where there is no terrain.

use terrane_shaderlib::hosts;

use super::group::Bound;
use super::targets::{RADIANCE, depth_state};
use crate::render::error::Result;
use crate::render::gpu::Gpu;

/// One triangle behind everything.
#[derive(Debug)]
pub(crate) struct SkyPipeline {
    pipeline: wgpu::RenderPipeline,
}

impl SkyPipeline {
    /// Compiles the shader.
    pub(crate) fn new(gpu: &Gpu, bound: &Bound) -> Result<Self> {
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("sky"),
            bind_group_layouts: &[Some(&bound.layout)],
            immediate_size: 0,
        });
        gpu.checked("sky's shader", || Self { pipeline: pipeline(gpu, &layout) })
    }

    /// Draws where the depth is still that of infinity.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, bound: &Bound) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &bound.group, &[]);
        pass.draw(0..3, 0..1);
    }
}

fn pipeline(gpu: &Gpu, layout: &wgpu::PipelineLayout) -> wgpu::RenderPipeline {
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("sky"),
        source: wgpu::ShaderSource::Wgsl(hosts::join(hosts::WGPU_SKY).into()),
    });
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("sky"),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("sky_vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(depth_state(false, wgpu::CompareFunction::Equal)),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("sky_fragment"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(RADIANCE.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
