//! What a function of the core is given.

use std::collections::BTreeSet;

use super::core::{parameters, resources};
use crate::program::{Program, ValueId};

/// Names and types, in order.
pub(crate) struct Arguments(Vec<(String, String)>);

/// What a function that computes `live` is given: the place, `more`, which is written as WGSL does, `name: type`, then what the
/// values read.
pub(crate) fn arguments(program: &Program, live: &BTreeSet<ValueId>, more: &[&str]) -> Arguments {
    let mut all = vec!["terrain: TerrainIn".to_owned()];
    all.extend(more.iter().map(|argument| (*argument).to_owned()));
    if !parameters(program, live).is_empty() {
        all.push("parameters: TerrainParameters".into());
    }
    let (arrays, samplers) = resources(program, live);
    all.extend(arrays.iter().map(|array| format!("{}: texture_2d_array<f32>", program.arrays[*array].name())));
    all.extend(samplers.iter().map(|sampler| format!("{}: sampler", program.samplers[*sampler].name())));
    let part = |argument: &String| argument.split_once(": ").map(|(name, ty)| (name.to_owned(), ty.to_owned()));
    Arguments(all.iter().filter_map(part).collect())
}

impl Arguments {
    /// As a function declares them, one a line where that is long.
    pub(crate) fn declared(&self) -> String {
        let all: Vec<String> = self.0.iter().map(|(name, ty)| format!("{name}: {ty}")).collect();
        let one_line = all.join(", ");
        if one_line.len() <= 80 { one_line } else { format!("\n    {},\n", all.join(",\n    ")) }
    }

    /// Their names.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name.as_str())
    }
}
