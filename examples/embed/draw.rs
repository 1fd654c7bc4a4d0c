//! One pass over the whole terrain.

use std::path::Path;

use super::device::Device;
use super::manifest::Manifest;
use super::view::{PICTURE, patches};
use super::{material, view};

const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// 16 × 16 quads of two triangles: `ENGINE_QUADS` in engine.wgsl.
const VERTICES: u32 = 16 * 16 * 6;

/// Draws the terrain with the shader and gives the picture's bytes.
pub(crate) fn draw(manifest: &Manifest, shader: &str, root: &Path) -> Result<Vec<u8>, String> {
    let terrain =
        manifest.terrain.as_ref().ok_or("this manifest is of a surface alone: there is no terrain to draw")?;
    let device = Device::open()?;
    let pipeline = pipeline(&device, shader)?;
    let view = view::bind(&device, &pipeline.get_bind_group_layout(0), terrain, root)?;
    let material = material::bind(&device, &pipeline.get_bind_group_layout(1), manifest, root)?;
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
    let color = device.texture([PICTURE[0], PICTURE[1], 1], 1, COLOR, usage);
    let depth = device.texture([PICTURE[0], PICTURE[1], 1], 1, DEPTH, wgpu::TextureUsages::RENDER_ATTACHMENT);
    let mut encoder = device.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut pass = begin(&mut encoder, &color, &depth);
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &view, &[]);
    pass.set_bind_group(1, &material, &[]);
    let [columns, rows] = patches(terrain);
    pass.draw(0..VERTICES, 0..columns * rows);
    drop(pass);
    device.queue.submit([encoder.finish()]);
    device.read(&color)
}

fn begin<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    color: &wgpu::Texture,
    depth: &wgpu::Texture,
) -> wgpu::RenderPass<'e> {
    let view = |texture: &wgpu::Texture| texture.create_view(&wgpu::TextureViewDescriptor::default());
    let sky = wgpu::Color { r: 0.34, g: 0.42, b: 0.53, a: 1.0 };
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("terrain"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &view(color),
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(sky), store: wgpu::StoreOp::Store },
        })],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &view(depth),
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Discard }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}

/// With the layout that wgpu finds in the shader.
fn pipeline(device: &Device, shader: &str) -> Result<wgpu::RenderPipeline, String> {
    let device = &device.device;
    let scope = device.push_error_scope(wgpu::ErrorFilter::Validation);
    let source = wgpu::ShaderSource::Wgsl(shader.into());
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some("terrain"), source });
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("terrain"),
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("engine_vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState { cull_mode: Some(wgpu::Face::Back), ..Default::default() },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("engine_fragment"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(COLOR.into())],
        }),
        multiview_mask: None,
        cache: None,
    });
    pollster::block_on(scope.pop()).map_or(Ok(pipeline), |error| Err(error.to_string()))
}
