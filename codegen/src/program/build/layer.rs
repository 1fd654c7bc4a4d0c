//! Layers: surfaces under their masks.

use std::collections::BTreeMap;

use super::Builder;
use super::graph::Context;
use super::resource::position;
use crate::diagnostic::Span;
use crate::graph::model::{FrameField, GraphId, LayerMask, Relief, SURFACE_OUTPUTS};
use crate::program::{LayerRelief, Origin, ProgramLayer, ProgramRelief, ReliefArray, ReliefMap, ValueId};
use crate::value::{Literal, Type};

impl<'a> Builder<'a> {
    /// A surface that lies twice gets a number, so that each layer has parameters of its own.
    pub(super) fn layer_name(&self, surface: GraphId) -> String {
        let graph = &self.graphs.graphs[surface.0];
        let same = self.program.layers.iter().filter(|layer| layer.path == graph.path).count();
        if same == 0 { graph.name.clone() } else { format!("{}_{}", graph.name, same + 1) }
    }

    pub(super) fn layer_mask(&mut self, mask: &LayerMask) -> Option<ValueId> {
        match mask {
            LayerMask::Full => None,
            LayerMask::Painted(texture) => {
                let of = self.texture(texture);
                let uv = self.frame(FrameField::TerrainUv);
                let file = texture.file.rsplit('/').next().unwrap_or_default();
                let name = file.split('.').next().unwrap_or_default();
                Some(self.sample(of, uv, texture.channel.unwrap_or(0), name.to_owned(), texture.span))
            }
            LayerMask::Graph(id) => Some(match self.masks.get(id) {
                Some(known) => *known,
                None => {
                    let graph = &self.graphs.graphs[id.0];
                    let context = self.graph(graph, graph.name.clone(), &BTreeMap::new());
                    let value = self.input(&context, &graph.outputs["mask"].input);
                    self.masks.insert(*id, value);
                    value
                }
            }),
        }
    }

    pub(super) fn layer(
        &mut self,
        surface: GraphId,
        name: String,
        overrides: &BTreeMap<String, Literal>,
        layer_mask: Option<ValueId>,
        span: Span,
    ) {
        let graph = &self.graphs.graphs[surface.0];
        let context = self.graph(graph, name.clone(), overrides);
        let mut outputs: BTreeMap<&'static str, ValueId> = BTreeMap::new();
        for (output, _, default) in SURFACE_OUTPUTS {
            let value = match (graph.outputs.get(*output), &graph.relief, default) {
                (Some(given), _, _) => self.input(&context, &given.input),
                (None, Some(relief), _) if *output == "height" => self.relief_height(&context, relief),
                (None, Some(relief), _) if *output == "normal" => self.relief_normal(&context, relief),
                (None, _, Some(default)) => self.literal(Literal::floats(default)),
                // Resolution refuses a surface without the outputs that have no default.
                (None, _, None) => continue,
            };
            outputs.insert(output, value);
        }
        let own = outputs.remove("mask").unwrap_or_else(|| self.literal(Literal::f32(1.0)));
        let mask = layer_mask.map_or(own, |mask| self.product(own, mask, &context.path, span));
        let (path, doc) = (graph.path.clone(), graph.doc.clone());
        let relief = graph.relief.as_ref().and_then(|relief| self.relief(&context, relief));
        self.program.layers.push(ProgramLayer { name, path, doc, mask, outputs, relief, span });
    }

    /// The displaced surface, if the terrain traces it.
    fn relief(&mut self, context: &Context<'a>, relief: &Relief) -> Option<LayerRelief> {
        let trace = self.trace?;
        let texture = &context.graph.textures[relief.texture];
        let uv = self.input(context, &relief.uv);
        let method = trace.method.search(self.platform);
        let arrays = &mut self.program.relief.get_or_insert(ProgramRelief { trace, method, arrays: Vec::new() }).arrays;
        let array = position(
            arrays,
            |array| array.size == texture.size,
            || ReliefArray { size: texture.size, maps: Vec::new() },
        );
        let map = ReliefMap { file: texture.file.clone(), channel: texture.channel.unwrap_or(0) };
        let layer = position(&mut arrays[array].maps, |known| *known == map, || map.clone());
        Some(LayerRelief { array, layer, uv, depth: relief.depth, span: relief.span })
    }

    /// The normal of the heights, for shading where the author gives none.
    fn relief_normal(&mut self, context: &Context<'a>, relief: &Relief) -> ValueId {
        let texture = &context.graph.textures[relief.texture];
        let channel = Literal::U32(u32::from(texture.channel.unwrap_or(0)));
        let inputs = vec![
            self.texture(texture),
            self.input(context, &relief.uv),
            self.frame(FrameField::Position),
            self.frame(FrameField::Normal),
            self.literal(Literal::f32(relief.depth)),
            self.literal(channel),
        ];
        let normal = self.call("normal_from_relief", inputs, Type::Vec3);
        self.program.pool.name(normal, Origin { path: format!("{}/relief_normal", context.path), span: relief.span });
        normal
    }

    fn relief_height(&mut self, context: &Context<'a>, relief: &Relief) -> ValueId {
        let texture = &context.graph.textures[relief.texture];
        let of = self.texture(texture);
        let uv = self.input(context, &relief.uv);
        self.sample(of, uv, texture.channel.unwrap_or(0), format!("{}/relief", context.path), relief.span)
    }
}
