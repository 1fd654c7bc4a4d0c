//! A device that runs probes.

use terrane_codegen::machine::Probe;
use terrane_codegen::machine::probe::Resource;
use wgpu::util::DeviceExt as _;

use super::super::texture::example_bytes;
use crate::skip::Skip;

/// An open device with the example texture.
pub(super) struct Device {
    /// The adapter's name.
    pub(super) name: String,
    device: wgpu::Device,
    queue: wgpu::Queue,
    texture: wgpu::TextureView,
    sampler: wgpu::Sampler,
}

impl Device {
    /// The system's preferred adapter, with WebGPU's default limits and no optional feature.
    pub(super) fn open() -> Result<Self, Skip> {
        let descriptor = wgpu::InstanceDescriptor {
            // Not OpenGL, which lacks parts of WebGPU.
            backends: wgpu::Backends::PRIMARY,
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        };
        let instance = wgpu::Instance::new(descriptor);
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
            .map_err(|error| Skip(format!("no adapter: {error}")))?;
        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))
            .expect("a device with the default limits");
        let (texture, sampler) = (texture(&device, &queue), sampler(&device));
        Ok(Self { name: adapter.get_info().name, device, queue, texture, sampler })
    }

    /// The results of a probe, as words.
    pub(super) fn run(&self, probe: &Probe, arguments: &[u32], points: usize) -> Vec<u32> {
        // A binding is never empty: a function without parameters gets a word that it does not read.
        let words = if arguments.is_empty() { &[0] } else { arguments };
        let input = self.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: None,
            contents: bytemuck::cast_slice(words),
            usage: wgpu::BufferUsages::STORAGE,
        });
        let size = (points * probe.outputs * 4) as u64;
        let buffer = |usage| {
            self.device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false })
        };
        let output = buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
        let readback = buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.dispatch(&mut encoder, probe, [&input, &output], points);
        encoder.copy_buffer_to_buffer(&output, 0, &readback, 0, size);
        self.queue.submit([encoder.finish()]);
        self.read(&readback)
    }

    fn dispatch(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        probe: &Probe,
        [input, output]: [&wgpu::Buffer; 2],
        points: usize,
    ) {
        let layout = layout(&self.device, &probe.resources);
        let pipeline = self.pipeline(probe, &layout);
        let resources = probe.resources.iter().map(|resource| match resource {
            Resource::Texture => wgpu::BindingResource::TextureView(&self.texture),
            Resource::Sampler => wgpu::BindingResource::Sampler(&self.sampler),
        });
        let all = [input.as_entire_binding(), output.as_entire_binding()].into_iter().chain(resources);
        let entries: Vec<wgpu::BindGroupEntry<'_>> =
            (0..).zip(all).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
        let descriptor = wgpu::BindGroupDescriptor { label: None, layout: &layout, entries: &entries };
        let group = self.device.create_bind_group(&descriptor);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.dispatch_workgroups((points as u32).div_ceil(Probe::WORKGROUP), 1, 1);
    }

    fn pipeline(&self, probe: &Probe, layout: &wgpu::BindGroupLayout) -> wgpu::ComputePipeline {
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let module = self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(&probe.function),
            source: wgpu::ShaderSource::Wgsl(probe.shader.as_str().into()),
        });
        let layout = self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            bind_group_layouts: &[Some(layout)],
            ..Default::default()
        });
        let pipeline = self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(&probe.function),
            layout: Some(&layout),
            module: &module,
            entry_point: Some("probe_main"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        if let Some(error) = pollster::block_on(scope.pop()) {
            panic!("{error}\n{}", probe.shader);
        }
        pipeline
    }

    fn read(&self, buffer: &wgpu::Buffer) -> Vec<u32> {
        buffer.slice(..).map_async(wgpu::MapMode::Read, |mapped| mapped.expect("the buffer can be mapped"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device answers");
        let bytes = buffer.slice(..).get_mapped_range().expect("the buffer is mapped");
        bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect()
    }
}

fn sampler(device: &wgpu::Device) -> wgpu::Sampler {
    device.create_sampler(&wgpu::SamplerDescriptor {
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::Repeat,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    })
}

fn texture(device: &wgpu::Device, queue: &wgpu::Queue) -> wgpu::TextureView {
    let descriptor = wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: 4, height: 4, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    let texture =
        device.create_texture_with_data(queue, &descriptor, wgpu::util::TextureDataOrder::LayerMajor, &example_bytes());
    let dimension = Some(wgpu::TextureViewDimension::D2Array);
    texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() })
}

/// Stated, not derived from the shader: it has a place for what the function does not read.
fn layout(device: &wgpu::Device, resources: &[Resource]) -> wgpu::BindGroupLayout {
    let storage = |read_only| wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Storage { read_only },
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let resources = resources.iter().map(|resource| match resource {
        Resource::Texture => wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2Array,
            multisampled: false,
        },
        Resource::Sampler => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
    });
    let entry = |(binding, ty)| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty,
        count: None,
    };
    let entries: Vec<wgpu::BindGroupLayoutEntry> =
        (0..).zip([storage(true), storage(false)].into_iter().chain(resources)).map(entry).collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries })
}
