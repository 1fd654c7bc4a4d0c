//! An engine of its own that draws a terrain with nothing but what `terrane build` wrote: the core's WGSL, the manifest,
//! and the textures that the manifest names. It uses no part of Terrane; copy it.
//!
//! ```sh
//! terrane build graphs/terrains/alpine.ron -o out
//! cargo run --release --example embed -- out/alpine.json out/embed.png
//! ```
//!
//! Textures lie beside the manifest, under the names that it gives.

mod device;
mod draw;
mod manifest;
mod material;
mod shader;
mod texture;
mod view;

use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

use manifest::Manifest;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [manifest, picture] = arguments.as_slice() else {
        eprintln!("usage: embed MANIFEST.json PICTURE.png");
        return ExitCode::from(2);
    };
    match run(Path::new(manifest), Path::new(picture)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// Draws the terrain of a manifest.
pub(crate) fn run(path: &Path, picture: &Path) -> Result<(), String> {
    let (manifest, shader) = load(path)?;
    let folder = path.parent().ok_or("the manifest is a folder")?;
    let pixels = draw::draw(&manifest, &shader, folder)?;
    write_png(picture, &pixels).map_err(|error| format!("{}: {error}", picture.display()))?;
    println!("{}", picture.display());
    Ok(())
}

/// A manifest, and the core beside it made into a whole shader.
pub(crate) fn load(path: &Path) -> Result<(Manifest, String), String> {
    let manifest = Manifest::read(path)?;
    let permutation = manifest.permutations.first().ok_or("this manifest names no shader")?;
    let core = path.with_file_name(&permutation.core.path);
    let core = fs::read_to_string(&core).map_err(|error| format!("{}: {error}", core.display()))?;
    let shader = shader::compose(&core, &manifest)?;
    Ok((manifest, shader))
}

fn write_png(path: &Path, pixels: &[u8]) -> io::Result<()> {
    let mut encoder =
        png::Encoder::new(io::BufWriter::new(fs::File::create(path)?), view::PICTURE[0], view::PICTURE[1]);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(())
}
