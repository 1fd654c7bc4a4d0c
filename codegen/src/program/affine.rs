//! Whether the coordinates of a displaced surface keep straight lines straight.

use super::{Op, Program, ValueId};
use crate::diagnostic::{Code, Diagnostic};
use crate::graph::model::FrameField;
use crate::library::Library;

/// Coordinates that a ray cannot be traced in.
pub(super) const RELIEF_COORDINATES: Code = Code { id: "TG202", name: "relief-coordinates" };

/// Functions of the library whose coordinates are affine in their first argument, if the others are the same everywhere.
const AFFINE: [&str; 4] = ["planar", "rotated", "uv_offset", "uv_scale"];

/// Refuses coordinates in which a straight ray would be bent.
///
/// # Errors
/// With the relief, and the first node that bends it.
pub(crate) fn affine(program: &Program, library: &Library) -> Result<(), Box<Diagnostic>> {
    for layer in &program.layers {
        let Some(relief) = layer.relief else { continue };
        if let Err(bent) = straight(program, relief.uv) {
            let what = program.pool.origins(bent).first().map(|origin| origin.path.clone());
            let what =
                what.map_or_else(|| "they are not made of `position`".into(), |path| format!("`{path}` bends them"));
            let message = "the coordinates of a relief must be affine in `position`, or rays would bend";
            let known: Vec<String> = AFFINE
                .iter()
                .filter(|name| library.kinds.contains_key(**name))
                .map(|name| format!("`{name}`"))
                .collect();
            let finding = Diagnostic::error(RELIEF_COORDINATES, relief.span, message);
            return Err(Box::new(
                finding.help(format!("use {}, with inputs that are the same everywhere", known.join(", "))).note(what),
            ));
        }
    }
    Ok(())
}

/// Whether a value is affine in the position.
fn straight(program: &Program, id: ValueId) -> Result<(), ValueId> {
    let value = program.pool.get(id);
    match &value.op {
        Op::Frame(FrameField::Position) => Ok(()),
        Op::Call(function) if AFFINE.contains(&function.as_str()) => {
            value.inputs.iter().skip(1).try_for_each(|input| even(program, *input))?;
            straight(program, value.inputs[0])
        }
        _ => Err(id),
    }
}

/// Whether a value is the same everywhere.
fn even(program: &Program, id: ValueId) -> Result<(), ValueId> {
    let value = program.pool.get(id);
    match &value.op {
        Op::Frame(_) | Op::Texture(_) => Err(id),
        _ => {
            // What the author wrote is named, not what it is made of.
            let named = |found| if program.pool.origins(found).is_empty() { id } else { found };
            value.inputs.iter().try_for_each(|input| even(program, *input).map_err(named))
        }
    }
}
