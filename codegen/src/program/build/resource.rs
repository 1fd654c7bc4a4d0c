//! What a shader is given: members of the uniform block, textures and samplers.

use super::Builder;
use crate::graph::model::{Parameter, Texture};
use crate::program::resource::{Format, ProgramParameter, ProgramTexture, SamplerKey, TextureArray};
use crate::program::{Op, ValueId};
use crate::value::{Literal, Type};

impl Builder<'_> {
    pub(super) fn parameter(&mut self, wanted: String, parameter: &Parameter, default: Literal) -> usize {
        let taken = |name: &str| self.program.parameters.iter().any(|known| known.name == name);
        // Surface `a` with `b_c` and surface `a_b` with `c` want the same name.
        let name = unique(wanted, taken);
        let (ty, unit, doc) = (parameter.ty.clone(), parameter.unit.clone(), parameter.doc.clone());
        let (color, range) = (parameter.color, parameter.range);
        self.program.parameters.push(ProgramParameter { name, ty, color, unit, range, default, doc });
        self.program.parameters.len() - 1
    }

    /// Files of equal size and format share an array, so that a terrain stays within WebGPU's 16 textures.
    pub(super) fn texture(&mut self, texture: &Texture) -> ValueId {
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
pub(super) fn position<T>(list: &mut Vec<T>, fits: impl Fn(&T) -> bool, make: impl FnOnce() -> T) -> usize {
    list.iter().position(fits).unwrap_or_else(|| {
        list.push(make());
        list.len() - 1
    })
}
