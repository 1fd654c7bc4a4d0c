//! RON with places: stock `ron` is the only authority on syntax, and every part of a file knows its bytes.
//!
//! `ron` has no spans for values, but it can borrow the text of any value ([`ron::value::RawValue`]); where a borrowed
//! text lies in the file is pointer arithmetic. A file is looked at one level at a time: [`Raw::shape`] parses one
//! value and keeps its parts as raw text. So every value, key and call is at hand with its place and in its order, two
//! equal keys are both seen, and one wrong value does not hide the next one.

mod bracket;
mod error;
mod field;
mod fields;
mod number;
mod raw;
mod shape;

pub(crate) use field::{Field, within};
pub(crate) use fields::Fields;
pub(crate) use number::{Number, to_f32, to_i32, to_u32};
pub(crate) use raw::Raw;
pub(crate) use shape::{Key, Shape};
