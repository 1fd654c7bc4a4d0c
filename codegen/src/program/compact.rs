//! Leaves out the parameters, textures and samplers that nothing live reads.

use std::collections::{BTreeMap, BTreeSet};

use super::{LayerRelief, Op, Program, ProgramTexture, ReliefArray, ValueId};

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

    /// Forgets every displaced surface.
    pub fn flatten(&mut self) {
        self.relief = None;
        self.layers.iter_mut().for_each(|layer| layer.relief = None);
    }

    /// Keeps only the height maps of these layers.
    pub fn keep_reliefs(&mut self, visible: &[usize]) {
        let Some(relief) = &mut self.relief else { return };
        let visible = |index: &usize| visible.contains(index);
        let used: BTreeSet<(usize, usize)> = self
            .layers
            .iter()
            .enumerate()
            .filter(|(index, _)| visible(index))
            .filter_map(|(_, layer)| layer.relief.map(|relief| (relief.array, relief.layer)))
            .collect();
        let arrays = renumber(&used.iter().map(|(array, _)| *array).collect());
        let maps = |array: usize| renumber(&used.iter().filter(|(of, _)| *of == array).map(|(_, map)| *map).collect());
        for layer in self.layers.iter_mut().enumerate().filter(|(index, _)| visible(index)).map(|(_, layer)| layer) {
            layer.relief = layer.relief.map(|relief| LayerRelief {
                array: arrays[&relief.array],
                layer: maps(relief.array)[&relief.layer],
                ..relief
            });
        }
        let kept = |(array, maps): (usize, BTreeMap<usize, usize>)| ReliefArray {
            size: relief.arrays[array].size,
            maps: maps.keys().map(|map| relief.arrays[array].maps[*map].clone()).collect(),
        };
        relief.arrays = arrays.keys().map(|array| (*array, maps(*array))).map(kept).collect();
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
