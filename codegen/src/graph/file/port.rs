//! Parameters of surfaces and inputs of instances as they are written.

use super::expr::{self, Expr};
use crate::diagnostic::Diagnostic;
use crate::graph::syntax::{Field, Fields};

/// A parameter of a surface or an input of an instance.
#[derive(Clone, Debug)]
pub(crate) struct PortEntry {
    pub(crate) doc: String,
    pub(crate) kind: PortKind,
    pub(crate) unit: Option<String>,
    pub(crate) range: Option<(f32, f32)>,
    pub(crate) default: Option<Expr>,
}

/// `kind:` of a parameter or an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PortKind {
    Number,
    Vec2,
    Vec3,
    Vec4,
    Color,
    I32,
    U32,
    Place,
    Coord,
    Texture,
}

/// Every kind of a parameter, with its name in files; the rest is for inputs only.
pub(super) const PARAMETER_KINDS: [(&str, PortKind); 5] = [
    ("number", PortKind::Number),
    ("vec2", PortKind::Vec2),
    ("vec3", PortKind::Vec3),
    ("vec4", PortKind::Vec4),
    ("color", PortKind::Color),
];

/// Every kind of an input.
pub(super) const INPUT_KINDS: [(&str, PortKind); 10] = [
    PARAMETER_KINDS[0],
    PARAMETER_KINDS[1],
    PARAMETER_KINDS[2],
    PARAMETER_KINDS[3],
    PARAMETER_KINDS[4],
    ("i32", PortKind::I32),
    ("u32", PortKind::U32),
    ("place", PortKind::Place),
    ("coord", PortKind::Coord),
    ("texture", PortKind::Texture),
];

/// Reads a parameter or an input.
pub(super) fn port(field: Field<'_>, kinds: &[(&str, PortKind)], findings: &mut Vec<Diagnostic>) -> Option<PortEntry> {
    let what = if kinds.len() == PARAMETER_KINDS.len() { "a parameter" } else { "an input" };
    let mut fields = Fields::open(field.raw, what, findings)?;
    let doc = fields.take("doc").and_then(|field| field.text(findings)).unwrap_or_default();
    let kind = fields.take("kind").map(|field| field.choice(kinds, findings));
    let unit = fields.take("unit").and_then(|field| field.text(findings));
    let range = fields.take("range").and_then(|field| field.range(f32::MIN, f32::MAX, findings));
    let default = if what == "a parameter" { fields.need("default", findings) } else { fields.take("default") };
    let default = default.map(|field| expr::read(field, findings));
    fields.close(findings);
    let kind = kind.unwrap_or(Some(PortKind::Number))?;
    if what == "a parameter" && default.is_none() {
        return None;
    }
    // An unreadable default is reported; a port without one would demand a wire.
    let default = match default {
        Some(expr) => Some(expr?),
        None => None,
    };
    Some(PortEntry { doc, kind, unit, range, default })
}
