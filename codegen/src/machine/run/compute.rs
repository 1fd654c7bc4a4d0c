//! One instruction on all active lanes.

use std::mem::take;

use super::super::program::{Bank, Conversion, Instruction};
use super::Run;
use super::active::Active;
use super::frame::{Floats, Frame, InBank, Ints, Truths};
use super::lane::{Lane, View, map1, map2, map3};
use super::transfer::load_element;
use crate::machine::domain::{
    Cell, Domain, FloatBinary, FloatComparison, FloatTernary, FloatUnary, IntBinary, IntComparison, IntUnary,
    TruthBinary, each_float_binary, each_float_comparison, each_float_ternary, each_float_unary, each_int_binary,
    each_int_comparison, each_int_unary, each_truth_binary,
};
use crate::machine::error::MachineError;

impl<D: Domain> Run<'_, D> {
    pub(super) fn compute(
        &mut self,
        frame: &mut Frame<D>,
        instruction: &Instruction,
        active: &Active,
    ) -> Result<(), MachineError> {
        match instruction {
            Instruction::Copy { bank, to, from } => copy(frame, *bank, *to, *from),
            Instruction::FloatUnary { op, to, x } => float_unary(frame, active, *op, *to, *x),
            Instruction::FloatBinary { op, to, a, b } => float_binary(frame, active, *op, *to, [*a, *b]),
            Instruction::FloatTernary { op, to, a, b, c } => float_ternary(frame, active, *op, *to, [*a, *b, *c]),
            Instruction::FloatComparison { op, to, a, b } => float_comparison(frame, active, *op, *to, [*a, *b]),
            Instruction::Dot { to, a, b } => dot(frame, active, *to, a, b),
            Instruction::SquareSum { to, x } => square_sum(frame, active, *to, x),
            Instruction::IntUnary { op, to, x } => int_unary(frame, active, *op, *to, *x),
            Instruction::IntBinary { op, to, a, b } => int_binary(frame, active, *op, *to, [*a, *b]),
            Instruction::IntComparison { op, to, a, b } => int_comparison(frame, active, *op, *to, [*a, *b]),
            Instruction::Not { to, x } => {
                let mut out = take(&mut frame.truths[*to as usize]);
                map1(active, frame.truth(*x), &mut out, D::not);
                frame.truths[*to as usize] = out;
            }
            Instruction::TruthBinary { op, to, a, b } => truth_binary(frame, active, *op, *to, [*a, *b]),
            Instruction::Select { bank, to, condition, accept, reject } => match bank {
                Bank::Float => select::<D, Floats>(frame, active, *to, *condition, [*accept, *reject]),
                Bank::Int => select::<D, Ints>(frame, active, *to, *condition, [*accept, *reject]),
                Bank::Truth => select::<D, Truths>(frame, active, *to, *condition, [*accept, *reject]),
                Bank::Handle => {}
            },
            Instruction::Convert { op, to, x } => convert(frame, active, *op, *to, *x),
            Instruction::Scale { to, x, exponent } => {
                let mut out = take(&mut frame.floats[*to as usize]);
                map2(active, frame.float(*x), frame.int(*exponent), &mut out, D::scale);
                frame.floats[*to as usize] = out;
            }
            Instruction::Element { bank, to, from } => match bank {
                Bank::Float => load_element::<D, Floats>(frame, active, *to, from),
                Bank::Int => load_element::<D, Ints>(frame, active, *to, from),
                Bank::Truth => load_element::<D, Truths>(frame, active, *to, from),
                Bank::Handle => {}
            },
            Instruction::Sample(sample) => self.sample(frame, active, sample)?,
            Instruction::Load(load) => self.load(frame, active, load)?,
            Instruction::Size { to, texture, level } => self.size(frame, active, *to, *texture, *level)?,
            Instruction::Layers { to, texture } => self.layers(frame, *to, *texture)?,
            Instruction::Levels { to, texture } => self.levels(frame, *to, *texture)?,
        }
        Ok(())
    }
}

