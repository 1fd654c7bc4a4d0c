//! Statements: which lanes go where.

use super::super::program::{Call, Case, Register, Step};
use super::Run;
use super::active::Active;
use super::frame::{Frame, Scope};
use super::transfer::{gather, scatter, store_element};
use crate::machine::domain::Domain;
use crate::machine::error::MachineError;

type Result<T> = std::result::Result<T, MachineError>;

impl<D: Domain> Run<'_, D> {
    /// Runs the steps; gives the lanes that reach their end.
    pub(super) fn steps(&mut self, frame: &mut Frame<D>, steps: &[Step], active: Active) -> Result<Active> {
        let mut active = active;
        for step in steps {
            if active.is_empty() {
                break;
            }
            active = self.step(frame, step, active)?;
        }
        Ok(active)
    }

    fn step(&mut self, frame: &mut Frame<D>, step: &Step, active: Active) -> Result<Active> {
        match step {
            Step::Compute(instructions) => {
                for instruction in instructions {
                    self.count(instruction, active.count());
                    self.compute(frame, instruction, &active)?;
                }
                Ok(active)
            }
            Step::Store { to, from } => {
                store(frame, &active, to, from);
                Ok(active)
            }
            Step::StoreElement { to, from } => {
                store_element(frame, &active, to, from);
                Ok(active)
            }
            Step::Block(steps) => self.steps(frame, steps, active),
            Step::If { condition, accept, reject } => self.branch(frame, *condition, accept, reject, active),
            Step::Switch { selector, cases } => self.switch(frame, *selector, cases, active),
            Step::Loop { body, continuing, break_if } => self.repeat(frame, body, continuing, *break_if, active),
            Step::Break => {
                if let Some(scope) = frame.scopes.last_mut() {
                    scope.broken.extend(active.into_list());
                }
                Ok(Active::none(frame.lanes))
            }
            Step::Continue => {
                if let Some(scope) = frame.scopes.iter_mut().rev().find(|scope| scope.is_loop) {
                    scope.continued.extend(active.into_list());
                }
                Ok(Active::none(frame.lanes))
            }
            Step::Return { values } => {
                let results = self.results(frame);
                store(frame, &active, results, values);
                Ok(Active::none(frame.lanes))
            }
            Step::Call(call) => {
                self.call(frame, call, &active)?;
                Ok(active)
            }
        }
    }

    fn branch(
        &mut self,
        frame: &mut Frame<D>,
        condition: u32,
        accept: &[Step],
        reject: &[Step],
        active: Active,
    ) -> Result<Active> {
        self.counts.branches += active.count() as u64;
        let (accepted, rejected) = self.split(frame, condition, active);
        let accepted = self.steps(frame, accept, accepted)?;
        let rejected = self.steps(frame, reject, rejected)?;
        Ok(accepted.union(rejected))
    }

    /// The lanes where the condition holds, and those where it does not.
    fn split(&mut self, frame: &Frame<D>, condition: u32, active: Active) -> (Active, Active) {
        let condition = frame.truth(condition);
        let holds = |lane| D::decide(condition.at(lane)).unwrap_or(true);
        if let super::lane::View::One(_) = condition {
            let none = Active::none(frame.lanes);
            return if holds(0) { (active, none) } else { (none, active) };
        }
        let (mut accepted, mut rejected) = (Vec::new(), Vec::new());
        active.each(|lane| if holds(lane) { &mut accepted } else { &mut rejected }.push(lane as u32));
        (Active::some(frame.lanes, accepted), Active::some(frame.lanes, rejected))
    }

    fn switch(&mut self, frame: &mut Frame<D>, selector: u32, cases: &[Case], active: Active) -> Result<Active> {
        self.counts.branches += active.count() as u64;
        let default = cases.iter().position(|case| case.default);
        let mut chosen = vec![Vec::new(); cases.len()];
        let selector = frame.int(selector);
        active.each(|lane| {
            let value = D::known(selector.at(lane)).unwrap_or(0);
            let case = cases.iter().position(|case| case.values.contains(&value)).or(default);
            if let Some(case) = case {
                chosen[case].push(lane as u32);
            }
        });
        frame.scopes.push(Scope::default());
        let mut end = Active::none(frame.lanes);
        for (case, list) in cases.iter().zip(chosen) {
            let active = Active::some(frame.lanes, list);
            end = end.union(self.steps(frame, &case.body, active)?);
        }
        let scope = frame.scopes.pop().unwrap_or_default();
        Ok(end.union(arrived(frame.lanes, scope.broken)))
    }

    fn repeat(
        &mut self,
        frame: &mut Frame<D>,
        body: &[Step],
        continuing: &[Step],
        break_if: Option<u32>,
        active: Active,
    ) -> Result<Active> {
        let mut active = active;
        let mut end = Active::none(frame.lanes);
        let mut iterations = 0;
        while !active.is_empty() {
            if iterations == self.machine.iteration_limit {
                let function = self.name(frame).to_owned();
                return Err(MachineError::Endless { function, iterations });
            }
            iterations += 1;
            self.counts.iterations += active.count() as u64;
            frame.scopes.push(Scope { is_loop: true, ..Scope::default() });
            active = self.steps(frame, body, active)?;
            let scope = frame.scopes.pop().unwrap_or_default();
            end = end.union(arrived(frame.lanes, scope.broken));
            active = active.union(arrived(frame.lanes, scope.continued));
            active = self.steps(frame, continuing, active)?;
            if let Some(condition) = break_if {
                let (broken, rest) = self.split(frame, condition, active);
                end = end.union(broken);
                active = rest;
            }
        }
        Ok(end)
    }

    fn call(&mut self, frame: &mut Frame<D>, call: &Call, active: &Active) -> Result<()> {
        self.counts.calls += active.count() as u64;
        let program = self.program(call.function)?;
        let mut inner = self.enter(call.function, program, active.count());
        for (from, to) in call.arguments.iter().zip(program.parameters.iter().flatten()) {
            gather(frame, *from, &mut inner, *to, active);
        }
        self.steps(&mut inner, &program.body, Active::all(active.count()))?;
        let results = program.results.iter().zip(&call.results);
        for (from, to) in results.chain(call.returned.iter().map(|(from, to)| (from, to))) {
            scatter(&inner, *from, frame, *to, active);
        }
        self.leave(call.function, inner);
        Ok(())
    }
}

/// Lanes that were collected one group after another.
fn arrived(lanes: usize, mut list: Vec<u32>) -> Active {
    list.sort_unstable();
    Active::some(lanes, list)
}

fn store<D: Domain>(frame: &mut Frame<D>, active: &Active, to: &[Register], from: &[Register]) {
    for (to, from) in to.iter().zip(from) {
        frame.store(active, *to, *from);
    }
}
