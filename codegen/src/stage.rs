//! What a stage may bind: the limits that WebGPU promises, and what a material takes of them.

use crate::diagnostic::{Code, Diagnostic};
use crate::library::texture_variables;
use crate::program::{Program, ReliefArray};

/// More textures than WebGPU promises.
pub const TOO_MANY_TEXTURES: Code = Code { id: "TG201", name: "too-many-textures" };

/// WebGPU's default limit of sampled textures and of samplers in a stage.
const SAMPLED: usize = 16;

/// Of storage textures.
const STORAGE: usize = 4;

/// Textures of one kind that a material binds.
struct Kind<'a> {
    /// What they are called.
    name: &'a str,
    /// What the host leaves of the limit.
    free: usize,
    /// Each with what is in it.
    textures: Vec<String>,
    /// What would make them fewer.
    help: &'a str,
}

/// Refuses more textures than a stage may bind beside those of the host.
pub(crate) fn limits(program: &Program, host: &str) -> Result<(), Vec<Diagnostic>> {
    let [sampled, storage] = texture_variables(host);
    let sampled = Kind {
        name: "texture arrays",
        free: SAMPLED.saturating_sub(sampled),
        textures: arrays(program).chain(maps(program, false)).collect(),
        help: "files of equal size and format share an array: bring the textures to few sizes and formats",
    };
    let storage = Kind {
        name: "storage textures",
        free: STORAGE.saturating_sub(storage),
        textures: maps(program, true).collect(),
        help: "height maps of equal size share theirs: bring them to few sizes, or write `method: walk`",
    };
    [sampled, storage].into_iter().try_for_each(|kind| kind.fits(program))
}

impl Kind<'_> {
    fn fits(&self, program: &Program) -> Result<(), Vec<Diagnostic>> {
        let Self { name, free, textures, help } = self;
        if textures.len() <= *free {
            return Ok(());
        }
        let message = format!("the materials need {} {name}, the host leaves {free}", textures.len());
        let finding = Diagnostic::error(TOO_MANY_TEXTURES, program.layers[0].span, message);
        Err(vec![finding.help(*help).note(textures.join("\n"))])
    }
}

fn arrays(program: &Program) -> impl Iterator<Item = String> {
    program.arrays.iter().map(|array| format!("`{}`: {}", array.name(), array.files.join(", ")))
}

fn maps(program: &Program, storage: bool) -> impl Iterator<Item = String> {
    let files = |array: &ReliefArray| array.maps.iter().map(|map| map.file.clone()).collect::<Vec<_>>().join(", ");
    program.maps(storage).map(move |(array, texture)| format!("`{}`: {}", array.name(texture), files(array)))
}
