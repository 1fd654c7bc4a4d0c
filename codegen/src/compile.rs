//! The whole way from resolved graphs to checked WGSL and its manifest.

use terrane_shaderlib::hosts::Host;

use crate::check::{Checked, check};
use crate::diagnostic::{Diagnostic, Sources};
use crate::emit::{Shader, core, host};
use crate::graph::model::{GraphId, Graphs, ReliefTrace, Terrain};
use crate::library::Library;
use crate::manifest::{Manifest, Parts, manifest};
use crate::patch::{Combination, Specialization, specialize};
use crate::program::{Options, Program, affine};
use crate::stage::limits;

pub use crate::stage::TOO_MANY_TEXTURES;

/// A compiled terrain or surface.
#[derive(Debug)]
pub struct Compiled {
    /// All materials.
    pub program: Program,
    /// What was emitted of them.
    pub patch: Specialization,
    /// The core: for engines that bring their own entry points.
    pub core: Shader,
    /// The core with plain WebGPU entry points.
    pub host: Shader,
    /// The host shader as naga sees it.
    pub checked: Checked,
    /// What an engine must know.
    pub manifest: Manifest,
}

/// What everything is compiled with.
#[derive(Clone, Copy)]
pub struct Compiler<'a> {
    /// The nodes.
    pub library: &'a Library,
    /// The texts that spans point into.
    pub sources: &'a Sources,
    /// The host's own WGSL. The textures that it declares count against a stage's limit.
    pub host: &'a Host,
    /// What is optimised.
    pub options: Options,
}

impl Compiler<'_> {
    /// Compiles every layer of a terrain into one shader.
    ///
    /// # Errors
    /// When the device limits are exceeded, or when naga refuses the result.
    pub fn terrain(&self, graphs: &Graphs, terrain: &Terrain) -> Result<Compiled, Vec<Diagnostic>> {
        self.finish(Program::of_terrain(self.library, graphs, terrain, self.options), Some(terrain))
    }

    /// Compiles one surface alone.
    ///
    /// # Errors
    /// As [`Self::terrain`].
    pub fn surface(&self, graphs: &Graphs, surface: GraphId, trace: ReliefTrace) -> Result<Compiled, Vec<Diagnostic>> {
        self.finish(Program::of_surface(self.library, graphs, surface, trace, self.options), None)
    }

    fn finish(&self, mut program: Program, terrain: Option<&Terrain>) -> Result<Compiled, Vec<Diagnostic>> {
        if self.host.displaced.is_none() {
            program.flatten();
        }
        let patch = specialize(&program, &Combination::all(&program), self.options);
        program.keep(&patch.live);
        program.keep_reliefs(&patch.layers);
        let text = self.host.displaced.as_ref().filter(|_| patch.relief.is_some()).unwrap_or(&self.host.flat);
        limits(&program, text)?;
        affine(&program, self.library).map_err(|found| vec![*found])?;
        let core = core(self.library, &program, &patch);
        let host = host(self.library, &program, &patch, text);
        check(&core, self.library, &program).map_err(|refused| vec![refused])?;
        let checked = check(&host, self.library, &program).map_err(|refused| vec![refused])?;
        let parts = Parts { program: &program, patch: &patch, core: &core, host: &host, checked: &checked, terrain };
        let manifest = manifest(&parts, self.sources);
        Ok(Compiled { program, patch, core, host, checked, manifest })
    }
}
