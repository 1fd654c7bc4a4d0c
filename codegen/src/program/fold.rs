//! Parts of literals, and calls whose arguments are all known.

use std::cell::OnceCell;

use crate::library::Library;
use crate::machine::{F32, Machine, NoTextures, Value};
use crate::value::{Literal, Type};

/// The components of a literal that a swizzle names, `None` where it names one that is not there.
pub(super) fn swizzle(literal: Literal, swizzle: &str) -> Option<Literal> {
    let values = literal.values();
    let part: Option<Vec<f32>> = swizzle.chars().map(|name| values.get("xyzw".find(name)?).copied()).collect();
    part.filter(|part| (1..=4).contains(&part.len())).map(|part| Literal::floats(&part))
}

/// Evaluates calls of the library in f32, as a shader does.
pub(super) struct Folder<'a> {
    library: &'a Library,
    /// Most programs have nothing to fold.
    machine: OnceCell<Machine<'static>>,
}

impl<'a> Folder<'a> {
    pub(super) fn new(library: &'a Library) -> Self {
        Self { library, machine: OnceCell::new() }
    }

    /// The result, where it is the same on every device and finite.
    pub(super) fn call(&self, function: &str, arguments: &[Literal], ty: &Type) -> Option<Literal> {
        let components = ty.components().filter(|_| !matches!(ty, Type::I32 | Type::U32))?;
        if !self.library.exact.contains(function) {
            return None;
        }
        let machine = self.machine.get_or_init(|| Machine::new(&self.library.module, &self.library.info, &NoTextures));
        let arguments: Vec<Value<F32>> = arguments.iter().map(value).collect();
        let (result, _) = machine.call::<F32>(function, &arguments, 1).ok()?;
        let values: Option<Vec<f32>> = (0..components).map(|component| result.float_at(component, 0)).collect();
        values.filter(|values| values.iter().all(|value| value.is_finite())).map(|values| Literal::floats(&values))
    }
}

fn value(literal: &Literal) -> Value<F32> {
    match literal {
        Literal::I32(value) => Value::i32(&[*value]),
        Literal::U32(value) => Value::u32(&[*value]),
        Literal::Floats { .. } => Value::join(literal.values().iter().map(|value| Value::f32(&[*value]))),
    }
}
