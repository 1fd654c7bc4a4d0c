//! Numbers as they are written, and what becomes of them in a shader.

use super::raw::Raw;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::codes;

/// A number in a file.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    /// To the precision of f64.
    pub(crate) value: f64,
    /// As it is written.
    pub(crate) text: String,
    /// Its place.
    pub(crate) span: Span,
}

impl Number {
    pub(super) fn new(value: f64, raw: Raw<'_>) -> Self {
        Self { value, text: raw.text().to_owned(), span: raw.span() }
    }

    /// Whether it has no fraction.
    pub(crate) fn is_whole(&self) -> bool {
        self.value.fract() == 0.0
    }
}

/// As the nearest f32.
///
/// # Errors
/// NaN, infinity and overflow; what underflows; a whole number that becomes another one.
pub(crate) fn to_f32(number: &Number) -> Result<f32, Diagnostic> {
    finite(number)?;
    // Rounded once, from the digits: by way of f64 a long number would be rounded twice.
    let value = number.text.replace('_', "").parse().unwrap_or(number.value as f32);
    let (text, span) = (&number.text, number.span);
    if value.is_infinite() {
        return Err(Diagnostic::error(codes::OVERFLOW, span, format!("{text} is too large for f32"))
            .help(format!("the largest f32 is {:e}", f32::MAX)));
    }
    if value.is_subnormal() || (value == 0.0 && number.value != 0.0) {
        let message = format!("{text} is too small for f32: a shader may read 0");
        return Err(Diagnostic::error(codes::LOSSY_NUMBER, span, message)
            .help(format!("write 0, or a number of at least {:e}", f32::MIN_POSITIVE)));
    }
    let digits = !text.contains(['e', 'E']);
    if digits && number.is_whole() && f64::from(value) != number.value {
        let message = format!("{text} cannot be held by f32: a shader would read {}", f64::from(value));
        return Err(Diagnostic::error(codes::LOSSY_NUMBER, span, message)
            .help("f32 holds every whole number up to 16777216, and fewer and fewer above"));
    }
    // The sign of a zero would make two values of one.
    Ok(value + 0.0)
}

/// As a whole number.
///
/// # Errors
/// A fraction; what i32 does not hold.
pub(crate) fn to_i32(number: &Number) -> Result<i32, Diagnostic> {
    whole(number, f64::from(i32::MIN), f64::from(i32::MAX), "i32").map(|value| value as i32)
}

/// As a whole number that is not negative.
///
/// # Errors
/// A fraction; what u32 does not hold.
pub(crate) fn to_u32(number: &Number) -> Result<u32, Diagnostic> {
    whole(number, 0.0, f64::from(u32::MAX), "u32").map(|value| value as u32)
}

fn whole(number: &Number, low: f64, high: f64, ty: &str) -> Result<f64, Diagnostic> {
    finite(number)?;
    let (text, span) = (&number.text, number.span);
    if !number.is_whole() {
        return Err(Diagnostic::error(codes::LOSSY_NUMBER, span, format!("{text} is not a whole number"))
            .help(format!("write {} or {}", number.value.floor(), number.value.ceil())));
    }
    if !(low..=high).contains(&number.value) {
        let message = format!("{text} does not fit {ty}, its range is {low}..{high}");
        return Err(Diagnostic::error(codes::OVERFLOW, span, message));
    }
    Ok(number.value)
}

fn finite(number: &Number) -> Result<(), Diagnostic> {
    if number.value.is_finite() {
        return Ok(());
    }
    if number.text.contains(|c: char| c.is_ascii_digit()) && !number.text.contains(['i', 'N']) {
        let message = format!("{} is too large for any number", number.text);
        return Err(Diagnostic::error(codes::OVERFLOW, number.span, message));
    }
    Err(Diagnostic::error(codes::NOT_FINITE, number.span, format!("{} is not a finite number", number.text))
        .help("WGSL gives no meaning to NaN and infinity"))
}
