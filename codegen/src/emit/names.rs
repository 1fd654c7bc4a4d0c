//! A name for every value, from the graph path of the first node that stands for it.

use std::collections::{BTreeMap, BTreeSet};

use crate::library::Library;
use crate::program::{Op, Program, ValueId, unique};
use crate::value::Type;

/// What the body declares itself.
const WORDS: [&str; 21] = [
    "terrain",
    "parameters",
    "albedo",
    "slopes",
    "roughness",
    "metallic",
    "occlusion",
    "emissive",
    "weight",
    "raw_sum",
    "highest_score",
    "tangent",
    "bitangent",
    "pixel",
    "axes",
    "coordinates",
    "fade",
    "deepest",
    "largest",
    "bottom",
    "relief",
];

/// Names and spellings of the values of one shader.
pub(super) struct Names<'a> {
    program: &'a Program,
    names: BTreeMap<ValueId, String>,
    taken: BTreeSet<String>,
}

impl<'a> Names<'a> {
    /// Names for all these values, in their order.
    pub(super) fn new(library: &Library, program: &'a Program, live: &BTreeSet<ValueId>) -> Self {
        let reserved = naga::keywords::wgsl::RESERVED.iter().map(|word| (*word).to_owned());
        let layers = program.layers.iter().flat_map(|layer| layer_words(&layer.name));
        let mut taken: BTreeSet<String> = reserved.chain(library.names.keys().cloned()).chain(layers).collect();
        taken.extend(WORDS.map(str::to_owned));
        taken.extend(program.arrays.iter().map(crate::program::TextureArray::name));
        let relief = program.relief.iter().flat_map(super::relief::textures);
        taken.extend(relief.map(|(name, _)| name));
        taken.extend(program.samplers.iter().map(|sampler| sampler.name()));
        let mut names = Self { program, names: BTreeMap::new(), taken };
        for id in live.iter().filter(|id| !program.pool.get(**id).is_inline()) {
            let wanted = program.pool.origins(*id).first().map_or("value", |origin| &origin.path).replace('/', "_");
            let name = unique(wanted, |name| names.taken.contains(name));
            names.taken.insert(name.clone());
            names.names.insert(*id, name);
        }
        names
    }

    /// The name that a call's result gets.
    pub(super) fn name(&self, id: ValueId) -> &str {
        &self.names[&id]
    }

    /// The value as it is read.
    pub(super) fn read(&self, id: ValueId) -> String {
        let value = self.program.pool.get(id);
        match &value.op {
            Op::Literal(literal) => literal.wgsl(),
            Op::Frame(field) => format!("terrain.{}", field.name()),
            Op::Parameter(index) => format!("parameters.{}", self.program.parameters[*index].name),
            Op::Texture(index) => self.texture(*index),
            Op::Access(access) => format!("{}.{}", self.read(value.inputs[0]), access.name()),
            Op::Widen => format!("{}({})", value.ty.wgsl(), self.read(value.inputs[0])),
            Op::Call(_) | Op::Product => self.name(id).to_owned(),
        }
    }

    /// The expression that a named value is.
    pub(super) fn expression(&self, id: ValueId) -> String {
        let value = self.program.pool.get(id);
        let inputs: Vec<String> = value.inputs.iter().map(|input| self.read(*input)).collect();
        match &value.op {
            Op::Call(function) => format!("{function}({})", inputs.join(", ")),
            _ => inputs.join(" * "),
        }
    }

    fn texture(&self, index: usize) -> String {
        let texture = self.program.textures[index];
        let (array, sampler) =
            (self.program.arrays[texture.array].name(), self.program.samplers[texture.sampler].name());
        format!("{array}, {sampler}, {}i", texture.layer)
    }

    /// How a variable of the value's type is declared.
    pub(super) fn variable(&self, id: ValueId) -> String {
        let ty: &Type = &self.program.pool.get(id).ty;
        format!("var {}: {};", self.name(id), ty.wgsl())
    }
}

/// The words that composition makes of a layer's name.
fn layer_words(layer: &str) -> [String; 5] {
    ["share", "score", "weight", "weight_raw", "under"].map(|word| layer_word(layer, word))
}

/// `granite_weight`.
pub(super) fn layer_word(layer: &str, word: &str) -> String {
    format!("{layer}_{word}")
}
