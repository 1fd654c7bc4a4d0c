//! The same function at the same points, on a GPU and here.
//!
//! A [`Probe`] is a compute shader that reads arguments from one storage buffer and writes results to another, as 32-bit
//! words, point by point. Whoever has a GPU runs it; [`Probe::judge`] says which results no conforming implementation
//! may give. Nothing here knows how shaders are run.

mod arguments;
mod text;
mod verdict;

use naga::{Handle, Module, Type};

pub use self::arguments::arguments;
use self::text::Text;
pub use self::verdict::{Accepted, Rejection, Verdict};
use super::domain::{Domain, F32};
use super::error::MachineError;
use super::value::{Component, Value};
use crate::library::Library;

/// A compute shader that evaluates one function at many points.
///
/// Group 0: binding 0 holds the arguments (`array<u32>`, read), binding 1 the results (`array<u32>`, read and written),
/// then come the function's textures and samplers. The entry point is `probe_main`, of workgroups of 64 points; a
/// result buffer of n points is filled by n invocations, whatever more are started.
#[derive(Clone, Debug)]
pub struct Probe {
    /// The function that it evaluates.
    pub function: String,
    /// The whole module.
    pub shader: String,
    /// From binding 2 on.
    pub resources: Vec<Resource>,
    /// Words of arguments for each point.
    pub inputs: usize,
    /// Words of results for each point.
    pub outputs: usize,
}

/// What is to be bound beside the buffers, in the order of the parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resource {
    /// A texture.
    Texture,
    /// A sampler.
    Sampler,
}

impl Probe {
    /// Invocations in a workgroup.
    pub const WORKGROUP: u32 = 64;

    /// For a function of the library, of which the shader contains what that needs.
    ///
    /// # Errors
    /// If there is no such function, or it takes or gives something that is not made of 32-bit numbers.
    pub fn new(library: &Library, function: &str) -> Result<Self, MachineError> {
        let mut declarations = String::new();
        for item in library.closure(function) {
            declarations.push_str(library.slice(item));
            declarations.push_str("\n\n");
        }
        Self::of_module(&library.module, &declarations, function)
    }

    /// For a function of a module whose text contains at least what the function needs.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn of_module(module: &Module, text: &str, function: &str) -> Result<Self, MachineError> {
        let unknown = || MachineError::UnknownFunction { name: function.to_owned() };
        let found = module.functions.iter().find(|(_, found)| found.name.as_deref() == Some(function));
        let (_, signature) = found.ok_or_else(unknown)?;
        let parameters: Vec<Handle<Type>> = signature.arguments.iter().map(|argument| argument.ty).collect();
        let result = signature.result.as_ref().map(|result| result.ty);
        text::probe(Text::new(module, function), &parameters, result, text)
    }

    /// The arguments as the shader reads them: all words of the first point, then those of the second ….
    pub fn words(&self, arguments: &[Value<F32>], points: usize) -> Vec<u32> {
        let components: Vec<_> = arguments.iter().flat_map(|argument| &argument.components).collect();
        (0..points).flat_map(|point| components.iter().filter_map(move |component| word(component, point))).collect()
    }
}

/// The bits of a scalar; `None` for textures and samplers.
fn word(component: &Component<F32>, point: usize) -> Option<u32> {
    let at = |length: usize| if length == 1 { 0 } else { point };
    Some(match component {
        Component::Float(values) => values[at(values.len())].to_bits(),
        Component::Int(values) => values[at(values.len())],
        Component::Truth(values) => u32::from(values[at(values.len())]),
        Component::Handle(_) => return None,
    })
}

impl Value<F32> {
    /// The same value in another domain.
    pub fn to<D: Domain>(&self) -> Value<D> {
        let component = |component: &Component<F32>| match component {
            Component::Float(values) => Component::Float(values.iter().map(|value| D::float(*value)).collect()),
            Component::Int(values) => Component::Int(values.iter().map(|value| D::int(*value)).collect()),
            Component::Truth(values) => Component::Truth(values.iter().map(|value| D::truth(*value)).collect()),
            Component::Handle(id) => Component::Handle(*id),
        };
        Value { components: self.components.iter().map(component).collect() }
    }
}