fn copy<D: Domain>(frame: &mut Frame<D>, bank: Bank, to: u32, from: u32) {
    let all = Active::all(frame.lanes);
    let register = |index| super::super::program::Register { bank, index };
    frame.store(&all, register(to), register(from));
}

fn float_unary<D: Domain>(frame: &mut Frame<D>, active: &Active, op: FloatUnary, to: u32, x: u32) {
    let mut out = take(&mut frame.floats[to as usize]);
    let x = frame.float(x);
    each_float_unary!(op, OP => map1(active, x, &mut out, |x| D::float_unary(OP, x)));
    frame.floats[to as usize] = out;
}

fn float_binary<D: Domain>(frame: &mut Frame<D>, active: &Active, op: FloatBinary, to: u32, [a, b]: [u32; 2]) {
    let mut out = take(&mut frame.floats[to as usize]);
    let (a, b) = (frame.float(a), frame.float(b));
    each_float_binary!(op, OP => map2(active, a, b, &mut out, |a, b| D::float_binary(OP, a, b)));
    frame.floats[to as usize] = out;
}

fn float_ternary<D: Domain>(frame: &mut Frame<D>, active: &Active, op: FloatTernary, to: u32, [a, b, c]: [u32; 3]) {
    let mut out = take(&mut frame.floats[to as usize]);
    let operands = (frame.float(a), frame.float(b), frame.float(c));
    each_float_ternary!(op, OP => map3(active, operands, &mut out, |a, b, c| D::float_ternary(OP, a, b, c)));
    frame.floats[to as usize] = out;
}

fn float_comparison<D: Domain>(frame: &mut Frame<D>, active: &Active, op: FloatComparison, to: u32, [a, b]: [u32; 2]) {
    let mut out = take(&mut frame.truths[to as usize]);
    let (a, b) = (frame.float(a), frame.float(b));
    each_float_comparison!(op, OP => map2(active, a, b, &mut out, |a, b| D::float_comparison(OP, a, b)));
    frame.truths[to as usize] = out;
}

fn dot<D: Domain>(frame: &mut Frame<D>, active: &Active, to: u32, a: &[u32], b: &[u32]) {
    let mut out = take(&mut frame.floats[to as usize]);
    let at = |i: usize| (frame.float(a[i]), frame.float(b[i]));
    match a.len() {
        2 => dot_of(active, [at(0), at(1)], &mut out, D::dot),
        3 => dot_of(active, [at(0), at(1), at(2)], &mut out, D::dot),
        _ => dot_of(active, [at(0), at(1), at(2), at(3)], &mut out, D::dot),
    }
    frame.floats[to as usize] = out;
}

fn square_sum<D: Domain>(frame: &mut Frame<D>, active: &Active, to: u32, x: &[u32]) {
    let mut out = take(&mut frame.floats[to as usize]);
    let at = |i: usize| (frame.float(x[i]), View::One(D::Float::default()));
    let of = |x: &[D::Float], _: &[D::Float]| D::square_sum(x);
    match x.len() {
        2 => dot_of(active, [at(0), at(1)], &mut out, of),
        3 => dot_of(active, [at(0), at(1), at(2)], &mut out, of),
        _ => dot_of(active, [at(0), at(1), at(2), at(3)], &mut out, of),
    }
    frame.floats[to as usize] = out;
}

#[inline(always)]
fn dot_of<T: Cell, const N: usize>(
    active: &Active,
    pairs: [(View<'_, T>, View<'_, T>); N],
    out: &mut Lane<T>,
    f: impl Fn(&[T], &[T]) -> T,
) {
    let value = |lane| f(&pairs.map(|(a, _)| a.at(lane)), &pairs.map(|(_, b)| b.at(lane)));
    if pairs.iter().all(|pair| matches!(pair, (View::One(_), View::One(_)))) {
        return out.set(value(0));
    }
    let out = out.overwrite(active.lanes());
    active.each(|lane| out[lane] = value(lane));
}

