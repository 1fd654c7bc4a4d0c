//! Scalars from one frame to another: a callee runs on the active lanes only, closed up, so that its loops are dense
//! however few lanes of the caller call it.

use super::super::program::{Bank, Element, Register};
use super::active::Active;
use super::frame::{Floats, Frame, InBank, Ints, Truths};
use super::lane::View;
use crate::machine::domain::Domain;

/// A caller's register to a callee's.
pub(super) fn gather<D: Domain>(
    caller: &Frame<D>,
    from: Register,
    callee: &mut Frame<D>,
    to: Register,
    active: &Active,
) {
    match to.bank {
        Bank::Float => gather_in::<D, Floats>(caller, from, callee, to, active),
        Bank::Int => gather_in::<D, Ints>(caller, from, callee, to, active),
        Bank::Truth => gather_in::<D, Truths>(caller, from, callee, to, active),
        Bank::Handle => callee.handles[to.index as usize] = caller.handles[from.index as usize],
    }
}

fn gather_in<D: Domain, B: InBank<D>>(
    caller: &Frame<D>,
    from: Register,
    callee: &mut Frame<D>,
    to: Register,
    active: &Active,
) {
    let from = B::lanes(caller)[from.index as usize].view(caller.lanes);
    let to = &mut B::lanes_mut(callee)[to.index as usize];
    match (from, active.list()) {
        (View::Many(from), Some(list)) => {
            let to = to.overwrite(list.len());
            to.iter_mut().zip(list).for_each(|(to, lane)| *to = from[*lane as usize]);
        }
        (from, _) => to.copy(from),
    }
}

/// A callee's register to a caller's.
pub(super) fn scatter<D: Domain>(
    callee: &Frame<D>,
    from: Register,
    caller: &mut Frame<D>,
    to: Register,
    active: &Active,
) {
    match to.bank {
        Bank::Float => scatter_in::<D, Floats>(callee, from, caller, to, active),
        Bank::Int => scatter_in::<D, Ints>(callee, from, caller, to, active),
        Bank::Truth => scatter_in::<D, Truths>(callee, from, caller, to, active),
        Bank::Handle => caller.handles[to.index as usize] = callee.handles[from.index as usize],
    }
}

fn scatter_in<D: Domain, B: InBank<D>>(
    callee: &Frame<D>,
    from: Register,
    caller: &mut Frame<D>,
    to: Register,
    active: &Active,
) {
    let from = B::lanes(callee)[from.index as usize].view(callee.lanes);
    let lanes = caller.lanes;
    let to = &mut B::lanes_mut(caller)[to.index as usize];
    match (from, active.list()) {
        (View::Many(from), Some(list)) => {
            let to = to.overwrite(lanes);
            list.iter().zip(from).for_each(|(lane, from)| to[*lane as usize] = *from);
        }
        // The register is the call's own, so that the lanes that did not call do not care for its value.
        (from, _) => to.copy(from),
    }
}

/// Stores to an element known at run time.
pub(super) fn store_element<D: Domain>(frame: &mut Frame<D>, active: &Active, to: &Element, from: &[Register]) {
    for (part, from) in from.iter().enumerate() {
        match from.bank {
            Bank::Float => store_part::<D, Floats>(frame, active, to, part, *from),
            Bank::Int => store_part::<D, Ints>(frame, active, to, part, *from),
            Bank::Truth => store_part::<D, Truths>(frame, active, to, part, *from),
            Bank::Handle => {}
        }
    }
}

fn store_part<D: Domain, B: InBank<D>>(
    frame: &mut Frame<D>,
    active: &Active,
    to: &Element,
    part: usize,
    from: Register,
) {
    let lanes = frame.lanes;
    active.each(|lane| {
        let value = B::lanes(frame)[from.index as usize].view(lanes).at(lane);
        let register = to.table[to.place(frame, lane) + part];
        B::lanes_mut(frame)[register.index as usize].spread(lanes)[lane] = value;
    });
}
