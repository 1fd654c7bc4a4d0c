//! Parts of literals.

use crate::value::Literal;

/// The components of a literal that a swizzle names, `None` where it names one that is not there.
pub(super) fn swizzle(literal: Literal, swizzle: &str) -> Option<Literal> {
    let values = literal.values();
    let part: Option<Vec<f32>> = swizzle.chars().map(|name| values.get("xyzw".find(name)?).copied()).collect();
    part.filter(|part| (1..=4).contains(&part.len())).map(|part| Literal::floats(&part))
}
