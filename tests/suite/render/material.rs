//! Textures: decoding, mips.

use std::path::Path;

use terrane::render::material::{Format, Texels, decode, mip_chain};

fn write_png(path: &Path, size: (u32, u32), color: png::ColorType, depth: png::BitDepth, bytes: &[u8]) {
    let mut encoder = png::Encoder::new(std::fs::File::create(path).expect("a writable folder"), size.0, size.1);
    encoder.set_color(color);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().expect("a valid header");
    writer.write_image_data(bytes).expect("enough bytes");
}

#[test]
fn colours_are_averaged_as_light() {
    // Black and white in a checker: half of the light, which sRGB stores as 188.
    let values = [0.0, 1.0, 1.0, 0.0].iter().flat_map(|&v| [v, v, v, v]).collect();
    let texels = Texels { size: (2, 2), channels: 4, values };
    assert_eq!(mip_chain(&texels, Format::Rgba8UnormSrgb)[1], [188, 188, 188, 128]);
    assert_eq!(mip_chain(&texels, Format::Rgba8Unorm)[1], [128, 128, 128, 128]);
}

#[test]
fn every_size_keeps_its_mean() {
    for size in [(1, 1), (3, 5), (7, 2), (8, 8), (13, 1)] {
        let values: Vec<f32> = (0..size.0 * size.1).map(|i| (i * 37 % 11) as f32 / 11.0).collect();
        let mean = values.iter().sum::<f32>() / values.len() as f32;
        let chain = mip_chain(&Texels { size, channels: 1, values }, Format::R16Float);
        assert_eq!(chain.len() as u32, 32 - u32::leading_zeros(size.0.max(size.1)));
        let last = &chain[chain.len() - 1];
        let last = half::f16::from_le_bytes([last[0], last[1]]).to_f32();
        assert!((last - mean).abs() < 2e-3, "{size:?}: {last}, not {mean}");
    }
}

#[test]
fn files_are_read_as_they_are() {
    let folder = tempfile::tempdir().expect("a writable temporary folder");
    let path = folder.path().join("grey.png");
    write_png(&path, (2, 1), png::ColorType::Grayscale, png::BitDepth::Sixteen, &[0x80, 0x00, 0xff, 0xff]);
    let read = decode(&path, (2, 1), Format::R16Float).expect("a good file");
    assert_eq!(read.values, [32768.0 / 65535.0, 1.0]);
    write_png(&path, (1, 1), png::ColorType::Rgb, png::BitDepth::Eight, &[255, 0, 51]);
    let read = decode(&path, (1, 1), Format::Rgba8UnormSrgb).expect("a good file");
    assert_eq!(read.values, [1.0, 0.0, 0.2, 1.0]);
}

#[test]
fn broken_files_are_errors() {
    let folder = tempfile::tempdir().expect("a writable temporary folder");
    let path = folder.path().join("broken.png");
    let missing = decode(&path, (1, 1), Format::Rgba8UnormSrgb).expect_err("no file");
    assert!(missing.to_string().contains("broken.png"), "{missing}");
    write_png(&path, (2, 2), png::ColorType::Rgb, png::BitDepth::Eight, &[0; 12]);
    let other = decode(&path, (4, 4), Format::Rgba8UnormSrgb).expect_err("another size");
    assert!(other.to_string().ends_with("is 2 x 2, expected 4 x 4"), "{other}");
    let bytes = std::fs::read(&path).expect("just written");
    std::fs::write(&path, &bytes[..bytes.len() - 20]).expect("a writable file");
    assert!(decode(&path, (2, 2), Format::Rgba8UnormSrgb).is_err());
}
