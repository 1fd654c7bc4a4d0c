//! `terrane render`: a picture of a scene, or of one surface.

mod scene;

use std::path::PathBuf;

use terrane::render::{Gpu, Image, Preview, Progress, Selection, render_preview};
use terrane::scene::{files, height_field, material};
use terrane::{content, file};
use terrane_codegen::graph::model::{ReliefMethod, ReliefTrace, Terrain};
use terrane_codegen::graph::{FileRole, Project};
use terrane_shaderlib::relief::Method;

use self::scene::{Drawing, compile};
use super::{Failure, project};

/// Draw a scene, or one surface on a plane and a sphere; no window is opened
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  terrane render graphs/scenes/alpine.ron -o alpine.png
  terrane render graphs/scenes/alpine.ron -o small.png --size 320x180 --samples 1
  terrane render graphs/surfaces/granite.ron -o granite.png --extent 12
  terrane render graphs/surfaces/slabs.ron -o slabs.png --relief \"linear_secant(16)\"
  terrane render graphs/scenes/yard.ron -o yard.png --search --relief \"linear_secant(32)\"
  terrane render --adapters

With --search the picture is followed by two of one sample a pixel: nodes and samples read, from black (none) over red to white
(the most, which stdout says), and texels between what was found and what the exact method finds, by their logarithm, from black
(0.001 and less) over blue to white (100); what was given up is green.")]
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
    /// Trace relief by this method, named as `terrane measure` names it, instead of the terrain's own or a surface's exact one
    #[arg(long, value_name = "METHOD", value_parser = super::measure::method)]
    relief: Option<Method>,
    /// Show beside the picture of a scene what the search for relief read, and how far it is from the exact one
    #[arg(long)]
    search: bool,
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
            Some(FileRole::Surface) if self.search => {
                return Err(Failure::Usage("--search is for scenes".into()));
            }
            Some(FileRole::Surface) => self.surface(&mut project, &path)?,
            _ => self.scene(&mut project, &path)?,
        };
        picture.write_png(&self.output)?;
        println!("{}", self.output.display());
        Ok(())
    }

    fn scene(&self, project: &mut Project, path: &str) -> Result<Image, Failure> {
        let (graphs, mut scene, warnings) =
            project.scene(path).map_err(|found| project::findings(&found, &project.sources))?;
        project::warn(&warnings, &project.sources);
        self.override_relief(&mut scene.terrain)?;
        let gpu = self.device()?;
        let host = if scene.objects.is_empty() { &project::TERRAIN_HOST } else { &project::FURNISHED_HOST };
        let compiled = compile(project, &graphs, &scene, host, gpu.platform())?;
        content::make(project, &files(&compiled))?;
        let field = height_field(&scene.terrain, project.root())?;
        let image = self.size.unwrap_or([scene.image.0, scene.image.1]);
        let (graphs, scene, samples) = (&graphs, &scene, self.samples);
        let drawing = Drawing { gpu: &gpu, project, graphs, scene, field: &field, image, samples };
        let picture = drawing.picture(&compiled)?;
        if self.search { drawing.beside(&picture) } else { Ok(picture) }
    }

    /// The method of `--relief` in place of the terrain's own.
    fn override_relief(&self, terrain: &mut Terrain) -> Result<(), Failure> {
        let wanted = self.relief.map(|method| ("--relief", Some(method))).or(self.search.then_some(("--search", None)));
        let Some((option, method)) = wanted else { return Ok(()) };
        let Some(relief) = &mut terrain.relief else {
            return Err(Failure::Usage(format!("{option}: {} traces no relief", terrain.path)));
        };
        relief.method = method.map_or(relief.method, ReliefMethod::Fixed);
        Ok(())
    }

    fn surface(&self, project: &mut Project, path: &str) -> Result<Image, Failure> {
        let (graphs, surface, warnings) =
            project.surface(path).map_err(|found| project::findings(&found, &project.sources))?;
        project::warn(&warnings, &project.sources);
        let method = self.relief.map_or(ReliefTrace::ALONE.method, ReliefMethod::Fixed);
        let gpu = self.device()?;
        let compiled = project::compiler(project, &project::PREVIEW_HOST, gpu.platform())
            .surface(&graphs, surface, ReliefTrace { method, ..ReliefTrace::ALONE })
            .map_err(|found| project::findings(&found, &project.sources))?;
        if self.relief.is_some() && compiled.program.relief.is_none() {
            return Err(Failure::Usage(format!("--relief: {path} has no relief")));
        }
        content::make(project, &files(&compiled))?;
        let bound = material(&compiled, project.root());
        let preview = Preview {
            shader: &compiled.host.text,
            material: &bound,
            size: self.extent,
            image: self.size.unwrap_or([1280, 720]),
            supersampling: self.samples,
        };
        Ok(render_preview(&gpu, &preview, Progress::Stderr)?)
    }

    /// The device, once the picture can be written: whoever lacks a driver or a permission need not wait for textures to hear of
    /// it.
    fn device(&self) -> Result<Gpu, Failure> {
        file::check(&self.output)?;
        open(self.adapter.as_deref())
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
    let gpu = Gpu::new(&adapter.map_or(Selection::Best, Selection::parse))?;
    eprintln!("device: {}", gpu.name());
    Ok(gpu)
}
