//! The graphics device: which there are, which one is used.

use std::sync::{Arc, Mutex};

use terrane_shaderlib::relief::Platform;

use super::error::{RenderError, Result};

/// Which adapter to use.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Selection {
    /// The fastest kind there is.
    #[default]
    Best,
    /// The position in [`Gpu::list`].
    Index(usize),
    /// A part of the name, whatever its case.
    Name(String),
}

impl Selection {
    /// What a user writes: a number is an index, anything else a part of a name.
    #[must_use]
    pub fn parse(text: &str) -> Self {
        text.parse().map_or_else(|_| Self::Name(text.to_owned()), Self::Index)
    }

    fn pick(&self, names: &[String]) -> Option<usize> {
        match self {
            Self::Best => (!names.is_empty()).then_some(0),
            Self::Index(index) => (*index < names.len()).then_some(*index),
            Self::Name(part) => {
                let part = part.to_lowercase();
                names.iter().position(|name| name.to_lowercase().contains(&part))
            }
        }
    }
}

/// An open device.
#[derive(Debug)]
pub struct Gpu {
    name: String,
    /// Whether a processor draws.
    software: bool,
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    /// What the driver reported outside of any error scope.
    failure: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Opens a device with the default limits of WebGPU and no optional feature.
    ///
    /// # Errors
    /// [`RenderError::NoAdapter`] where there is none at all, [`RenderError::UnknownAdapter`] where none is meant by the
    /// selection, [`RenderError::Device`] where the driver gives no device.
    pub fn new(selection: &Selection) -> Result<Self> {
        let descriptor = wgpu::DeviceDescriptor { label: Some("terrane"), ..Default::default() };
        Self::open(selection, |_| descriptor)
    }

    /// Opens a device to measure on: with timestamps and the largest textures that it has.
    ///
    /// # Errors
    /// Those of [`Gpu::new`].
    pub fn measuring(selection: &Selection) -> Result<Self> {
        Self::open(selection, |adapter| {
            let largest = adapter.limits().max_texture_dimension_2d;
            wgpu::DeviceDescriptor {
                label: Some("terrane"),
                required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
                required_limits: wgpu::Limits { max_texture_dimension_2d: largest, ..Default::default() },
                ..Default::default()
            }
        })
    }

    fn open(
        selection: &Selection,
        describe_device: impl FnOnce(&wgpu::Adapter) -> wgpu::DeviceDescriptor<'static>,
    ) -> Result<Self> {
        let adapters = adapters();
        let names: Vec<String> = adapters.iter().map(describe).collect();
        if names.is_empty() {
            return Err(RenderError::NoAdapter);
        }
        let index = selection.pick(&names).ok_or_else(|| unknown(selection, &names))?;
        let name = names[index].clone();
        let software = adapters[index].get_info().device_type == wgpu::DeviceType::Cpu;
        let (device, queue) = pollster::block_on(adapters[index].request_device(&describe_device(&adapters[index])))
            .map_err(|error| RenderError::Device { adapter: name.clone(), reason: error.to_string() })?;
        let failure = Arc::new(Mutex::new(None));
        let seen = Arc::clone(&failure);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            if let Ok(mut seen) = seen.lock() {
                seen.get_or_insert(error.to_string());
            }
        }));
        Ok(Self { name, software, device, queue, failure })
    }

    /// Every adapter's name, in the order of preference: discrete, integrated, virtual, software.
    #[must_use]
    pub fn list() -> Vec<String> {
        adapters().iter().map(describe).collect()
    }

    /// Name, kind and programming interface of the adapter in use.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether it takes timestamps: those of [`Gpu::measuring`] do, where the hardware does.
    #[must_use]
    pub fn has_timestamps(&self) -> bool {
        self.device.features().contains(wgpu::Features::TIMESTAMP_QUERY)
    }

    /// Whether the processor draws.
    #[must_use]
    pub fn platform(&self) -> Platform {
        if self.software { Platform::Cpu } else { Platform::Gpu }
    }

    /// Samples along a footprint, of those that a sampler asks for.
    ///
    /// A processor takes them one after the other: four cost 4.5 times the time of a whole picture. It takes one; the
    /// samples of each pixel do most of what they would.
    pub(super) fn anisotropy(&self, wanted: u8) -> u16 {
        if self.software { 1 } else { u16::from(wanted.clamp(1, 16)) }
    }

    /// Creates something and returns what wgpu has against it.
    pub(crate) fn checked<T>(&self, what: &'static str, create: impl FnOnce() -> T) -> Result<T> {
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let made = create();
        let errors = [pollster::block_on(validation.pop()), pollster::block_on(memory.pop())];
        match errors.into_iter().flatten().next() {
            None => Ok(made),
            Some(error) => Err(RenderError::Refused { what, reason: error.to_string() }),
        }
    }

    /// The bytes of a buffer that may be mapped, once everything that was submitted is done.
    pub(crate) fn read(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>> {
        let (send, receive) = std::sync::mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // The receiver lives until the result is there.
            drop(send.send(result));
        });
        self.wait()?;
        let lost = |error: String| RenderError::Lost(error);
        receive.recv().map_err(|error| lost(error.to_string()))?.map_err(|error| lost(error.to_string()))?;
        Ok(buffer.get_mapped_range(..).map_err(|error| lost(error.to_string()))?.to_vec())
    }

    /// Waits until everything that was submitted is done.
    pub(crate) fn wait(&self) -> Result<()> {
        self.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| RenderError::Lost(error.to_string()))?;
        match self.failure.lock().ok().and_then(|mut failure| failure.take()) {
            None => Ok(()),
            Some(reason) => Err(RenderError::Lost(reason)),
        }
    }
}

/// Vulkan, Metal and Direct3D 12, whichever the platform has. OpenGL lacks parts of core WebGPU and is not compiled in.
///
/// Mesa's device-selection layer looks for a Wayland display as soon as an instance could present to one, and complains
/// on stderr where there is none. wgpu always asks for what presenting needs, so only the environment can keep the layer
/// out: `NODEVICE_SELECT=1`, which is left to the user, who may choose a device through that very layer.
fn adapters() -> Vec<wgpu::Adapter> {
    let backends = wgpu::Backends::PRIMARY;
    let descriptor = wgpu::InstanceDescriptor { backends, ..wgpu::InstanceDescriptor::new_without_display_handle() };
    let instance = wgpu::Instance::new(descriptor);
    let mut adapters = pollster::block_on(instance.enumerate_adapters(backends));
    adapters.sort_by_key(|adapter| match adapter.get_info().device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Cpu => 3,
        wgpu::DeviceType::Other => 4,
    });
    adapters
}

fn describe(adapter: &wgpu::Adapter) -> String {
    let info = adapter.get_info();
    format!("{} ({:?}, {:?})", info.name, info.device_type, info.backend)
}

fn unknown(selection: &Selection, names: &[String]) -> RenderError {
    let wanted = match selection {
        Selection::Best => String::new(),
        Selection::Index(index) => index.to_string(),
        Selection::Name(name) => name.clone(),
    };
    let known = names.iter().enumerate().map(|(index, name)| format!("{index}: {name}")).collect();
    RenderError::UnknownAdapter { wanted, known }
}
