//! Passes that draw one level of numbers from another.

use bytemuck::{Pod, Zeroable};
use terrane_shaderlib::hosts;
use terrane_shaderlib::relief::Region;
use wgpu::util::{BufferInitDescriptor, DeviceExt as _};

use super::level::Level;
use super::parts::{Parts, SIDE};
use crate::render::{Gpu, RenderError};

/// What every pass is made of.
#[derive(Debug)]
pub(super) struct Passes<'a> {
    pub(super) gpu: &'a Gpu,
    source: wgpu::BindGroupLayout,
    module: wgpu::ShaderModule,
    pub(super) parts: Parts,
}

/// Where a pass draws: `BuildPart` of `hosts/relief/build.wgsl`, but for the size of the source.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Part {
    pub(super) corner: [u32; 2],
    pub(super) first: [u32; 2],
    pub(super) behind: [u32; 2],
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct DevicePart {
    size: [u32; 2],
    corner: [u32; 2],
    first: [u32; 2],
    behind: [u32; 2],
}

/// What is drawn of a target.
enum Drawn<'a> {
    Regions(&'a [Region]),
    /// Those parts that are reached, of a level with such a corner and size.
    Parts([u32; 2], [u32; 2]),
}

/// One of them, for targets of one kind.
#[derive(Debug)]
pub(super) struct Pass {
    device: wgpu::Device,
    source: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

impl<'a> Passes<'a> {
    /// Parses their text.
    pub(super) fn new(gpu: &'a Gpu) -> Result<Self, RenderError> {
        gpu.checked("relief's passes", || {
            let source = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("relief's source"),
                entries: &ENTRIES,
            });
            let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("relief's passes"),
                source: wgpu::ShaderSource::Wgsl(hosts::join(hosts::WGPU_RELIEF_BUILD).into()),
            });
            Self { gpu, source, module, parts: Parts::new(&gpu.device, &gpu.queue) }
        })
    }

    /// Compiles the pass of an entry point with its constants.
    pub(super) fn pass(
        &self,
        entry: &str,
        target: impl Into<wgpu::ColorTargetState>,
        constants: &[(&str, f64)],
    ) -> Pass {
        self.pass_beside(entry, target, constants, None)
    }

    /// One that reads other things beside its source.
    pub(super) fn pass_beside(
        &self,
        entry: &str,
        target: impl Into<wgpu::ColorTargetState>,
        constants: &[(&str, f64)],
        beside: Option<&wgpu::BindGroupLayout>,
    ) -> Pass {
        self.compiled(
            ("build_vertex", &[]),
            (entry, constants),
            target.into(),
            &[beside][..usize::from(beside.is_some())],
        )
    }

    /// One that draws those parts of a level that are reached, or are read where one up to so many parts behind is.
    pub(super) fn pass_of_parts(
        &self,
        entry: &str,
        target: impl Into<wgpu::ColorTargetState>,
        constants: &[(&str, f64)],
        (beside, before): (Option<&wgpu::BindGroupLayout>, u32),
    ) -> Pass {
        let vertex = [("build_before", f64::from(before)), ("build_side", f64::from(SIDE))];
        let beside = [beside, Some(&self.parts.layout)];
        self.compiled(("build_part_vertex", &vertex), (entry, constants), target.into(), &beside)
    }

    fn compiled(
        &self,
        (vertex, vertex_constants): (&str, &[(&str, f64)]),
        (entry, constants): (&str, &[(&str, f64)]),
        target: wgpu::ColorTargetState,
        beside: &[Option<&wgpu::BindGroupLayout>],
    ) -> Pass {
        let options = |constants| wgpu::PipelineCompilationOptions { constants, ..Default::default() };
        let device = self.gpu.device.clone();
        let groups: Vec<_> = std::iter::once(Some(&self.source)).chain(beside.iter().copied()).collect();
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(entry),
            bind_group_layouts: &groups,
            ..Default::default()
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(entry),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &self.module,
                entry_point: Some(vertex),
                compilation_options: options(vertex_constants),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &self.module,
                entry_point: Some(entry),
                compilation_options: options(constants),
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        });
        Pass { device, source: self.source.clone(), pipeline }
    }
}

impl Pass {
    /// Draws regions of one level from another, which begins where its texture does.
    pub(super) fn draw(&self, encoder: &mut wgpu::CommandEncoder, from: Level<'_>, to: Level<'_>, regions: &[Region]) {
        self.draw_part(encoder, [from, to], Part::default(), regions);
    }

