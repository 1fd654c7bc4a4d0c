//! Pipelines for every entry point of a module, from what naga says of its inputs and outputs.

use std::collections::BTreeMap;

use naga::{Binding, EntryPoint, ScalarKind, ShaderStage, TypeInner};
use serde_json::{Value, json};

use super::{Module, Pipeline};

impl Module {
    /// A module alone, without pipelines.
    pub(crate) fn text_only(name: impl Into<String>, wgsl: impl Into<String>) -> Self {
        Self { name: name.into(), wgsl: wgsl.into(), pipelines: Vec::new() }
    }

    /// A module with a pipeline for each compute stage, each fragment stage (with the first vertex stage that feeds it)
    /// and each vertex stage that feeds none.
    ///
    /// # Panics
    /// If naga does not parse the text, or nothing feeds a fragment stage.
    pub(crate) fn with_pipelines(name: impl Into<String>, wgsl: impl Into<String>) -> Self {
        let mut module = Self::text_only(name, wgsl);
        let parsed = naga::front::wgsl::parse_str(&module.wgsl)
            .unwrap_or_else(|error| panic!("{}", error.emit_to_string_with_path(&module.wgsl, &module.name)));
        module.pipelines = pipelines(&parsed);
        module
    }

    /// The same with an explicit layout for its pipelines: arrays of `GPUBindGroupLayoutEntry`, group by group.
    pub(crate) fn with_layouts(mut self, layouts: &Value) -> Self {
        for pipeline in &mut self.pipelines {
            pipeline.layouts = Some(layouts.clone());
        }
        self
    }
}

fn pipelines(module: &naga::Module) -> Vec<Pipeline> {
    let of = |stage| module.entry_points.iter().filter(move |entry| entry.stage == stage);
    let compute = of(ShaderStage::Compute).map(|entry| {
        let stage = json!({ "entryPoint": entry.name });
        Pipeline { name: entry.name.clone(), compute: Some(stage), ..Pipeline::default() }
    });
    let mut feeding = Vec::new();
    let drawn: Vec<Pipeline> = of(ShaderStage::Fragment)
        .map(|fragment| {
            let wanted = inputs(module, fragment);
            let fed = |vertex: &&EntryPoint| contains(&outputs(module, vertex), &wanted);
            let vertex = of(ShaderStage::Vertex).find(fed);
            let vertex = vertex.unwrap_or_else(|| panic!("no vertex stage feeds `{}`", fragment.name));
            feeding.push(&vertex.name);
            render(module, vertex, Some(fragment))
        })
        .collect();
    let idle = of(ShaderStage::Vertex).filter(|vertex| !feeding.contains(&&vertex.name));
    let idle = idle.map(|vertex| render(module, vertex, None));
    compute.chain(drawn).chain(idle).collect()
}

fn render(module: &naga::Module, vertex: &EntryPoint, fragment: Option<&EntryPoint>) -> Pipeline {
    let names = [Some(vertex), fragment].into_iter().flatten().map(|entry| entry.name.as_str());
    Pipeline {
        name: names.collect::<Vec<_>>().join(" + "),
        vertex: Some(json!({ "entryPoint": vertex.name, "buffers": buffers(&inputs(module, vertex)) })),
        fragment: fragment
            .map(|fragment| json!({ "entryPoint": fragment.name, "targets": targets(&outputs(module, fragment)) })),
        ..Pipeline::default()
    }
}

/// Scalar kind and number of components of the value at each `@location`.
type Locations = BTreeMap<u32, (ScalarKind, u8)>;

fn inputs(module: &naga::Module, entry: &EntryPoint) -> Locations {
    let arguments = entry.function.arguments.iter();
    arguments.flat_map(|argument| locations(module, argument.ty, argument.binding.as_ref())).collect()
}

fn outputs(module: &naga::Module, entry: &EntryPoint) -> Locations {
    let result = entry.function.result.iter();
    result.flat_map(|result| locations(module, result.ty, result.binding.as_ref())).collect()
}

fn locations(module: &naga::Module, ty: naga::Handle<naga::Type>, binding: Option<&Binding>) -> Locations {
    let inner = &module.types[ty].inner;
    match (inner, binding) {
        (TypeInner::Struct { members, .. }, _) => {
            members.iter().flat_map(|member| locations(module, member.ty, member.binding.as_ref())).collect()
        }
        (_, Some(&Binding::Location { location, .. })) => BTreeMap::from([(location, shape(inner))]),
        _ => Locations::new(),
    }
}

fn shape(inner: &TypeInner) -> (ScalarKind, u8) {
    match *inner {
        TypeInner::Scalar(scalar) => (scalar.kind, 1),
        TypeInner::Vector { size, scalar } => (scalar.kind, size as u8),
        _ => panic!("WGSL allows scalars and vectors at a location, not {inner:?}"),
    }
}

fn contains(all: &Locations, some: &Locations) -> bool {
    some.iter().all(|(location, shape)| all.get(location) == Some(shape))
}

/// A vertex buffer for each input.
fn buffers(inputs: &Locations) -> Value {
    let buffer = |(&location, &(kind, components)): (&u32, &(ScalarKind, u8))| {
        let count = if components == 1 { String::new() } else { format!("x{components}") };
        let format = format!("{}32{count}", ["float", "sint", "uint"][family(kind)]);
        let attribute = json!({ "shaderLocation": location, "offset": 0, "format": format });
        json!({ "arrayStride": 16, "attributes": [attribute] })
    };
    inputs.iter().map(buffer).collect()
}

/// A 16-bit colour target for each output, with as many components as it writes (no format has three).
fn targets(outputs: &Locations) -> Value {
    let count = outputs.keys().max().map_or(0, |last| last + 1);
    let target = |location| {
        let &(kind, components) = outputs.get(&location)?;
        let channels = ["r", "rg", "rg", "rgba"][usize::from(components) - 1];
        Some(json!({ "format": format!("{channels}16{}", ["float", "sint", "uint"][family(kind)]) }))
    };
    (0..count).map(target).collect()
}

fn family(kind: ScalarKind) -> usize {
    match kind {
        ScalarKind::Float => 0,
        ScalarKind::Sint => 1,
        ScalarKind::Uint => 2,
        _ => panic!("WGSL allows no {kind:?} at a location"),
    }
}
