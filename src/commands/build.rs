//! `terrane build`: WGSL, manifest and textures for an engine.

use std::path::{Path, PathBuf};

use terrane_codegen::compile::Compiled;
use terrane_codegen::graph::model::ReliefTrace;
use terrane_codegen::graph::{FileRole, Project};

use super::{Failure, project};
use terrane::relief::{bytes, map};
use terrane::{content, file, scene};
use terrane_shaderlib::relief::Platform;

/// Write the WGSL of a terrain or surface, its manifest, and the textures it reads
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  terrane build graphs/terrains/alpine.ron -o out

Writes NAME.core.wgsl (functions and structs), NAME.wgsl (the same with plain WebGPU entry points),
NAME.json (the manifest), the PNG files that the manifest names, and the texels that are read of each relief.")]
pub(crate) struct Build {
    /// A terrain or a surface
    #[arg(value_name = "GRAPH")]
    graph: PathBuf,
    /// The folder to write to; it is made if it is not there
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Leave the textures where they are
    #[arg(long)]
    no_textures: bool,
    /// What the shader is to run on: which search for relief `auto` stands for
    #[arg(long, value_name = "PLATFORM", value_enum, default_value_t = On::Gpu)]
    platform: On,
}

/// A platform by its name.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum On {
    /// A graphics processor: `leap`, over cones
    Gpu,
    /// A processor that draws by itself, as llvmpipe does: `walk`, over a quadtree
    Cpu,
}

impl From<On> for Platform {
    fn from(on: On) -> Self {
        match on {
            On::Gpu => Self::Gpu,
            On::Cpu => Self::Cpu,
        }
    }
}

impl Build {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let mut project = project::open(&self.graph)?;
        let path = project::relative(&mut project, &self.graph)?;
        let compiled = compile(&mut project, &path, self.platform.into())?;
        if !self.no_textures {
            copy_textures(&project, &compiled, &self.output)?;
        }
        let manifest = &compiled.manifest;
        for permutation in &manifest.permutations {
            self.write(&permutation.core.path, &compiled.core.text)?;
            self.write(&permutation.host.path, &compiled.host.text)?;
        }
        // Last, so that a manifest never speaks of files that are not there.
        self.write(&format!("{}.json", manifest.name), &manifest.to_json())?;
        println!("{}", self.output.join(format!("{}.json", manifest.name)).display());
        Ok(())
    }

    fn write(&self, name: &str, text: &str) -> Result<(), Failure> {
        Ok(file::write(&self.output.join(name), text.as_bytes())?)
    }
}

fn compile(project: &mut Project, path: &str, platform: Platform) -> Result<Compiled, Failure> {
    let surface = matches!(project.role(path), Some(FileRole::Surface));
    let (compiled, warnings) = if surface {
        let (graphs, surface, warnings) =
            project.surface(path).map_err(|found| project::findings(&found, &project.sources))?;
        (
            project::compiler(project, &project::TERRAIN_HOST, platform).surface(&graphs, surface, ReliefTrace::ALONE),
            warnings,
        )
    } else {
        let (graphs, terrain, warnings) =
            project.terrain(path).map_err(|found| project::findings(&found, &project.sources))?;
        (project::compiler(project, &project::TERRAIN_HOST, platform).terrain(&graphs, &terrain), warnings)
    };
    project::warn(&warnings, &project.sources);
    compiled.map_err(|found| project::findings(&found, &project.sources))
}

/// Makes what is missing, then puts every file that the manifest names beside it.
fn copy_textures(project: &Project, compiled: &Compiled, output: &Path) -> Result<(), Failure> {
    let files = scene::files(compiled);
    content::make(project, &files)?;
    for name in files {
        let from = project.root().join(&name);
        let bytes = std::fs::read(&from).map_err(|error| Failure::unread(&from, &error))?;
        file::write(&output.join(&name), &bytes)?;
    }
    write_reliefs(project, compiled, output)
}

/// What is read of every height map that is traced, as the device takes it.
fn write_reliefs(project: &Project, compiled: &Compiled, output: &Path) -> Result<(), Failure> {
    let wanted = scene::map_textures(compiled);
    for array in compiled.manifest.relief.iter().flat_map(|relief| &relief.arrays) {
        for (layer, source) in array.sources.iter().enumerate() {
            let size = (array.size[0], array.size[1]);
            let planes = map(&project.root().join(&source.file), source.channel, size, &wanted)?;
            for (texture, plane) in array.textures.iter().zip(&planes) {
                file::write(&output.join(&texture.layers[layer]), &bytes(plane))?;
            }
        }
    }
    Ok(())
}
