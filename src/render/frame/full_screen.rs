//! One triangle over the picture: the sky where there is no terrain, previews, and what stands on a terrain.

use super::targets::{RADIANCE, depth_state};
use crate::render::error::Result;
use crate::render::gpu::Gpu;

/// A shader with the entry points `<name>_vertex` and `<name>_fragment`.
#[derive(Debug)]
pub(crate) struct FullScreen {
    pipeline: wgpu::RenderPipeline,
}

impl FullScreen {
    /// Compiles a shader that is drawn where the depth is that of infinity.
    pub(crate) fn behind(
        gpu: &Gpu,
        name: &'static str,
        shader: &str,
        groups: &[&wgpu::BindGroupLayout],
    ) -> Result<Self> {
        Self::new(gpu, name, shader, groups, depth_state(false, wgpu::CompareFunction::Equal))
    }

    /// Compiles a shader that gives a depth, and is drawn where that is nearer than what is there.
    pub(crate) fn among(
        gpu: &Gpu,
        name: &'static str,
        shader: &str,
        groups: &[&wgpu::BindGroupLayout],
    ) -> Result<Self> {
        Self::new(gpu, name, shader, groups, depth_state(true, wgpu::CompareFunction::Greater))
    }

    fn new(
        gpu: &Gpu,
        name: &'static str,
        shader: &str,
        groups: &[&wgpu::BindGroupLayout],
        depth: wgpu::DepthStencilState,
    ) -> Result<Self> {
        let module = gpu.checked("shader", || {
            gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(name),
                source: wgpu::ShaderSource::Wgsl(shader.into()),
            })
        })?;
        gpu.checked("pipeline", || Self { pipeline: pipeline(gpu, name, &module, groups, depth) })
    }

    /// Draws with these groups, from 0 on.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, groups: &[&wgpu::BindGroup]) {
        pass.set_pipeline(&self.pipeline);
        for (index, group) in groups.iter().enumerate() {
            pass.set_bind_group(index as u32, *group, &[]);
        }
        pass.draw(0..3, 0..1);
    }
}

fn pipeline(
    gpu: &Gpu,
    name: &str,
    module: &wgpu::ShaderModule,
    groups: &[&wgpu::BindGroupLayout],
    depth: wgpu::DepthStencilState,
) -> wgpu::RenderPipeline {
    let groups: Vec<Option<&wgpu::BindGroupLayout>> = groups.iter().copied().map(Some).collect();
    let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(name),
        bind_group_layouts: &groups,
        immediate_size: 0,
    });
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(name),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(&format!("{name}_vertex")),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(depth),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(&format!("{name}_fragment")),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(RADIANCE.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
