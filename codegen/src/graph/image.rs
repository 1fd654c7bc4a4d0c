//! What can be known of an image from its first bytes.

use std::io::Cursor;

use crate::graph::limits;

/// Bytes of a PNG up to the end of its first chunk, `IHDR`.
pub(crate) const HEADER_BYTES: usize = 33;

/// Size and sample format of an image, read or promised by a recipe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ImageHeader {
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// 1 grey, 3 RGB, 4 RGBA.
    pub channels: u8,
    /// Bits per channel, 8 or 16.
    pub depth: u8,
}

/// Why an image is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum ImageError {
    /// Not a PNG, or a damaged one.
    NotPng,
    /// A sample format that we do not read, in words.
    Format(String),
    /// Too many pixels.
    Large(u32, u32),
}

/// Reads the header of a PNG.
///
/// # Errors
/// What is not a PNG of 8 or 16 bit grey, RGB or RGBA, up to 16384 pixels on a side and 256 Mpx.
pub(crate) fn header(bytes: &[u8]) -> Result<ImageHeader, ImageError> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    let info = decoder.read_header_info().map_err(|_| ImageError::NotPng)?;
    let size = (info.width, info.height);
    let pixels = u64::from(size.0) * u64::from(size.1);
    if size.0 > limits::IMAGE_SIDE || size.1 > limits::IMAGE_SIDE || pixels > limits::IMAGE_PIXELS {
        return Err(ImageError::Large(size.0, size.1));
    }
    let channels = match info.color_type {
        png::ColorType::Grayscale => 1,
        png::ColorType::Rgb => 3,
        png::ColorType::Rgba => 4,
        png::ColorType::GrayscaleAlpha => return Err(ImageError::Format("grey with alpha".into())),
        png::ColorType::Indexed => return Err(ImageError::Format("a palette".into())),
    };
    let depth = info.bit_depth as u8;
    if depth < 8 {
        return Err(ImageError::Format(format!("{depth} bit per channel")));
    }
    Ok(ImageHeader { size, channels, depth })
}

#[cfg(test)]
mod tests {
    use super::{HEADER_BYTES, ImageError, ImageHeader, header};

    fn encoded(size: (u32, u32), color: png::ColorType, depth: png::BitDepth) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, size.0, size.1);
        encoder.set_color(color);
        encoder.set_depth(depth);
        if color == png::ColorType::Indexed {
            encoder.set_palette(vec![0, 0, 0]);
        }
        let row = (size.0 as usize * color.samples() * depth as usize).div_ceil(8);
        encoder.write_header().unwrap().write_image_data(&vec![0; row * size.1 as usize]).unwrap();
        bytes
    }

    /// The checksum of PNG chunks (ISO 15948, annex D).
    fn crc32(bytes: &[u8]) -> u32 {
        let shift = |sum: u32| if sum & 1 == 1 { 0xedb8_8320 ^ (sum >> 1) } else { sum >> 1 };
        !bytes.iter().fold(!0, |sum, byte| (0..8).fold(sum ^ u32::from(*byte), |sum, _| shift(sum)))
    }

    #[test]
    fn reads_what_an_encoder_writes() {
        let bytes = encoded((5, 3), png::ColorType::Grayscale, png::BitDepth::Sixteen);
        assert_eq!(header(&bytes[..HEADER_BYTES]), Ok(ImageHeader { size: (5, 3), channels: 1, depth: 16 }));
        let bytes = encoded((5, 3), png::ColorType::Rgba, png::BitDepth::Eight);
        assert_eq!(header(&bytes[..HEADER_BYTES]), Ok(ImageHeader { size: (5, 3), channels: 4, depth: 8 }));
    }

    #[test]
    fn refuses_other_formats() {
        let bytes = encoded((5, 3), png::ColorType::Grayscale, png::BitDepth::One);
        assert_eq!(header(&bytes), Err(ImageError::Format("1 bit per channel".into())));
        let bytes = encoded((5, 3), png::ColorType::Indexed, png::BitDepth::Eight);
        assert_eq!(header(&bytes), Err(ImageError::Format("a palette".into())));
        assert_eq!(header(b"GIF89a and more"), Err(ImageError::NotPng));
        assert_eq!(header(&[]), Err(ImageError::NotPng));
        let mut empty = encoded((5, 3), png::ColorType::Grayscale, png::BitDepth::Eight);
        // A width of 0, with the checksum that fits it.
        empty[16..20].fill(0);
        let sum = crc32(&empty[12..29]).to_be_bytes();
        empty[29..33].copy_from_slice(&sum);
        assert_eq!(header(&empty), Err(ImageError::NotPng));
    }

    #[test]
    fn refuses_what_is_too_large() {
        let bytes = encoded((16_385, 1), png::ColorType::Grayscale, png::BitDepth::Eight);
        assert_eq!(header(&bytes), Err(ImageError::Large(16_385, 1)));
    }
}
