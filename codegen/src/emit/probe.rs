//! A function that returns every named value of a program: for the machine, to compare and to explain.

use super::core::{body_with, declarations};
use super::names::Names;
use super::text::{Place, Shader};
use crate::library::Library;
use crate::patch::{Scope, Specialization};
use crate::program::{Program, ValueId};

/// A text with `terrane_probe`, which takes what `terrane_surface` takes and returns a struct of all values.
pub struct Probe {
    /// The text.
    pub shader: Shader,
    /// Which value each member of the result is, in order.
    pub members: Vec<ValueId>,
}

/// Every named value of an unguarded specialization.
pub fn probe(library: &Library, program: &Program, patch: &Specialization) -> Probe {
    let members = patch.scopes.values(&program.pool, Scope::Root);
    let mut body = Shader::default();
    body.open("struct TerraneProbe");
    for (index, id) in members.iter().enumerate() {
        body.line(&format!("value_{index}: {},", program.pool.get(*id).ty.wgsl()));
    }
    // WGSL knows no empty struct.
    body.line("end: f32,");
    body.close();
    let write = |shader: &mut Shader, names: &Names<'_>| {
        for id in &members {
            shader.mapped(Place::Value(*id), &format!("let {} = {};", names.name(*id), names.expression(*id)));
        }
        let values: Vec<&str> = members.iter().map(|id| names.name(*id)).chain(["0.0f"]).collect();
        shader.line(&format!("return TerraneProbe({});", values.join(", ")));
    };
    body.append(body_with(library, program, patch, ("terrane_probe", "TerraneProbe"), write));
    let mut shader = Shader::default();
    declarations(&mut shader, library, &library.closure(&body.text));
    shader.append(body);
    Probe { shader, members }
}
