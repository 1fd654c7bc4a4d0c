//! The registers of one function. WGSL has no recursion, so each function needs one frame only.

use super::super::program::{Bank, Program, Register};
use super::active::Active;
use super::joined::Joined;
use super::lane::{Lane, View};
use crate::machine::domain::{Cell, Domain};

/// Registers, and the structures that `break` and `continue` leave.
#[derive(Debug)]
pub(super) struct Frame<D: Domain> {
    /// Index of the function in the machine's programs.
    pub(super) function: usize,
    pub(super) floats: Vec<Lane<D::Float>>,
    pub(super) ints: Vec<Lane<D::Int>>,
    pub(super) truths: Vec<Lane<D::Truth>>,
    pub(super) handles: Vec<u32>,
    pub(super) lanes: usize,
    pub(super) scopes: Vec<Scope<D>>,
    /// The variables that outlive the call, where it returns.
    pub(super) at_return: Joined<D>,
    /// Which lanes have a result already; for abstract domains.
    pub(super) returned: Vec<bool>,
}

/// An enclosing loop or switch, and the lanes that wait for its end.
#[derive(Debug)]
pub(super) struct Scope<D: Domain> {
    pub(super) is_loop: bool,
    pub(super) broken: Vec<u32>,
    pub(super) continued: Vec<u32>,
    /// The variables at `break`.
    pub(super) at_break: Joined<D>,
    /// The variables at `continue`.
    pub(super) at_continue: Joined<D>,
}

impl<D: Domain> Scope<D> {
    /// A loop or switch that stores to these variables.
    pub(super) fn new(is_loop: bool, stored: &[Register], lanes: usize) -> Self {
        Self {
            is_loop,
            broken: Vec::new(),
            continued: Vec::new(),
            at_break: Joined::new(stored, lanes),
            at_continue: Joined::new(if is_loop { stored } else { &[] }, lanes),
        }
    }
}

impl<D: Domain> Frame<D> {
    /// With the program's constants in place.
    pub(super) fn new(function: usize, program: &Program) -> Self {
        let [floats, ints, truths, handles] = program.registers.map(|count| count as usize);
        let mut frame = Self {
            function,
            floats: vec![Lane::default(); floats],
            ints: vec![Lane::default(); ints],
            truths: vec![Lane::default(); truths],
            handles: vec![0; handles],
            lanes: 0,
            scopes: Vec::new(),
            at_return: Joined::new(&[], 0),
            returned: Vec::new(),
        };
        for (register, bits) in &program.constants {
            match register.bank {
                Bank::Float => {
                    Floats::lanes_mut(&mut frame)[register.index as usize].set(D::float(f32::from_bits(*bits)))
                }
                Bank::Int => Ints::lanes_mut(&mut frame)[register.index as usize].set(D::int(*bits)),
                Bank::Truth => Truths::lanes_mut(&mut frame)[register.index as usize].set(D::truth(*bits != 0)),
                Bank::Handle => {}
            }
        }
        frame
    }

    pub(super) fn float(&self, index: u32) -> View<'_, D::Float> {
        self.floats[index as usize].view(self.lanes)
    }

    pub(super) fn int(&self, index: u32) -> View<'_, D::Int> {
        self.ints[index as usize].view(self.lanes)
    }

    pub(super) fn truth(&self, index: u32) -> View<'_, D::Truth> {
        self.truths[index as usize].view(self.lanes)
    }

    /// Stores a register to a variable where active, beside what lanes have in it that returned before.
    pub(super) fn store_result(&mut self, active: &Active, to: Register, from: Register) {
        match to.bank {
            Bank::Float => self.store_result_in::<Floats>(active, to.index, from.index),
            Bank::Int => self.store_result_in::<Ints>(active, to.index, from.index),
            Bank::Truth => self.store_result_in::<Truths>(active, to.index, from.index),
            Bank::Handle => {}
        }
    }

    fn store_result_in<B: InBank<D>>(&mut self, active: &Active, to: u32, from: u32) {
        let lanes = self.lanes;
        let mut target = std::mem::take(&mut B::lanes_mut(self)[to as usize]);
        let source = B::lanes(self)[from as usize].view(lanes);
        let slots = target.spread(lanes);
        active.each(|lane| {
            let value = source.at(lane);
            slots[lane] = if self.returned[lane] { B::join(slots[lane], value) } else { value };
        });
        B::lanes_mut(self)[to as usize] = target;
    }

    /// Stores a register to a variable where active.
    pub(super) fn store(&mut self, active: &Active, to: Register, from: Register) {
        match to.bank {
            Bank::Float => self.store_in::<Floats>(active, to.index, from.index),
            Bank::Int => self.store_in::<Ints>(active, to.index, from.index),
            Bank::Truth => self.store_in::<Truths>(active, to.index, from.index),
            Bank::Handle => self.handles[to.index as usize] = self.handles[from.index as usize],
        }
    }

    fn store_in<B: InBank<D>>(&mut self, active: &Active, to: u32, from: u32) {
        if to == from {
            return;
        }
        let lanes = self.lanes;
        let mut target = std::mem::take(&mut B::lanes_mut(self)[to as usize]);
        let source = B::lanes(self)[from as usize].view(lanes);
        match active.list() {
            None => target.copy(source),
            Some(list) => {
                let target = target.spread(lanes);
                list.iter().for_each(|lane| target[*lane as usize] = source.at(*lane as usize));
            }
        }
        B::lanes_mut(self)[to as usize] = target;
    }
}

/// The bank of a kind of scalar, and how to choose between two of them.
pub(super) trait InBank<D: Domain> {
    type Item: Cell;
    fn lanes(frame: &Frame<D>) -> &[Lane<Self::Item>];
    fn lanes_mut(frame: &mut Frame<D>) -> &mut [Lane<Self::Item>];
    fn select(condition: D::Truth, accept: Self::Item, reject: Self::Item) -> Self::Item;

    /// What may be either.
    fn join(a: Self::Item, b: Self::Item) -> Self::Item {
        Self::select(D::undecided(), a, b)
    }
}

pub(super) struct Floats;
pub(super) struct Ints;
pub(super) struct Truths;

macro_rules! in_bank {
    ($bank:ident, $item:ident, $field:ident, $select:ident) => {
        impl<D: Domain> InBank<D> for $bank {
            type Item = D::$item;
            fn lanes(frame: &Frame<D>) -> &[Lane<D::$item>] {
                &frame.$field
            }
            fn lanes_mut(frame: &mut Frame<D>) -> &mut [Lane<D::$item>] {
                &mut frame.$field
            }
            #[inline(always)]
            fn select(condition: D::Truth, accept: D::$item, reject: D::$item) -> D::$item {
                D::$select(condition, accept, reject)
            }
        }
    };
}

in_bank!(Floats, Float, floats, select_float);
in_bank!(Ints, Int, ints, select_int);
in_bank!(Truths, Truth, truths, select_truth);
