//! Smaller copies of a texture, so that what is far away neither flickers nor costs memory traffic.

use super::Format;
use super::decode::Texels;

/// The bytes of every level as the device takes them, the given one first, down to 1 × 1.
///
/// Each level is the area-weighted mean of the one above, in linear light for colours. Level 0 is the file's own values.
#[must_use]
pub fn mip_chain(texels: &Texels, format: Format) -> Vec<Vec<u8>> {
    let mut levels = vec![encode(&texels.values, format, false)];
    let mut size = texels.size;
    let mut linear = match format {
        Format::Rgba8UnormSrgb => texels.values.chunks_exact(4).flat_map(to_linear).collect(),
        _ => texels.values.clone(),
    };
    while size != (1, 1) {
        let smaller = ((size.0 / 2).max(1), (size.1 / 2).max(1));
        linear = shrink(&linear, texels.channels, size, smaller);
        size = smaller;
        levels.push(encode(&linear, format, true));
    }
    levels
}

fn to_linear(texel: &[f32]) -> [f32; 4] {
    [srgb_to_linear(texel[0]), srgb_to_linear(texel[1]), srgb_to_linear(texel[2]), texel[3]]
}

/// IEC 61966-2-1.
fn srgb_to_linear(value: f32) -> f32 {
    if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

/// IEC 61966-2-1.
fn linear_to_srgb(value: f32) -> f32 {
    if value <= 0.003_130_8 { value * 12.92 } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 }
}

/// `linear`: whether colours are linear and have to be encoded.
fn encode(values: &[f32], format: Format, linear: bool) -> Vec<u8> {
    let byte = |value: f32| (value * 255.0 + 0.5) as u8;
    match format {
        Format::R16Float | Format::Rgba16Float => {
            values.iter().flat_map(|&value| half::f16::from_f32(value).to_le_bytes()).collect()
        }
        Format::Rgba8UnormSrgb if linear => values
            .chunks_exact(4)
            .flat_map(|t| [linear_to_srgb(t[0]), linear_to_srgb(t[1]), linear_to_srgb(t[2]), t[3]].map(byte))
            .collect(),
        Format::Rgba8UnormSrgb | Format::Rgba8Unorm | Format::R8Unorm => {
            values.iter().map(|&value| byte(value)).collect()
        }
    }
}

/// Columns first, then rows: the mean over an area is separable.
fn shrink(values: &[f32], channels: usize, from: (u32, u32), to: (u32, u32)) -> Vec<f32> {
    let (columns, rows) = (spans(from.0, to.0), spans(from.1, to.1));
    let row_length = from.0 as usize * channels;
    let mut narrow = Vec::with_capacity(to.0 as usize * from.1 as usize * channels);
    for row in values.chunks_exact(row_length) {
        for span in &columns {
            for channel in 0..channels {
                narrow.push(span.iter().map(|&(i, weight)| row[i * channels + channel] * weight).sum::<f32>());
            }
        }
    }
    let row_length = to.0 as usize * channels;
    let mut small = Vec::with_capacity(to.1 as usize * row_length);
    for span in &rows {
        for place in 0..row_length {
            small.push(span.iter().map(|&(i, weight)| narrow[i * row_length + place] * weight).sum::<f32>());
        }
    }
    small
}

/// For each place of the smaller line: the places of the larger one under it, with their shares.
fn spans(from: u32, to: u32) -> Vec<Vec<(usize, f32)>> {
    let ratio = f64::from(from) / f64::from(to);
    (0..to)
        .map(|place| {
            let (low, high) = (f64::from(place) * ratio, f64::from(place + 1) * ratio);
            (low as usize..(high.ceil() as usize).min(from as usize))
                .map(|i| (i, high.min(i as f64 + 1.0) - low.max(i as f64)))
                .map(|(i, share)| (i, (share / ratio) as f32))
                .collect()
        })
        .collect()
}
