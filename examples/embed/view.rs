//! Group 0: the engine's camera, sun and height map.

use std::path::Path;

use glam::camera::rh::{proj::directx::perspective_infinite_reverse, view::look_at_mat4};
use glam::{Mat4, Vec3};

use super::device::Device;
use super::manifest::Terrain;
use super::texture::Image;

/// Width and height of the picture.
pub(crate) const PICTURE: [u32; 2] = [960, 540];

/// As `EngineView` in engine.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct View {
    clip: Mat4,
    eye: Vec3,
    patch_size: f32,
    sun: Vec3,
    columns: u32,
    size: [f32; 2],
    patch_fixed: i32,
    padding: u32,
}

/// Patches on x and z.
pub(crate) fn patches(terrain: &Terrain) -> [u32; 2] {
    terrain.size.map(|side| (side / terrain.patch).ceil() as u32)
}

/// Binds the view uniform and the height map.
pub(crate) fn bind(
    device: &Device,
    layout: &wgpu::BindGroupLayout,
    terrain: &Terrain,
    root: &Path,
) -> Result<wgpu::BindGroup, String> {
    let image = Image::read(&root.join(&terrain.height_map), true)?;
    let [low, high] = terrain.range;
    let heights: Vec<f32> = image.values().iter().map(|value| low + value * (high - low)).collect();
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let format = wgpu::TextureFormat::R32Float;
    let texture = device.texture([image.size[0], image.size[1], 1], 1, format, usage);
    device.fill(&texture, 0, 0, bytemuck::cast_slice(&heights));
    let highest = heights.iter().copied().fold(f32::MIN, f32::max);
    let uniform = device.uniform(bytemuck::bytes_of(&view(terrain, highest)));
    let texture = texture.create_view(&wgpu::TextureViewDescriptor::default());
    let entries = [
        wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() },
        wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&texture) },
    ];
    Ok(device.device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some("view"), layout, entries: &entries }))
}

/// From above the south-west corner over the whole terrain.
fn view(terrain: &Terrain, highest: f32) -> View {
    let [width, depth] = terrain.size;
    let eye = Vec3::new(0.12 * width, highest + 0.12 * width, 0.95 * depth);
    let target = Vec3::new(0.55 * width, 0.5 * (terrain.range[0] + highest), 0.45 * depth);
    let aspect = PICTURE[0] as f32 / PICTURE[1] as f32;
    // Depth runs from 1 at the near plane to 0 at infinity: even precision all the way.
    let clip = perspective_infinite_reverse(0.8, aspect, 1.0) * look_at_mat4(eye, target, Vec3::Y);
    View {
        clip,
        eye,
        patch_size: terrain.patch,
        sun: Vec3::new(-0.6, 0.5, 0.3).normalize(),
        columns: patches(terrain)[0],
        size: terrain.size,
        patch_fixed: (terrain.patch * 256.0) as i32,
        padding: 0,
    }
}
