//! The terrain's patches on the device.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::group::Bound;
use super::targets::{DISPLACED, RADIANCE, depth_state};
use crate::render::error::Result;
use crate::render::geometry::{Grid, Patch};
use crate::render::gpu::Gpu;
use crate::render::height_field::HeightField;
use crate::render::material::MaterialGroup;

/// `HostPatch` of shaderlib/hosts/wgpu/terrain.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Instance {
    texel: [i32; 2],
    unfolded: [i32; 2],
    stride: [i32; 2],
    origin: [i32; 2],
    rest: [f32; 2],
}

impl Instance {
    fn new(patch: &Patch, field: &HeightField) -> Self {
        let metres = patch.tile.metres(field, patch.texel);
        let origin = metres.map(|metres| (metres * 256.0).floor());
        Self {
            texel: patch.texel,
            unfolded: patch.tile.unfold(field, patch.texel),
            stride: patch.tile.mirror().map(|mirror| mirror << patch.level),
            origin: origin.map(|units| units as i32),
            rest: [0, 1].map(|axis| (metres[axis] - origin[axis] / 256.0) as f32),
        }
    }
}

/// Both pipelines of a terrain shader: depth alone, then the nearest surface's light.
///
/// A material costs far more than a vertex: without the first pass every hidden hill would be shaded.
#[derive(Debug)]
pub(crate) struct TerrainPipeline {
    depth: wgpu::RenderPipeline,
    light: wgpu::RenderPipeline,
}

impl TerrainPipeline {
    /// Compiles a complete host shader. One whose materials have relief gives depth as a second colour.
    pub(crate) fn new(
        gpu: &Gpu,
        shader: &str,
        displaced: bool,
        bound: &Bound,
        material: &MaterialGroup,
    ) -> Result<Self> {
        let module = gpu.checked("terrain's shader", || {
            gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("terrain"),
                source: wgpu::ShaderSource::Wgsl(shader.into()),
            })
        })?;
        gpu.checked("terrain's pipelines", || {
            let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("terrain"),
                bind_group_layouts: &[Some(&bound.layout), Some(&material.layout)],
                immediate_size: 0,
            });
            let light = [Some(RADIANCE.into()), Some(DISPLACED.into())];
            let light = if displaced { &light[..] } else { &light[..1] };
            Self { depth: pipeline(gpu, &module, &layout, &[]), light: pipeline(gpu, &module, &layout, light) }
        })
    }
}

fn pipeline(
    gpu: &Gpu,
    module: &wgpu::ShaderModule,
    layout: &wgpu::PipelineLayout,
    targets: &[Option<wgpu::ColorTargetState>],
) -> wgpu::RenderPipeline {
    let corners = wgpu::vertex_attr_array![0 => Uint16x2];
    let patches = wgpu::vertex_attr_array![1 => Sint32x2, 2 => Sint32x2, 3 => Sint32x2, 4 => Sint32x2, 5 => Float32x2];
    let buffer = |array_stride, step_mode, attributes| wgpu::VertexBufferLayout { array_stride, step_mode, attributes };
    let light = !targets.is_empty();
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("terrain"),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("terrain_vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[
                Some(buffer(4, wgpu::VertexStepMode::Vertex, &corners)),
                Some(buffer(size_of::<Instance>() as u64, wgpu::VertexStepMode::Instance, &patches)),
            ],
        },
        primitive: wgpu::PrimitiveState { cull_mode: Some(wgpu::Face::Back), ..Default::default() },
        depth_stencil: Some(if light {
            depth_state(false, wgpu::CompareFunction::Equal)
        } else {
            depth_state(true, wgpu::CompareFunction::Greater)
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: light.then(|| wgpu::FragmentState {
            module,
            entry_point: Some("terrain_fragment"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// Patches of a draw. A whole picture at once would show no progress, and drivers stop work that takes seconds.
const PIECE: u32 = 128;

/// The patches of one picture: draws of one permutation each.
#[derive(Debug)]
pub(crate) struct TerrainDraw {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    instances: wgpu::Buffer,
    draws: Vec<(Range<u32>, Range<u32>)>,
}

impl TerrainDraw {
    /// Uploads the grid and the patches, whose order is kept within a permutation.
    pub(crate) fn new(gpu: &Gpu, field: &HeightField, patches: &[Patch]) -> Result<Self> {
        let grid = Grid::new();
        let (mut indices, mut instances, mut draws) = (Vec::new(), Vec::new(), Vec::new());
        for (permutation, flipped) in (0..9).flat_map(|permutation| [(permutation, false), (permutation, true)]) {
            let (first_index, first) = (indices.len() as u32, instances.len() as u32);
            let these = patches.iter().filter(|patch| (patch.permutation(), patch.flipped()) == (permutation, flipped));
            instances.extend(these.map(|patch| Instance::new(patch, field)));
            if instances.len() as u32 > first {
                let list = grid.indices[permutation].chunks_exact(3);
                indices.extend(list.flat_map(|t| if flipped { [t[0], t[2], t[1]] } else { [t[0], t[1], t[2]] }));
                let end = instances.len() as u32;
                let piece = |from: u32| (first_index..indices.len() as u32, from..end.min(from + PIECE));
                draws.extend((first..end).step_by(PIECE as usize).map(piece));
            }
        }
        gpu.checked("terrain's buffers", || Self {
            vertices: buffer(gpu, "grid", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&grid.vertices)),
            indices: buffer(gpu, "triangles", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices)),
            instances: buffer(gpu, "patches", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&instances)),
            draws,
        })
    }

    /// Draws the depth of everything.
    pub(crate) fn draw_depth(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipeline: &TerrainPipeline,
        bound: &Bound,
        material: &MaterialGroup,
    ) {
        pass.set_pipeline(&pipeline.depth);
        self.draw(pass, bound, material, &self.draws);
    }

    /// Pieces of [`Self::draw_light`], each a fraction of a second's work.
    pub(crate) fn pieces(&self) -> usize {
        self.draws.len()
    }

    /// Draws a piece of the light of what [`Self::draw_depth`] left in front.
    pub(crate) fn draw_light(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipeline: &TerrainPipeline,
        bound: &Bound,
        material: &MaterialGroup,
        piece: usize,
    ) {
        pass.set_pipeline(&pipeline.light);
        self.draw(pass, bound, material, &self.draws[piece..=piece]);
    }

    fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        bound: &Bound,
        material: &MaterialGroup,
        draws: &[(Range<u32>, Range<u32>)],
    ) {
        pass.set_bind_group(0, &bound.group, &[]);
        pass.set_bind_group(1, &material.group, &[]);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.instances.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        for (indices, instances) in draws {
            pass.draw_indexed(indices.clone(), 0, instances.clone());
        }
    }
}

fn buffer(gpu: &Gpu, label: &str, usage: wgpu::BufferUsages, bytes: &[u8]) -> wgpu::Buffer {
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        // Neither an empty buffer nor a write of an odd number of words is allowed.
        size: (bytes.len() as u64).next_multiple_of(4).max(4),
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut padded = bytes.to_vec();
    padded.resize(bytes.len().next_multiple_of(4), 0);
    gpu.queue.write_buffer(&buffer, 0, &padded);
    buffer
}
