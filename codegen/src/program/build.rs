//! From graphs to values.

use std::collections::BTreeMap;

use super::fold::{self, Folder};
use super::resource::{Format, ProgramParameter, ProgramTexture, SamplerKey, TextureArray};
use super::{Op, Options, Origin, Pool, Program, ProgramLayer, Value, ValueId};
use crate::diagnostic::Span;
use crate::graph::model::{
    Access, Blend, Callee, FrameField, Graph, GraphId, Graphs, Input, InputValue, LayerMask, Node, Parameter, Relief,
    SURFACE_OUTPUTS, Terrain, Texture,
};
use crate::library::Library;
use crate::value::{Literal, Type};

impl Program {
    /// Every layer of a terrain.
    pub fn of_terrain(library: &Library, graphs: &Graphs, terrain: &Terrain, options: Options) -> Self {
        let mut builder = Builder::new(library, graphs, options);
        for layer in &terrain.layers {
            let name = builder.layer_name(layer.surface);
            let mask = builder.layer_mask(&layer.mask);
            builder.layer(layer.surface, name, &layer.parameters, mask, layer.span);
        }
        builder.finish(&terrain.name, terrain.blend)
    }

    /// One surface alone.
    pub fn of_surface(library: &Library, graphs: &Graphs, surface: GraphId, options: Options) -> Self {
        let mut builder = Builder::new(library, graphs, options);
        let graph = &graphs.graphs[surface.0];
        let span = Span { source: graph.source, start: 0, end: 0 };
        builder.layer(surface, graph.name.clone(), &BTreeMap::new(), None, span);
        builder.finish(&graph.name, Blend::Over)
    }
}

/// What the names of one graph mean at one place of use.
struct Context<'a> {
    graph: &'a Graph,
    /// `granite`, or `granite/edge` inside an instance.
    path: String,
    /// Values of the instance's inputs.
    arguments: Vec<ValueId>,
    /// Position in [`Program::parameters`] of each parameter.
    parameters: Vec<usize>,
    /// Results of the nodes so far: one value, or an instance's outputs.
    results: Vec<NodeResult>,
}

enum NodeResult {
    Value(ValueId),
    Outputs(BTreeMap<String, ValueId>),
}

