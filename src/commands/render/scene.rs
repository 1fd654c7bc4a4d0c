//! One terrain scene: its picture, and beside it what the search for relief did.

use std::path::Path;

use terrane::render::{
    Gpu, HeightField, Image, Progress, RenderError, Searched, render_scene, search_scene, searched_beside,
};
use terrane::scene::{self, Quality};
use terrane_codegen::compile::Compiled;
use terrane_codegen::graph::Project;
use terrane_codegen::graph::model::{Graphs, ReliefMethod, Scene};
use terrane_shaderlib::hosts::Host;
use terrane_shaderlib::relief::{Method, Platform};

use crate::commands::{Failure, project};

/// A scene on its way to a picture.
pub(super) struct Drawing<'a> {
    pub(super) gpu: &'a Gpu,
    pub(super) project: &'a Project,
    pub(super) graphs: &'a Graphs,
    pub(super) scene: &'a Scene,
    pub(super) field: &'a HeightField,
    /// Pixels.
    pub(super) image: [u32; 2],
    /// Samples of a pixel on a side.
    pub(super) samples: u32,
}

/// The scene's terrain as one shader.
pub(super) fn compile(
    project: &Project,
    graphs: &Graphs,
    scene: &Scene,
    host: &Host,
    platform: Platform,
) -> Result<Compiled, Failure> {
    let compiled = project::compiler(project, host, platform).terrain(graphs, &scene.terrain);
    compiled.map_err(|found| project::findings(&found, &project.sources))
}

impl Drawing<'_> {
    /// The picture.
    pub(super) fn picture(&self, compiled: &Compiled) -> Result<Image, RenderError> {
        let material = scene::material(compiled, self.root());
        let quality = Quality { image: self.image, supersampling: self.samples, tolerance: 1.0 };
        let objects = scene::objects(self.scene, self.field);
        let scene = scene::render_scene(self.scene, compiled, &material, self.field, &objects, quality);
        render_scene(self.gpu, &scene, Progress::Stderr)
    }

    /// The picture, nodes a pixel, and the distance to what the exact method finds, side by side; their figures go to stdout.
    pub(super) fn beside(&self, picture: &Image) -> Result<Image, Failure> {
        let searched = self.search(self.scene)?;
        let mut exact = self.scene.clone();
        if let Some(relief) = &mut exact.terrain.relief {
            relief.method = ReliefMethod::Fixed(Method::fastest(self.gpu.platform()));
        }
        let truth = self.search(&exact)?;
        println!("{}", searched.figures(&truth));
        Ok(searched_beside(picture, &searched, &truth))
    }

    fn search(&self, of: &Scene) -> Result<Searched, Failure> {
        let compiled = compile(self.project, self.graphs, of, &project::SEARCHED_HOST, self.gpu.platform())?;
        let material = scene::material(&compiled, self.root());
        let quality = Quality { image: self.image, supersampling: 1, tolerance: 1.0 };
        let scene = scene::render_scene(of, &compiled, &material, self.field, &[], quality);
        Ok(search_scene(self.gpu, &scene, Progress::Stderr)?)
    }

    fn root(&self) -> &Path {
        self.project.root()
    }
}
