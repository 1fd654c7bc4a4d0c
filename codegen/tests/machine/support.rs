//! WGSL text to a machine.

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use terrane_codegen::machine::{Domain, Machine, NoTextures, Value};

/// A checked module.
pub(crate) struct Shader {
    pub(crate) module: naga::Module,
    pub(crate) info: ModuleInfo,
}

/// # Panics
/// If naga rejects the text.
#[track_caller]
pub(crate) fn shader(text: &str) -> Shader {
    let module = naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    Shader { module, info }
}

impl Shader {
    pub(crate) fn machine(&self) -> Machine<'_> {
        Machine::new(&self.module, &self.info, &NoTextures)
    }

    /// The result of a function without textures.
    #[track_caller]
    pub(crate) fn call<D: Domain>(&self, function: &str, arguments: &[Value<D>], points: usize) -> Value<D> {
        match self.machine().call(function, arguments, points) {
            Ok((value, _)) => value,
            Err(error) => panic!("{error}"),
        }
    }
}
