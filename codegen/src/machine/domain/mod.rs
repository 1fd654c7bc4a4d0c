//! What a number is: the shader's `f32`, the reference's `f64`, an interval ….
//!
//! A domain is three types (for `f32`, for `i32` and `u32`, for `bool`) and the operations on them, one lane at a time.
//! The machine supplies the rest: lanes, masks, control flow, memory. A concrete domain decides every condition; an
//! abstract one may leave it open ([`Domain::decide`] says `None`), and then both sides run and are joined.

pub mod accept;
mod concrete;
mod double;
mod half;
mod integer;
mod operation;
mod single;

use std::fmt::Debug;

pub use accept::{Accept, Integers, Interval, Three};
pub use double::F64;
pub use operation::{
    FloatBinary, FloatComparison, FloatTernary, FloatUnary, IntBinary, IntComparison, IntUnary, TruthBinary,
};
pub(crate) use operation::{
    each_float_binary, each_float_comparison, each_float_ternary, each_float_unary, each_int_binary,
    each_int_comparison, each_int_unary, each_truth_binary,
};
pub use single::F32;

use super::texture::{Load, Sample, Textures};

/// What a lane of a domain must be.
pub trait Cell: Copy + Default + Debug + PartialEq + Send + Sync + 'static {}

impl<T: Copy + Default + Debug + PartialEq + Send + Sync + 'static> Cell for T {}

/// The arithmetic that a shader is evaluated in.
///
/// Integers are 32 bits whose sign is a matter of the operation; `signed` says which where the operation does not.
pub trait Domain: Copy + Debug + Send + Sync + 'static {
    /// Stands for an `f32`.
    type Float: Cell;
    /// Stands for an `i32` or `u32`.
    type Int: Cell;
    /// Stands for a `bool`.
    type Truth: Cell;

    /// Whether [`decide`](Self::decide) always answers and [`known`](Self::known) does too.
    const DECIDED: bool;

    /// A constant of the shader.
    fn float(value: f32) -> Self::Float;
    /// A constant of the shader, by its bits.
    fn int(bits: u32) -> Self::Int;
    /// A constant of the shader.
    fn truth(value: bool) -> Self::Truth;

    /// One operand.
    fn float_unary(op: FloatUnary, x: Self::Float) -> Self::Float;
    /// Two operands.
    fn float_binary(op: FloatBinary, a: Self::Float, b: Self::Float) -> Self::Float;
    /// Three operands.
    fn float_ternary(op: FloatTernary, a: Self::Float, b: Self::Float, c: Self::Float) -> Self::Float;
    /// The sum of the products; both slices are of one length, 2 to 4.
    fn dot(a: &[Self::Float], b: &[Self::Float]) -> Self::Float;
    /// The sum of the squares, 2 to 4 of them.
    fn square_sum(x: &[Self::Float]) -> Self::Float {
        Self::dot(x, x)
    }
    /// Compares two floats.
    fn float_comparison(op: FloatComparison, a: Self::Float, b: Self::Float) -> Self::Truth;

    /// One operand.
    fn int_unary(op: IntUnary, x: Self::Int) -> Self::Int;
    /// Two operands.
    fn int_binary(op: IntBinary, a: Self::Int, b: Self::Int) -> Self::Int;
    /// Compares two integers.
    fn int_comparison(op: IntComparison, a: Self::Int, b: Self::Int) -> Self::Truth;

    /// `!x`.
    fn not(x: Self::Truth) -> Self::Truth;
    /// Two operands.
    fn truth_binary(op: TruthBinary, a: Self::Truth, b: Self::Truth) -> Self::Truth;

    /// `f32(x)`: the nearest float.
    fn float_from_int(signed: bool, x: Self::Int) -> Self::Float;
    /// `i32(x)` or `u32(x)`: clamped to the type's range, then truncated.
    fn int_from_float(signed: bool, x: Self::Float) -> Self::Int;
    /// `bitcast<f32>(x)`.
    fn float_from_bits(x: Self::Int) -> Self::Float;
    /// `bitcast<u32>(x)`.
    fn bits_from_float(x: Self::Float) -> Self::Int;
    /// The bits of the half float nearest to x.
    fn half_bits(x: Self::Float) -> Self::Int;
    /// The float of the half float in the low 16 bits.
    fn float_from_half(x: Self::Int) -> Self::Float;
    /// The exponent of `frexp(x)`.
    fn exponent(x: Self::Float) -> Self::Int;
    /// `ldexp(x, exponent)`, the exponent signed.
    fn scale(x: Self::Float, exponent: Self::Int) -> Self::Float;

    /// `accept` where the condition holds, else `reject`; both, joined, where it is open.
    fn select_float(condition: Self::Truth, accept: Self::Float, reject: Self::Float) -> Self::Float;
    /// As [`select_float`](Self::select_float).
    fn select_int(condition: Self::Truth, accept: Self::Int, reject: Self::Int) -> Self::Int;
    /// As [`select_float`](Self::select_float).
    fn select_truth(condition: Self::Truth, accept: Self::Truth, reject: Self::Truth) -> Self::Truth;

    /// The truth of a condition, if the domain knows it.
    fn decide(condition: Self::Truth) -> Option<bool>;
    /// The value of an integer, if the domain knows it.
    fn known(x: Self::Int) -> Option<u32>;
    /// The values that an integer may have, if they are few: at least one, ascending.
    fn candidates(x: Self::Int) -> Option<Vec<u32>>;

    /// A condition that is open. Asked of abstract domains only, as the next two.
    fn undecided() -> Self::Truth {
        Self::Truth::default()
    }
    /// A float of which nothing is known.
    fn any_float() -> Self::Float {
        Self::Float::default()
    }
    /// An integer of which nothing is known.
    fn any_int() -> Self::Int {
        Self::Int::default()
    }

    /// A filtered read; `None` if the host knows no such texture.
    fn sample(textures: &dyn Textures, sample: &Sample<Self::Float, Self::Int>) -> Option<[Self::Float; 4]>;
    /// A texel of a float texture; `None` if the host knows no such texture.
    fn load(textures: &dyn Textures, load: &Load<Self::Int>) -> Option<[Self::Float; 4]>;
    /// A texel of an integer texture; `None` if the host knows no such texture.
    fn load_int(textures: &dyn Textures, load: &Load<Self::Int>) -> Option<[Self::Int; 4]>;
}
