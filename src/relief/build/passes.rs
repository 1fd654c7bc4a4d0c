//! Passes that draw one level of whole numbers from another.

use terrane_shaderlib::hosts;
use terrane_shaderlib::relief::Region;

use crate::render::{Gpu, RenderError};

/// What a pass makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pass {
    /// The first mip from the map.
    Fill,
    /// A mip from the one before it.
    Mip,
    /// Bounds of cells from a mip.
    Cells,
    /// Bounds of nodes from those of their children.
    Nodes,
}

/// A pipeline for each of them.
#[derive(Debug)]
pub(super) struct Passes {
    layout: wgpu::BindGroupLayout,
    pipelines: [wgpu::RenderPipeline; 4],
}

impl Passes {
    /// Compiles them. Of a map that is traced tile by tile the first texels stand again at its end.
    pub(super) fn new(gpu: &Gpu, tiled: bool) -> Result<Self, RenderError> {
        gpu.checked("relief's passes", || {
            let layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("relief's source"),
                entries: &[wgpu::BindGroupLayoutEntry {
                    binding: 0,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Texture {
                        sample_type: wgpu::TextureSampleType::Uint,
                        view_dimension: wgpu::TextureViewDimension::D2,
                        multisampled: false,
                    },
                    count: None,
                }],
            });
            let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("relief's passes"),
                source: wgpu::ShaderSource::Wgsl(hosts::join(hosts::WGPU_RELIEF_BUILD).into()),
            });
            let entries = ["build_fill", "build_mip", "build_cells", "build_nodes"];
            let pipelines = entries.map(|entry| pipeline(gpu, &layout, &module, entry, tiled));
            Self { layout, pipelines }
        })
    }

    /// Draws regions of one level from another.
    pub(super) fn draw(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        pass: Pass,
        [from, to]: [wgpu::TextureView; 2],
        regions: &[Region],
    ) {
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("relief's source"),
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&from) }],
        });
        let target = wgpu::RenderPassColorAttachment {
            view: &to,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
        };
        let mut drawn = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("relief's level"),
            color_attachments: &[Some(target)],
            ..Default::default()
        });
        drawn.set_pipeline(&self.pipelines[pass as usize]);
        drawn.set_bind_group(0, &group, &[]);
        for [x, y] in regions {
            drawn.set_scissor_rect(x.start, y.start, x.end - x.start, y.end - y.start);
            drawn.draw(0..3, 0..1);
        }
    }
}

fn pipeline(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    module: &wgpu::ShaderModule,
    entry: &str,
    tiled: bool,
) -> wgpu::RenderPipeline {
    let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("relief's passes"),
        bind_group_layouts: &[Some(layout)],
        ..Default::default()
    });
    let seam = [("build_seam", f64::from(u8::from(tiled)))];
    let constants = if entry == "build_fill" { &seam[..] } else { &[] };
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(entry),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("build_vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions { constants, ..Default::default() },
            targets: &[Some(wgpu::TextureFormat::R16Uint.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
