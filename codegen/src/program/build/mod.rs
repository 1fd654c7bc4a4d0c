//! From graphs to values.

mod graph;
mod layer;
mod resource;
mod value;

use std::collections::BTreeMap;

use terrane_shaderlib::relief::Platform;

use super::fold::Folder;
use super::{Options, Pool, Program, ValueId};
use crate::diagnostic::Span;
use crate::graph::model::{Blend, GraphId, Graphs, ReliefTrace, Terrain};
use crate::library::Library;

pub(crate) use resource::unique;

impl Program {
    /// Every layer of a terrain.
    pub fn of_terrain(library: &Library, graphs: &Graphs, terrain: &Terrain, options: Options) -> Self {
        let mut builder = Builder::new(library, graphs, options);
        builder.trace = terrain.relief;
        for layer in &terrain.layers {
            let name = builder.layer_name(layer.surface);
            let mask = builder.layer_mask(&layer.mask);
            builder.layer(layer.surface, name, &layer.parameters, mask, layer.span);
        }
        builder.finish(&terrain.name, terrain.blend)
    }

    /// One surface alone, its relief traced as it is said.
    pub fn of_surface(
        library: &Library,
        graphs: &Graphs,
        surface: GraphId,
        trace: ReliefTrace,
        options: Options,
    ) -> Self {
        let mut builder = Builder::new(library, graphs, options);
        builder.trace = Some(trace);
        let graph = &graphs.graphs[surface.0];
        let span = Span { source: graph.source, start: 0, end: 0 };
        builder.layer(surface, graph.name.clone(), &BTreeMap::new(), None, span);
        builder.finish(&graph.name, Blend::Over)
    }
}

struct Builder<'a> {
    library: &'a Library,
    graphs: &'a Graphs,
    /// Absent where nothing is to be folded.
    folder: Option<Folder<'a>>,
    program: Program,
    masks: BTreeMap<GraphId, ValueId>,
    /// How reliefs are traced, if they are.
    trace: Option<ReliefTrace>,
    platform: Platform,
}

impl<'a> Builder<'a> {
    fn new(library: &'a Library, graphs: &'a Graphs, options: Options) -> Self {
        let program = Program {
            name: String::new(),
            pool: Pool::new(options.intern),
            parameters: Vec::new(),
            textures: Vec::new(),
            arrays: Vec::new(),
            samplers: Vec::new(),
            layers: Vec::new(),
            blend: Blend::Over,
            relief: None,
        };
        let folder = options.fold.then(|| Folder::new(library));
        Self { library, graphs, folder, program, masks: BTreeMap::new(), trace: None, platform: options.platform }
    }

    fn finish(mut self, name: &str, blend: Blend) -> Program {
        self.program.name = name.to_owned();
        self.program.blend = blend;
        self.program
    }
}
