//! Calls, and what a function leaves behind.

use super::super::program::{Bank, Call};
use super::Run;
use super::active::Active;
use super::flow::Result;
use super::frame::Frame;
use super::joined::Joined;
use super::transfer::{gather, scatter};
use crate::machine::domain::Domain;

impl<D: Domain> Run<'_, D> {
    pub(super) fn call(&mut self, frame: &mut Frame<D>, call: &Call, active: &Active) -> Result<()> {
        self.counts.calls += active.count() as u64;
        let program = self.program(call.function)?;
        let mut inner = self.enter(call.function, program, active.count());
        for (from, to) in call.arguments.iter().zip(program.parameters.iter().flatten()) {
            gather(frame, *from, &mut inner, *to, active);
        }
        self.body(&mut inner)?;
        let results = program.results.iter().zip(&call.results);
        for (from, to) in results.chain(call.returned.iter().map(|(from, to)| (from, to))) {
            scatter(&inner, *from, frame, *to, active);
        }
        self.leave(call.function, inner);
        Ok(())
    }

    /// Runs a function whose parameters are set.
    pub(super) fn body(&mut self, frame: &mut Frame<D>) -> Result<()> {
        let program = self.program(frame.function)?;
        if !D::DECIDED {
            frame.at_return = Joined::new(&program.outliving, frame.lanes);
            frame.returned = vec![false; frame.lanes];
        }
        let rest = self.steps(frame, &program.body, Active::all(frame.lanes))?;
        if !D::DECIDED {
            self.depart(frame, rest);
            let state = std::mem::replace(&mut frame.at_return, Joined::new(&[], 0));
            state.write(frame);
        }
        Ok(())
    }

    /// Lanes of which nothing is known may have returned anything.
    pub(super) fn widen_results(&mut self, frame: &mut Frame<D>, lanes: &[u32]) {
        let count = frame.lanes;
        for register in self.results(frame) {
            let index = register.index as usize;
            let lanes = lanes.iter().map(|lane| *lane as usize);
            match register.bank {
                Bank::Float => {
                    let slots = frame.floats[index].spread(count);
                    lanes.for_each(|lane| slots[lane] = D::any_float());
                }
                Bank::Int => {
                    let slots = frame.ints[index].spread(count);
                    lanes.for_each(|lane| slots[lane] = D::any_int());
                }
                Bank::Truth => {
                    let slots = frame.truths[index].spread(count);
                    lanes.for_each(|lane| slots[lane] = D::undecided());
                }
                Bank::Handle => {}
            }
        }
        frame.at_return.widen(lanes);
        lanes.iter().for_each(|lane| frame.returned[*lane as usize] = true);
    }
}