fn int_unary<D: Domain>(frame: &mut Frame<D>, active: &Active, op: IntUnary, to: u32, x: u32) {
    let mut out = take(&mut frame.ints[to as usize]);
    let x = frame.int(x);
    each_int_unary!(op, OP => map1(active, x, &mut out, |x| D::int_unary(OP, x)));
    frame.ints[to as usize] = out;
}

fn int_binary<D: Domain>(frame: &mut Frame<D>, active: &Active, op: IntBinary, to: u32, [a, b]: [u32; 2]) {
    let mut out = take(&mut frame.ints[to as usize]);
    let (a, b) = (frame.int(a), frame.int(b));
    each_int_binary!(op, OP => map2(active, a, b, &mut out, |a, b| D::int_binary(OP, a, b)));
    frame.ints[to as usize] = out;
}

fn int_comparison<D: Domain>(frame: &mut Frame<D>, active: &Active, op: IntComparison, to: u32, [a, b]: [u32; 2]) {
    let mut out = take(&mut frame.truths[to as usize]);
    let (a, b) = (frame.int(a), frame.int(b));
    each_int_comparison!(op, OP => map2(active, a, b, &mut out, |a, b| D::int_comparison(OP, a, b)));
    frame.truths[to as usize] = out;
}

fn truth_binary<D: Domain>(frame: &mut Frame<D>, active: &Active, op: TruthBinary, to: u32, [a, b]: [u32; 2]) {
    let mut out = take(&mut frame.truths[to as usize]);
    let (a, b) = (frame.truth(a), frame.truth(b));
    each_truth_binary!(op, OP => map2(active, a, b, &mut out, |a, b| D::truth_binary(OP, a, b)));
    frame.truths[to as usize] = out;
}

fn select<D: Domain, B: InBank<D>>(
    frame: &mut Frame<D>,
    active: &Active,
    to: u32,
    condition: u32,
    [accept, reject]: [u32; 2],
) {
    let lanes = frame.lanes;
    let mut out = take(&mut B::lanes_mut(frame)[to as usize]);
    let side = |index: u32| B::lanes(frame)[index as usize].view(lanes);
    map3(active, (frame.truth(condition), side(accept), side(reject)), &mut out, B::select);
    B::lanes_mut(frame)[to as usize] = out;
}

fn convert<D: Domain>(frame: &mut Frame<D>, active: &Active, op: Conversion, to: u32, x: u32) {
    let to = to as usize;
    match op {
        Conversion::FloatFromSigned => from_int(frame, active, to, x, |x| D::float_from_int(true, x)),
        Conversion::FloatFromUnsigned => from_int(frame, active, to, x, |x| D::float_from_int(false, x)),
        Conversion::FloatFromBits => from_int(frame, active, to, x, D::float_from_bits),
        Conversion::FloatFromHalf => from_int(frame, active, to, x, D::float_from_half),
        Conversion::SignedFromFloat => from_float(frame, active, to, x, |x| D::int_from_float(true, x)),
        Conversion::UnsignedFromFloat => from_float(frame, active, to, x, |x| D::int_from_float(false, x)),
        Conversion::BitsFromFloat => from_float(frame, active, to, x, D::bits_from_float),
        Conversion::HalfBits => from_float(frame, active, to, x, D::half_bits),
        Conversion::Exponent => from_float(frame, active, to, x, D::exponent),
    }
}

fn from_int<D: Domain>(frame: &mut Frame<D>, active: &Active, to: usize, x: u32, f: impl Fn(D::Int) -> D::Float) {
    let mut out = take(&mut frame.floats[to]);
    map1(active, frame.int(x), &mut out, f);
    frame.floats[to] = out;
}

fn from_float<D: Domain>(frame: &mut Frame<D>, active: &Active, to: usize, x: u32, f: impl Fn(D::Float) -> D::Int) {
    let mut out = take(&mut frame.ints[to]);
    map1(active, frame.float(x), &mut out, f);
    frame.ints[to] = out;
}
