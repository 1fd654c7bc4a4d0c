//! Runs programs on lanes.

mod active;
mod call;
mod compute;
mod count;
mod flow;
mod frame;
mod joined;
mod lane;
mod repeat;
mod texture;
mod transfer;

use self::frame::Frame;
use self::lane::View;
use super::Machine;
use super::count::Counts;
use super::domain::{Cell, Domain};
use super::error::MachineError;
use super::program::{Bank, Program, Register};
use super::texture::Textures;
use super::value::{Component, Value};

/// One call from the host, on one thread.
pub(super) struct Run<'a, D: Domain> {
    machine: &'a Machine<'a>,
    textures: &'a dyn Textures,
    /// Frames that are not in use, by function.
    frames: Vec<Option<Frame<D>>>,
    pub(super) counts: Counts,
}

impl<'a, D: Domain> Run<'a, D> {
    pub(super) fn new(machine: &'a Machine<'a>) -> Self {
        Self {
            machine,
            textures: machine.textures,
            frames: machine.programs.iter().map(|_| None).collect(),
            counts: Counts::default(),
        }
    }

    /// Calls a function on `points`, and appends its results to `out`, which has a component for each scalar.
    pub(super) fn chunk(
        &mut self,
        function: usize,
        arguments: &[Value<D>],
        points: std::ops::Range<usize>,
        out: &mut Value<D>,
    ) -> Result<(), MachineError> {
        let program = self.program(function)?;
        let mut frame = self.enter(function, program, points.len());
        let components = arguments.iter().flat_map(|argument| &argument.components);
        for (component, register) in components.zip(program.parameters.iter().flatten()) {
            set(&mut frame, *register, component, &points);
        }
        self.body(&mut frame)?;
        for (register, component) in program.results.iter().zip(&mut out.components) {
            append(&frame, *register, component);
        }
        self.leave(function, frame);
        Ok(())
    }

    fn program(&self, function: usize) -> Result<&'a Program, MachineError> {
        self.machine.programs[function].as_ref().map_err(Clone::clone)
    }

    fn enter(&mut self, function: usize, program: &Program, lanes: usize) -> Frame<D> {
        let mut frame = self.frames[function].take().unwrap_or_else(|| {
            let mut frame = Frame::new(function, program);
            for (register, global) in &program.globals {
                frame.handles[register.index as usize] = self.machine.bindings[*global];
            }
            frame
        });
        frame.lanes = lanes;
        frame
    }

    fn leave(&mut self, function: usize, frame: Frame<D>) {
        self.frames[function] = Some(frame);
    }

    fn name(&self, frame: &Frame<D>) -> &str {
        self.machine.programs[frame.function].as_ref().map_or("", |program| &program.name)
    }

    fn results(&self, frame: &Frame<D>) -> &'a [Register] {
        self.machine.programs[frame.function].as_ref().map_or(&[], |program| &program.results)
    }
}

fn set<D: Domain>(frame: &mut Frame<D>, register: Register, component: &Component<D>, points: &std::ops::Range<usize>) {
    let index = register.index as usize;
    match component {
        Component::Float(values) => frame.floats[index].copy(part(values, points)),
        Component::Int(values) => frame.ints[index].copy(part(values, points)),
        Component::Truth(values) => frame.truths[index].copy(part(values, points)),
        Component::Handle(id) => frame.handles[index] = *id,
    }
}

fn part<'a, T: Cell>(values: &'a [T], points: &std::ops::Range<usize>) -> View<'a, T> {
    match values {
        [value] => View::One(*value),
        _ => View::Many(&values[points.clone()]),
    }
}

fn append<D: Domain>(frame: &Frame<D>, register: Register, component: &mut Component<D>) {
    match component {
        Component::Float(values) => extend(values, frame.float(register.index), frame.lanes),
        Component::Int(values) => extend(values, frame.int(register.index), frame.lanes),
        Component::Truth(values) => extend(values, frame.truth(register.index), frame.lanes),
        Component::Handle(_) => {}
    }
}

fn extend<T: Cell>(values: &mut Vec<T>, view: View<'_, T>, lanes: usize) {
    match view {
        View::One(value) => values.extend(std::iter::repeat_n(value, lanes)),
        View::Many(lanes) => values.extend_from_slice(lanes),
    }
}

/// An empty value of a function's result type.
pub(super) fn empty<D: Domain>(program: &Program) -> Value<D> {
    let component = |register: &Register| match register.bank {
        Bank::Float => Component::Float(Vec::new()),
        Bank::Int => Component::Int(Vec::new()),
        Bank::Truth => Component::Truth(Vec::new()),
        Bank::Handle => Component::Handle(0),
    };
    Value { components: program.results.iter().map(component).collect() }
}
