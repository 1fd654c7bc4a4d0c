//! What variables hold where several paths of one lane meet; for domains in which a condition may be open.
//!
//! A lane whose condition is open goes both ways, one after the other, each time from the same state. Every place that
//! paths lead to (the end of a branch, of a loop, of a turn, of the function) collects the states that arrive there.

use super::super::program::{Bank, Register};
use super::frame::{Floats, Frame, InBank, Ints, Truths};
use crate::machine::domain::Domain;
use crate::machine::value::Component;

/// The joined states of some lanes.
#[derive(Debug)]
pub(super) struct Joined<D: Domain> {
    registers: Vec<Register>,
    columns: Vec<Component<D>>,
    /// Which lanes have arrived.
    present: Vec<bool>,
}

impl<D: Domain> Joined<D> {
    /// No state yet, of these variables.
    pub(super) fn new(registers: &[Register], lanes: usize) -> Self {
        if D::DECIDED {
            return Self { registers: Vec::new(), columns: Vec::new(), present: Vec::new() };
        }
        let column = |register: &Register| match register.bank {
            Bank::Float => Component::Float(vec![D::Float::default(); lanes]),
            Bank::Int => Component::Int(vec![D::Int::default(); lanes]),
            Bank::Truth => Component::Truth(vec![D::Truth::default(); lanes]),
            Bank::Handle => Component::Handle(0),
        };
        let columns = registers.iter().map(column).collect();
        Self { registers: registers.to_vec(), columns, present: vec![false; lanes] }
    }

    /// Whether a state of the lane has arrived.
    pub(super) fn has(&self, lane: u32) -> bool {
        self.present[lane as usize]
    }

    /// The present state of these lanes arrives.
    pub(super) fn add(&mut self, frame: &Frame<D>, lanes: &[u32]) {
        for (register, column) in self.registers.iter().zip(&mut self.columns) {
            let at = (register.index, &self.present[..], lanes);
            match column {
                Component::Float(values) => add::<D, Floats>(frame, at, values),
                Component::Int(values) => add::<D, Ints>(frame, at, values),
                Component::Truth(values) => add::<D, Truths>(frame, at, values),
                Component::Handle(_) => {}
            }
        }
        lanes.iter().for_each(|lane| self.present[*lane as usize] = true);
    }

    /// A state of which nothing is known arrives.
    pub(super) fn widen(&mut self, lanes: &[u32]) {
        for column in &mut self.columns {
            match column {
                Component::Float(values) => lanes.iter().for_each(|lane| values[*lane as usize] = D::any_float()),
                Component::Int(values) => lanes.iter().for_each(|lane| values[*lane as usize] = D::any_int()),
                Component::Truth(values) => lanes.iter().for_each(|lane| values[*lane as usize] = D::undecided()),
                Component::Handle(_) => {}
            }
        }
        lanes.iter().for_each(|lane| self.present[*lane as usize] = true);
    }

    /// Gives the variables of all lanes that have arrived their joined state.
    pub(super) fn write(&self, frame: &mut Frame<D>) {
        for (register, column) in self.registers.iter().zip(&self.columns) {
            match column {
                Component::Float(values) => write::<D, Floats>(frame, register.index, &self.present, values),
                Component::Int(values) => write::<D, Ints>(frame, register.index, &self.present, values),
                Component::Truth(values) => write::<D, Truths>(frame, register.index, &self.present, values),
                Component::Handle(_) => {}
            }
        }
    }
}

fn add<D: Domain, B: InBank<D>>(
    frame: &Frame<D>,
    (register, present, lanes): (u32, &[bool], &[u32]),
    values: &mut [B::Item],
) {
    let now = B::lanes(frame)[register as usize].view(frame.lanes);
    for lane in lanes.iter().map(|lane| *lane as usize) {
        let value = now.at(lane);
        values[lane] = if present[lane] { B::join(values[lane], value) } else { value };
    }
}

fn write<D: Domain, B: InBank<D>>(frame: &mut Frame<D>, register: u32, present: &[bool], values: &[B::Item]) {
    let lanes = frame.lanes;
    if !present.contains(&true) {
        return;
    }
    let slots = B::lanes_mut(frame)[register as usize].spread(lanes);
    for ((slot, value), present) in slots.iter_mut().zip(values).zip(present) {
        if *present {
            *slot = *value;
        }
    }
}