    /// The same for a level that begins elsewhere.
    pub(super) fn draw_at(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        [from, to]: [Level<'_>; 2],
        corner: [u32; 2],
        regions: &[Region],
    ) {
        let moved =
            |[x, y]: &Region| [(x, corner[0]), (y, corner[1])].map(|(range, by)| range.start + by..range.end + by);
        let regions: Vec<Region> = regions.iter().map(moved).collect();
        self.draw_part(encoder, [from, to], Part { corner, ..Part::default() }, &regions);
    }

    /// Draws regions of a texture.
    pub(super) fn draw_part(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        levels: [Level<'_>; 2],
        part: Part,
        regions: &[Region],
    ) {
        self.draw_groups(encoder, levels, part, &[], &Drawn::Regions(regions));
    }

    /// Draws a whole level with what it reads beside its source, which begins at a corner of its texture.
    pub(super) fn draw_beside(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        levels: [Level<'_>; 2],
        corner: [u32; 2],
        beside: &wgpu::BindGroup,
    ) {
        let whole = levels[1].size.map(|side| 0..side);
        let part = Part { corner, ..Part::default() };
        self.draw_groups(encoder, levels, part, &[Some(beside)], &Drawn::Regions(&[whole]));
    }

    /// Draws parts of a level that begins at a corner of its texture and has so many columns and rows.
    pub(super) fn draw_parts(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        levels: [Level<'_>; 2],
        part: Part,
        (beside, parts): (Option<&wgpu::BindGroup>, &wgpu::BindGroup),
    ) {
        self.draw_groups(encoder, levels, part, &[beside, Some(parts)], &Drawn::Parts(part.corner, part.behind));
    }

    fn draw_groups(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        [from, to]: [Level<'_>; 2],
        part: Part,
        beside: &[Option<&wgpu::BindGroup>],
        drawn: &Drawn<'_>,
    ) {
        let group = self.bind(from, part);
        let view = to.view();
        let target = wgpu::RenderPassColorAttachment {
            view: &view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("relief's level"),
            color_attachments: &[Some(target)],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        for (index, group) in std::iter::once(Some(&group)).chain(beside.iter().copied()).enumerate() {
            pass.set_bind_group(index as u32, group, &[]);
        }
        drawn.draw(&mut pass);
    }

    fn bind(&self, from: Level<'_>, Part { corner, first, behind }: Part) -> wgpu::BindGroup {
        let part = self.device.create_buffer_init(&BufferInitDescriptor {
            label: Some("relief's part"),
            contents: bytemuck::bytes_of(&DevicePart { size: from.size, corner, first, behind }),
            usage: wgpu::BufferUsages::UNIFORM,
        });
        let view = from.view();
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("relief's source"),
            layout: &self.source,
            entries: &[bound(0, &view), wgpu::BindGroupEntry { binding: 1, resource: part.as_entire_binding() }],
        })
    }
}

impl Drawn<'_> {
    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        match self {
            Self::Regions(regions) => {
                for [x, y] in *regions {
                    pass.set_scissor_rect(x.start, y.start, x.end - x.start, y.end - y.start);
                    pass.draw(0..3, 0..1);
                }
            }
            Self::Parts([x, y], [width, height]) => {
                let [left, top, across, down] = [x, y, width, height].map(|number| *number as f32);
                pass.set_viewport(left, top, across, down, 0.0, 1.0);
                pass.set_scissor_rect(*x, *y, *width, *height);
                pass.draw(0..6, 0..width.div_ceil(SIDE) * height.div_ceil(SIDE));
            }
        }
    }
}

const ENTRIES: [wgpu::BindGroupLayoutEntry; 2] =
    [texture(0, wgpu::TextureSampleType::Uint, wgpu::TextureViewDimension::D2), uniform(1)];

/// A texture that a pass reads.
pub(super) const fn texture(
    binding: u32,
    sample_type: wgpu::TextureSampleType,
    view_dimension: wgpu::TextureViewDimension,
) -> wgpu::BindGroupLayoutEntry {
    entry(binding, wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false })
}

/// The texture that is bound there.
pub(super) fn bound(binding: u32, view: &wgpu::TextureView) -> wgpu::BindGroupEntry<'_> {
    wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(view) }
}

/// Numbers that a pass reads.
pub(super) const fn uniform(binding: u32) -> wgpu::BindGroupLayoutEntry {
    let (ty, min_binding_size) = (wgpu::BufferBindingType::Uniform, None);
    entry(binding, wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size })
}

const fn entry(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::VERTEX_FRAGMENT, ty, count: None }
}