struct Builder<'a> {
    library: &'a Library,
    graphs: &'a Graphs,
    /// Absent where nothing is to be folded.
    folder: Option<Folder<'a>>,
    program: Program,
    masks: BTreeMap<GraphId, ValueId>,
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
        };
        let folder = options.fold.then(|| Folder::new(library));
        Self { library, graphs, folder, program, masks: BTreeMap::new() }
    }

    fn finish(mut self, name: &str, blend: Blend) -> Program {
        self.program.name = name.to_owned();
        self.program.blend = blend;
        self.program
    }

    /// A surface that lies twice gets a number, so that each layer has parameters of its own.
    fn layer_name(&self, surface: GraphId) -> String {
        let graph = &self.graphs.graphs[surface.0];
        let same = self.program.layers.iter().filter(|layer| layer.path == graph.path).count();
        if same == 0 { graph.name.clone() } else { format!("{}_{}", graph.name, same + 1) }
    }

    fn layer_mask(&mut self, mask: &LayerMask) -> Option<ValueId> {
        match mask {
            LayerMask::Full => None,
            LayerMask::Painted(texture) => {
                let of = self.texture(texture);
                let uv = self.leaf(Op::Frame(FrameField::TerrainUv), FrameField::TerrainUv.ty());
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

    fn layer(
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
                (None, _, Some(default)) => self.literal(Literal::floats(default)),
                // Resolution refuses a surface without the outputs that have no default.
                (None, _, None) => continue,
            };
            outputs.insert(output, value);
        }
        let own = outputs.remove("mask").unwrap_or_else(|| self.literal(Literal::f32(1.0)));
        let mask = layer_mask.map_or(own, |mask| self.product(own, mask, &context.path, span));
        let (path, doc) = (graph.path.clone(), graph.doc.clone());
        self.program.layers.push(ProgramLayer { name, path, doc, mask, outputs, span });
    }

    fn graph(&mut self, graph: &'a Graph, path: String, overrides: &BTreeMap<String, Literal>) -> Context<'a> {
        let parameters = graph.parameters.iter().map(|parameter| {
            let default = overrides.get(&parameter.name).copied().unwrap_or(parameter.default);
            self.parameter(format!("{path}_{}", parameter.name), parameter, default)
        });
        let parameters = parameters.collect();
        self.nodes(Context { graph, path, arguments: Vec::new(), parameters, results: Vec::new() })
    }

    fn parameter(&mut self, wanted: String, parameter: &Parameter, default: Literal) -> usize {
        let taken = |name: &str| self.program.parameters.iter().any(|known| known.name == name);
        // Surface `a` with `b_c` and surface `a_b` with `c` want the same name.
        let name = unique(wanted, taken);
        let (ty, unit, doc) = (parameter.ty.clone(), parameter.unit.clone(), parameter.doc.clone());
        let (color, range) = (parameter.color, parameter.range);
        self.program.parameters.push(ProgramParameter { name, ty, color, unit, range, default, doc });
        self.program.parameters.len() - 1
    }

    fn nodes(&mut self, mut context: Context<'a>) -> Context<'a> {
        for node in &context.graph.nodes {
            let result = self.node(&context, node);
            context.results.push(result);
        }
        context
    }

    fn node(&mut self, context: &Context<'a>, node: &Node) -> NodeResult {
        let inputs: Vec<ValueId> = node.inputs.iter().map(|input| self.input(context, input)).collect();
        let path = format!("{}/{}", context.path, node.name);
        match &node.callee {
            Callee::Function { kind, overload } => {
                let overload = &self.library.kinds[kind].overloads[*overload];
                let mut value = self.call(&overload.function, inputs, overload.output.ty.clone());
                self.program.pool.name(value, Origin { path, span: node.span });
                if let Some(channel) = node.channel {
                    value = self.component(value, channel);
                }
                NodeResult::Value(value)
            }
            Callee::Instance(id) => {
                let graph = &self.graphs.graphs[id.0];
                let inner = Context { graph, path, arguments: inputs, parameters: Vec::new(), results: Vec::new() };
                let inner = self.nodes(inner);
                let outputs =
                    graph.outputs.iter().map(|(name, output)| (name.clone(), self.input(&inner, &output.input)));
                NodeResult::Outputs(outputs.collect())
            }
        }
    }

    fn input(&mut self, context: &Context<'a>, input: &Input) -> ValueId {
        let mut value = match &input.value {
            InputValue::Literal(literal) | InputValue::Default(literal) => self.literal(*literal),
            InputValue::Node(node) => match &context.results[*node] {
                NodeResult::Value(value) => *value,
                NodeResult::Outputs(outputs) => *outputs.values().next().unwrap_or(&ValueId(0)),
            },
            InputValue::NodeOutput { node, output } => match &context.results[*node] {
                NodeResult::Value(value) => *value,
                NodeResult::Outputs(outputs) => outputs[output],
            },
            InputValue::Frame(field) => self.leaf(Op::Frame(*field), field.ty()),
            InputValue::Parameter(index) => {
                let ty = context.graph.parameters[*index].ty.clone();
                self.leaf(Op::Parameter(context.parameters[*index]), ty)
            }
            InputValue::InstanceInput(index) => context.arguments[*index],
            InputValue::Texture(index) => self.texture(&context.graph.textures[*index]),
        };
        for access in &input.access {
            value = self.access(value, access.clone());
        }
        match input.widen {
            Some(count) => self.widen(value, count),
            None => value,
        }
    }

    fn relief_height(&mut self, context: &Context<'a>, relief: &Relief) -> ValueId {
        let texture = &context.graph.textures[relief.texture];
        let of = self.texture(texture);
        let uv = self.input(context, &relief.uv);
        self.sample(of, uv, texture.channel.unwrap_or(0), format!("{}/relief", context.path), relief.span)
    }

    fn sample(&mut self, of: ValueId, uv: ValueId, channel: u8, path: String, span: Span) -> ValueId {
        let texel = self.call("texture", vec![of, uv], Type::Vec4);
        self.program.pool.name(texel, Origin { path, span });
        self.component(texel, channel)
    }

    fn component(&mut self, value: ValueId, channel: u8) -> ValueId {
        let name = ["x", "y", "z", "w"][usize::from(channel.min(3))];
        self.access(value, Access::Swizzle(name.into()))
    }

    fn call(&mut self, function: &str, inputs: Vec<ValueId>, ty: Type) -> ValueId {
        let known = || inputs.iter().map(|input| self.program.pool.literal(*input)).collect::<Option<Vec<_>>>();
        if let Some(folder) = &self.folder
            && let Some(literal) = known().and_then(|arguments| folder.call(function, &arguments, &ty))
        {
            return self.literal(literal);
        }
        self.program.pool.add(Value { op: Op::Call(function.to_owned()), inputs, ty })
    }

    fn access(&mut self, value: ValueId, access: Access) -> ValueId {
        if let (Some(literal), Access::Swizzle(swizzle)) = (self.program.pool.literal(value), &access)
            && let Some(part) = fold::swizzle(literal, swizzle)
        {
            return self.literal(part);
        }
        let ty = access_type(self.library, &self.program.pool.get(value).ty, &access);
        self.program.pool.add(Value { op: Op::Access(access), inputs: vec![value], ty })
    }

    fn widen(&mut self, value: ValueId, count: u8) -> ValueId {
        if let Some([number]) = self.program.pool.literal(value).map(|literal| literal.values()).as_deref() {
            return self.literal(Literal::floats(&vec![*number; usize::from(count)]));
        }
        let ty = Type::floats(usize::from(count)).unwrap_or(Type::F32);
        self.program.pool.add(Value { op: Op::Widen, inputs: vec![value], ty })
    }

    fn product(&mut self, a: ValueId, b: ValueId, path: &str, span: Span) -> ValueId {
        let one = Some(Literal::f32(1.0));
        match (self.program.pool.literal(a), self.program.pool.literal(b)) {
            (literal, _) if literal == one => b,
            (_, literal) if literal == one => a,
            _ => {
                let value = self.program.pool.add(Value { op: Op::Product, inputs: vec![a, b], ty: Type::F32 });
                self.program.pool.name(value, Origin { path: format!("{path}/mask"), span });
                value
            }
        }
    }

    fn literal(&mut self, literal: Literal) -> ValueId {
        self.leaf(Op::Literal(literal), literal.ty())
    }

    fn leaf(&mut self, op: Op, ty: Type) -> ValueId {
        self.program.pool.add(Value { op, inputs: Vec::new(), ty })
    }

    /// Files of equal size and format share an array, so that a terrain stays within WebGPU's 16 textures.
    fn texture(&mut self, texture: &Texture) -> ValueId {
        let (format, size) = (Format::of(texture), texture.size);
        let array = position(
            &mut self.program.arrays,
            |array| array.format == format && array.size == size,
            || TextureArray { format, size, files: Vec::new() },
        );
        let files = &mut self.program.arrays[array].files;
        let layer = position(files, |file| *file == texture.file, || texture.file.clone());
        let key = SamplerKey::of(texture);
        let sampler = position(&mut self.program.samplers, |known| *known == key, || key);
        let used = ProgramTexture { array, layer, sampler };
        let index = position(&mut self.program.textures, |known| *known == used, || used);
        self.leaf(Op::Texture(index), Type::Texture)
    }
}

/// The name, or the first of `name_2`, `name_3` … that is free.
pub(crate) fn unique(name: String, taken: impl Fn(&str) -> bool) -> String {
    if !taken(&name) {
        return name;
    }
    (2..).map(|number| format!("{name}_{number}")).find(|name| !taken(name)).unwrap_or(name)
}

/// The position of what fits, after adding it if nothing did.
fn position<T>(list: &mut Vec<T>, fits: impl Fn(&T) -> bool, make: impl FnOnce() -> T) -> usize {
    list.iter().position(fits).unwrap_or_else(|| {
        list.push(make());
        list.len() - 1
    })
}

fn access_type(library: &Library, ty: &Type, access: &Access) -> Type {
    match (ty, access) {
        (Type::Struct(name), Access::Member(member)) => {
            let found = library.structs.get(name).and_then(|members| members.iter().find(|port| port.name == *member));
            found.map_or(Type::F32, |port| port.ty.clone())
        }
        (_, Access::Swizzle(swizzle)) => Type::floats(swizzle.len()).unwrap_or(Type::F32),
        (other, Access::Member(_)) => other.clone(),
    }
}
