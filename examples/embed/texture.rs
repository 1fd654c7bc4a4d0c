//! PNG files as texels of the formats that the manifest names, with their mips.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Decoded texels: four numbers each, or one for a height; 0..1 as stored in the file.
pub(crate) struct Image {
    pub(crate) size: [u32; 2],
    channels: usize,
    values: Vec<f32>,
}

impl Image {
    /// Reads a PNG of any kind as grey or as red, green, blue and opacity.
    pub(crate) fn read(path: &Path, grey: bool) -> Result<Self, String> {
        let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let file = File::open(path).map_err(|error| fail(&error))?;
        let mut decoder = png::Decoder::new(BufReader::new(file));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().map_err(|error| fail(&error))?;
        let mut bytes = vec![0; reader.output_buffer_size().ok_or_else(|| fail(&"too large"))?];
        let frame = reader.next_frame(&mut bytes).map_err(|error| fail(&error))?;
        let samples: Vec<f32> = match frame.bit_depth {
            png::BitDepth::Sixteen => {
                bytes.chunks_exact(2).map(|pair| f32::from(u16::from_be_bytes([pair[0], pair[1]])) / 65535.0).collect()
            }
            _ => bytes.iter().map(|&byte| f32::from(byte) / 255.0).collect(),
        };
        let texel: fn(&[f32]) -> [f32; 4] = match frame.color_type.samples() {
            1 => |s| [s[0], s[0], s[0], 1.0],
            2 => |s| [s[0], s[0], s[0], s[1]],
            3 => |s| [s[0], s[1], s[2], 1.0],
            _ => |s| [s[0], s[1], s[2], s[3]],
        };
        let channels = if grey { 1 } else { 4 };
        let texels = samples.chunks_exact(frame.color_type.samples()).map(texel);
        let values = texels.flat_map(|texel| texel.into_iter().take(channels)).collect();
        Ok(Self { size: [frame.width, frame.height], channels, values })
    }

    /// The values of a grey image, row by row.
    pub(crate) fn values(&self) -> &[f32] {
        &self.values
    }

    /// The same with another function of every value but the opacity.
    fn map(mut self, function: fn(f32) -> f32) -> Self {
        for texel in self.values.chunks_exact_mut(self.channels) {
            texel.iter_mut().take(3).for_each(|value| *value = function(*value));
        }
        self
    }

    /// Half the size: the mean of four texels.
    fn halved(&self) -> Self {
        let [width, height] = self.size.map(|side| (side / 2).max(1));
        let at = |x: u32, y: u32, channel: usize| {
            let (x, y) = (x.min(self.size[0] - 1), y.min(self.size[1] - 1));
            self.values[(y * self.size[0] + x) as usize * self.channels + channel]
        };
        let mean = |x: u32, y: u32, channel| {
            let [x, y] = [x * 2, y * 2];
            0.25 * (at(x, y, channel) + at(x + 1, y, channel) + at(x, y + 1, channel) + at(x + 1, y + 1, channel))
        };
        let texels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let channels = self.channels;
        let values = texels.flat_map(|(x, y)| (0..channels).map(move |channel| mean(x, y, channel))).collect();
        Self { size: [width, height], channels, values }
    }
}

/// The texture format that WebGPU knows by this name, of those that Terrane uses.
pub(crate) fn format(name: &str) -> Result<wgpu::TextureFormat, String> {
    match name {
        "rgba8unorm-srgb" => Ok(wgpu::TextureFormat::Rgba8UnormSrgb),
        "rgba8unorm" => Ok(wgpu::TextureFormat::Rgba8Unorm),
        "r16float" => Ok(wgpu::TextureFormat::R16Float),
        unknown => Err(format!("the manifest asks for format `{unknown}`, which this engine does not know")),
    }
}

/// The bytes of every mip, largest first. Colours are averaged as light, not as stored.
pub(crate) fn mips(path: &Path, size: [u32; 2], format: wgpu::TextureFormat) -> Result<Vec<Vec<u8>>, String> {
    let image = Image::read(path, format == wgpu::TextureFormat::R16Float)?;
    if image.size != size {
        return Err(format!("{} is {:?} texels, the manifest says {size:?}", path.display(), image.size));
    }
    let srgb = format == wgpu::TextureFormat::Rgba8UnormSrgb;
    let mut level = if srgb { image.map(linear_from_srgb) } else { image };
    let mut levels = Vec::new();
    loop {
        levels.push(level.values.chunks_exact(level.channels).flat_map(|texel| encode(texel, srgb)).collect());
        if level.size == [1, 1] {
            return Ok(levels);
        }
        level = level.halved();
    }
}

/// One texel as the device stores it.
fn encode(texel: &[f32], srgb: bool) -> Vec<u8> {
    if let [height] = texel {
        return half::f16::from_f32(*height).to_le_bytes().into();
    }
    let stored = texel.iter().enumerate().map(|(channel, &value)| match channel {
        0..3 if srgb => srgb_from_linear(value),
        _ => value,
    });
    stored.map(|value| (value * 255.0 + 0.5) as u8).collect()
}

/// IEC 61966-2-1.
fn linear_from_srgb(stored: f32) -> f32 {
    if stored <= 0.04045 { stored / 12.92 } else { ((stored + 0.055) / 1.055).powf(2.4) }
}

/// IEC 61966-2-1.
fn srgb_from_linear(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { linear * 12.92 } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}
