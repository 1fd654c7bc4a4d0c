//! Group 0: what the renderer gives to every shader of a picture.

use super::objects::ObjectsUniform;
use super::texture::{Table, half_colours, half_vectors, halves, mips};
use super::uniform::ViewUniform;
use crate::render::air::{AERIAL_CELLS, Aerial, SKY_TEXELS, SkyTable};
use crate::render::error::Result;
use crate::render::gpu::Gpu;
use crate::render::height_field::HeightField;
use crate::render::light::LightMap;
use crate::render::lights::Lights;

/// Layout and contents of group 0.
#[derive(Debug)]
pub(crate) struct Bound {
    pub(crate) layout: wgpu::BindGroupLayout,
    pub(crate) group: wgpu::BindGroup,
}

/// Everything that a picture's shaders read besides the material.
pub(crate) struct Tables<'a> {
    pub(crate) view: ViewUniform,
    pub(crate) objects: ObjectsUniform,
    pub(crate) lights: &'a Lights,
    pub(crate) sky: &'a SkyTable,
    pub(crate) aerial: &'a Aerial,
    pub(crate) field: &'a HeightField,
    pub(crate) light: &'a LightMap,
}

/// Textures at bindings 1, 2, 4, 5 and 6, as shaderlib/hosts/wgpu declares them; 0 and 7 are uniforms, 3 the sampler.
const TEXTURES: [(u32, wgpu::TextureViewDimension, bool); 5] = [
    (1, wgpu::TextureViewDimension::D2, true),
    (2, wgpu::TextureViewDimension::D3, true),
    (4, wgpu::TextureViewDimension::D2, false),
    (5, wgpu::TextureViewDimension::D2, true),
    (6, wgpu::TextureViewDimension::D2Array, true),
];

impl Bound {
    /// Uploads the tables and binds them.
    pub(crate) fn new(gpu: &Gpu, tables: &Tables<'_>) -> Result<Self> {
        let views = [tables.sky(), tables.aerial(), tables.height(), tables.horizon(), tables.light()]
            .iter()
            .map(|table| table.upload(gpu))
            .collect::<Result<Vec<_>>>()?;
        gpu.checked("picture's bindings", || bind(gpu, tables, &views))
    }
}

impl Tables<'_> {
    fn sky(&self) -> Table {
        let texels = self.sky.texels.iter().map(|&radiance| self.lights.expose(radiance));
        let [width, height] = SKY_TEXELS;
        let levels = vec![half_colours(texels)];
        Table { levels, ..flat("sky", [width, height], wgpu::TextureFormat::Rgba16Float) }
    }

    fn aerial(&self) -> Table {
        let texels = self.aerial.cells.iter().map(|&radiance| self.lights.expose(radiance));
        Table {
            label: "aerial",
            size: AERIAL_CELLS,
            dimension: wgpu::TextureViewDimension::D3,
            format: wgpu::TextureFormat::Rgba16Float,
            levels: vec![half_colours(texels)],
        }
    }

    fn height(&self) -> Table {
        let levels = mips(self.field.texels(), self.field.size());
        let levels = levels.into_iter().map(|level| bytemuck::cast_slice(&level).to_vec()).collect();
        Table { levels, ..flat("height map", self.field.size(), wgpu::TextureFormat::R32Float) }
    }

    fn horizon(&self) -> Table {
        let levels = mips(&self.light.horizon, self.light.horizon_size);
        let levels = levels.into_iter().map(|level| halves(&level)).collect();
        Table { levels, ..flat("horizon", self.light.horizon_size, wgpu::TextureFormat::R16Float) }
    }

    fn light(&self) -> Table {
        let [width, height] = self.light.sky_size;
        Table {
            label: "light map",
            size: [width, height, 2],
            dimension: wgpu::TextureViewDimension::D2Array,
            format: wgpu::TextureFormat::Rgba16Float,
            levels: vec![half_vectors(self.light.sky.iter().chain(&self.light.images).copied())],
        }
    }
}

/// A table of one layer that has still to be filled.
fn flat(label: &'static str, [width, height]: [u32; 2], format: wgpu::TextureFormat) -> Table {
    let dimension = wgpu::TextureViewDimension::D2;
    Table { label, size: [width, height, 1], dimension, format, levels: Vec::new() }
}

fn bind(gpu: &Gpu, tables: &Tables<'_>, views: &[wgpu::TextureView]) -> Bound {
    let layout = layout(gpu);
    let view = uniform(gpu, "view", bytemuck::bytes_of(&tables.view));
    let objects = uniform(gpu, "objects", bytemuck::bytes_of(&tables.objects));
    let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("tables"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..Default::default()
    });
    let mut entries = vec![
        wgpu::BindGroupEntry { binding: 0, resource: view.as_entire_binding() },
        wgpu::BindGroupEntry { binding: 7, resource: objects.as_entire_binding() },
        wgpu::BindGroupEntry { binding: 3, resource: wgpu::BindingResource::Sampler(&sampler) },
    ];
    for ((binding, ..), view) in TEXTURES.into_iter().zip(views) {
        entries.push(wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(view) });
    }
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("picture"),
        layout: &layout,
        entries: &entries,
    });
    Bound { layout, group }
}

fn uniform(gpu: &Gpu, label: &'static str, bytes: &[u8]) -> wgpu::Buffer {
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: bytes.len() as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, bytes);
    buffer
}

fn layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty,
        count: None,
    };
    let uniform = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Uniform,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let mut entries = vec![entry(0, uniform), entry(3, sampler), entry(7, uniform)];
    for (binding, view_dimension, filterable) in TEXTURES {
        let sample_type = wgpu::TextureSampleType::Float { filterable };
        entries.push(entry(binding, wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false }));
    }
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("picture"), entries: &entries })
}
