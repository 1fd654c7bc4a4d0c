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
        let slot = |frame: &mut Frame<D>, place: usize, join: bool| {
            let slot = &mut B::lanes_mut(frame)[to.table[place + part].index as usize].spread(lanes)[lane];
            *slot = if join { B::join(*slot, value) } else { value };
        };
        match place(to, frame, lane) {
            Some(place) => slot(frame, place, false),
            None => places(to, frame, lane).into_iter().for_each(|place| slot(frame, place, true)),
        }
    });
}

/// Loads a scalar of an element known at run time.
pub(super) fn load_element<D: Domain, B: InBank<D>>(frame: &mut Frame<D>, active: &Active, to: u32, from: &Element) {
    let lanes = frame.lanes;
    let mut out = std::mem::take(&mut B::lanes_mut(frame)[to as usize]);
    let slots = out.overwrite(lanes);
    active.each(|lane| {
        let value = |place: usize| B::lanes(frame)[from.table[place].index as usize].view(lanes).at(lane);
        slots[lane] = match place(from, frame, lane) {
            Some(place) => value(place),
            None => {
                let places = places(from, frame, lane);
                places[1..].iter().fold(value(places[0]), |joined, place| B::join(joined, value(*place)))
            }
        };
    });
    B::lanes_mut(frame)[to as usize] = out;
}

/// The number in the table of the element's first scalar, for one lane, if the domain knows it.
fn place<D: Domain>(element: &Element, frame: &Frame<D>, lane: usize) -> Option<usize> {
    let mut place = element.offset;
    for term in &element.terms {
        place += D::known(frame.int(term.index).at(lane))?.min(term.count - 1) * term.stride;
    }
    Some(place as usize)
}

/// All that it may be: at least one.
fn places<D: Domain>(element: &Element, frame: &Frame<D>, lane: usize) -> Vec<usize> {
    let mut places = vec![element.offset as usize];
    for term in &element.terms {
        let index = frame.int(term.index).at(lane);
        let candidates = D::candidates(index).unwrap_or_else(|| (0..term.count).collect());
        let mut steps: Vec<u32> = candidates.into_iter().map(|index| index.min(term.count - 1) * term.stride).collect();
        steps.dedup();
        places = places.iter().flat_map(|place| steps.iter().map(move |step| place + *step as usize)).collect();
    }
    places
}
