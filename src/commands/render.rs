//! `terrane render`: a picture of a scene, or of one surface.

use std::path::PathBuf;

use terrane::render::{Gpu, Image, Preview, Progress, RenderError, Selection, render_preview, render_scene};
use terrane::scene::{self, Quality};
use terrane::{content, file};
use terrane_codegen::compile::Compiled;
use terrane_codegen::graph::{FileRole, Project};

use super::{Failure, project};

/// Draw a scene, or one surface on a plane and a sphere; no window is opened
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  terrane render graphs/scenes/alpine.ron -o alpine.png
  terrane render graphs/scenes/alpine.ron -o small.png --size 320x180 --samples 1
  terrane render graphs/surfaces/granite.ron -o granite.png --extent 12
  terrane render --adapters")]
pub(crate) struct Render {
    /// A scene or a surface
    #[arg(value_name = "GRAPH", required_unless_present = "adapters")]
    graph: Option<PathBuf>,
    /// The PNG to write; folders that are missing are made
    #[arg(short, long, value_name = "PNG", default_value = "terrane.png")]
    output: PathBuf,
    /// Pixels, instead of the scene's own or 1280x720
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Samples of a pixel on a side
    #[arg(long, default_value_t = 2, value_parser = clap::value_parser!(u32).range(1..=4))]
    samples: u32,
    /// Metres on a side of the plane that shows a surface
    #[arg(long, value_name = "METRES", default_value_t = 8.0)]
    extent: f64,
    /// The device to draw on: its number, or a part of its name
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
    /// List the devices and stop
    #[arg(long)]
    adapters: bool,
}

pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let (width, height) = text.split_once('x').ok_or("write width x height, as in 1280x720")?;
    let side = |text: &str| text.parse().ok().filter(|side| (1..=8192).contains(side));
    match (side(width), side(height)) {
        (Some(width), Some(height)) => Ok([width, height]),
        _ => Err("each side is 1 to 8192 pixels".into()),
    }
}

impl Render {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let Some(file) = self.graph.as_ref().filter(|_| !self.adapters) else { return list() };
        let mut project = project::open(file)?;
        let path = project::relative(&mut project, file)?;
        let picture = match project.role(&path) {
            Some(FileRole::Surface) => self.surface(&mut project, &path)?,
            _ => self.scene(&mut project, &path)?,
        };
        picture.write_png(&self.output)?;
        println!("{}", self.output.display());
        Ok(())
    }

    fn scene(&self, project: &mut Project, path: &str) -> Result<Image, Failure> {
        let (graphs, scene, warnings) =
            project.scene(path).map_err(|found| project::findings(&found, &project.sources))?;
        project::warn(&warnings, &project.sources);
        let compiled = project::compiler(project, &project::TERRAIN_HOST)
            .terrain(&graphs, &scene.terrain)
            .map_err(|found| project::findings(&found, &project.sources))?;
        let gpu = self.prepare(project, &compiled)?;
        let material = scene::material(&compiled, project.root());
        let field = scene::height_field(&scene.terrain, project.root())?;
        let image = self.size.unwrap_or([scene.image.0, scene.image.1]);
        let quality = Quality { image, supersampling: self.samples, tolerance: 1.0 };
        let scene = scene::render_scene(&scene, &compiled, &material, &field, quality);
        Ok(render_scene(&gpu, &scene, Progress::Stderr)?)
    }

    fn surface(&self, project: &mut Project, path: &str) -> Result<Image, Failure> {
        let (graphs, surface, warnings) =
            project.surface(path).map_err(|found| project::findings(&found, &project.sources))?;
        project::warn(&warnings, &project.sources);
        let compiled = project::compiler(project, &project::PREVIEW_HOST)
            .surface(&graphs, surface)
            .map_err(|found| project::findings(&found, &project.sources))?;
        let gpu = self.prepare(project, &compiled)?;
        let material = scene::material(&compiled, project.root());
        let preview = Preview {
            shader: &compiled.host.text,
            material: &material,
            size: self.extent,
            image: self.size.unwrap_or([1280, 720]),
            supersampling: self.samples,
        };
        Ok(render_preview(&gpu, &preview, Progress::Stderr)?)
    }

    /// Output and device before the textures: whoever lacks a driver or a permission need not wait to hear of it.
    fn prepare(&self, project: &Project, compiled: &Compiled) -> Result<Gpu, Failure> {
        file::check(&self.output)?;
        let gpu = open(self.adapter.as_deref())?;
        content::make(project, &scene::files(compiled))?;
        Ok(gpu)
    }
}

fn list() -> Result<(), Failure> {
    for (index, name) in Gpu::list().iter().enumerate() {
        println!("{index}  {name}");
    }
    Ok(())
}

/// The device that `--adapter` means, whose name goes to stderr.
pub(super) fn open(adapter: Option<&str>) -> Result<Gpu, Failure> {
    open_as(adapter, Gpu::new)
}

/// The same, opened in another way.
pub(super) fn open_as(
    adapter: Option<&str>,
    way: impl Fn(&Selection) -> Result<Gpu, RenderError>,
) -> Result<Gpu, Failure> {
    let gpu = way(&adapter.map_or(Selection::Best, Selection::parse))?;
    eprintln!("device: {}", gpu.name());
    Ok(gpu)
}
