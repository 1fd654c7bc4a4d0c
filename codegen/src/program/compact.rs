//! Leaves out the parameters, textures and samplers that nothing live reads.

use std::collections::{BTreeMap, BTreeSet};

use super::{Op, Program, ProgramTexture, ValueId};

impl Program {
    /// Keeps only what these values read; bindings and the uniform block shrink to it.
    pub fn keep(&mut self, live: &BTreeSet<ValueId>) {
        let ops: Vec<&Op> = live.iter().map(|id| &self.pool.get(*id).op).collect();
        let parameters: BTreeSet<usize> =
            ops.iter().filter_map(|op| if let Op::Parameter(index) = op { Some(*index) } else { None }).collect();
        let textures: BTreeSet<usize> =
            ops.iter().filter_map(|op| if let Op::Texture(index) = op { Some(*index) } else { None }).collect();

        let new_parameters = renumber(&parameters);
        self.parameters = parameters.iter().map(|index| self.parameters[*index].clone()).collect();
        let new_textures = renumber(&textures);
        self.keep_textures(&textures);
        self.pool.replace(|op| match op {
            Op::Parameter(index) => Op::Parameter(new_parameters.get(index).copied().unwrap_or(*index)),
            Op::Texture(index) => Op::Texture(new_textures.get(index).copied().unwrap_or(*index)),
            other => other.clone(),
        });
    }

    fn keep_textures(&mut self, kept: &BTreeSet<usize>) {
        let old: Vec<ProgramTexture> = kept.iter().map(|index| self.textures[*index]).collect();
        let arrays: BTreeSet<usize> = old.iter().map(|texture| texture.array).collect();
        let samplers: BTreeSet<usize> = old.iter().map(|texture| texture.sampler).collect();
        let layers: BTreeMap<usize, BTreeMap<usize, usize>> = arrays
            .iter()
            .map(|array| {
                let used = old.iter().filter(|texture| texture.array == *array).map(|texture| texture.layer).collect();
                (*array, renumber(&used))
            })
            .collect();
        let (new_arrays, new_samplers) = (renumber(&arrays), renumber(&samplers));
        self.textures = old
            .iter()
            .map(|texture| ProgramTexture {
                array: new_arrays[&texture.array],
                layer: layers[&texture.array][&texture.layer],
                sampler: new_samplers[&texture.sampler],
            })
            .collect();
        self.arrays = arrays
            .iter()
            .map(|array| {
                let mut kept = self.arrays[*array].clone();
                kept.files = layers[array].keys().map(|layer| kept.files[*layer].clone()).collect();
                kept
            })
            .collect();
        self.samplers = samplers.iter().map(|sampler| self.samplers[*sampler]).collect();
    }
}

/// New positions for the positions that stay.
fn renumber(kept: &BTreeSet<usize>) -> BTreeMap<usize, usize> {
    kept.iter().enumerate().map(|(new, old)| (*old, new)).collect()
}
