//! Loops: a turn at a time, until the last lane has left.

use super::super::program::{Register, Step};
use super::Run;
use super::active::Active;
use super::flow::{Result, split};
use super::frame::{Frame, Scope};
use super::joined::Joined;
use crate::machine::domain::Domain;
use crate::machine::error::MachineError;

/// After so many turns, a lane that may have left is taken to be in any state: its condition may stay open for ever.
const OPEN_TURNS: u32 = 1024;

/// The lanes that have left a loop, and their state.
struct Exit<D: Domain> {
    lanes: Vec<u32>,
    state: Joined<D>,
}

impl<D: Domain> Run<'_, D> {
    pub(super) fn repeat(
        &mut self,
        frame: &mut Frame<D>,
        [body, continuing]: [&[Step]; 2],
        break_if: Option<u32>,
        stored: &[Register],
        active: Active,
    ) -> Result<Active> {
        let mut active = active;
        let mut exit = Exit { lanes: Vec::new(), state: Joined::new(stored, frame.lanes) };
        let mut turns = 0;
        while !active.is_empty() {
            if turns == self.machine.iteration_limit {
                return Err(MachineError::Endless { function: self.name(frame).to_owned(), iterations: turns });
            }
            turns += 1;
            self.counts.iterations += active.count() as u64;
            active = self.turn(frame, [body, continuing], stored, active, &mut exit)?;
            if let Some(condition) = break_if {
                let (broken, rest) = split(frame, condition, active);
                exit.arrive(frame, broken);
                active = rest;
            }
            if !D::DECIDED && turns >= OPEN_TURNS {
                active = self.give_up(frame, active, &mut exit);
            }
        }
        Ok(Active::none(frame.lanes).union_at(Some((exit.lanes, exit.state)), frame))
    }

    /// The body and the continuing block, once.
    fn turn(
        &mut self,
        frame: &mut Frame<D>,
        [body, continuing]: [&[Step]; 2],
        stored: &[Register],
        active: Active,
        exit: &mut Exit<D>,
    ) -> Result<Active> {
        let mut scope = Scope::new(true, stored, frame.lanes);
        std::mem::swap(&mut scope.at_break, &mut exit.state);
        std::mem::swap(&mut scope.broken, &mut exit.lanes);
        frame.scopes.push(scope);
        let rest = self.steps(frame, body, active)?;
        let Some(scope) = frame.scopes.pop() else { unreachable!("pushed above, and every step pops what it pushes") };
        (exit.lanes, exit.state) = (scope.broken, scope.at_break);
        let active = rest.union_at(Some((scope.continued, scope.at_continue)), frame);
        self.steps(frame, continuing, active)
    }

    /// Lets lanes go that may have left long ago.
    fn give_up(&mut self, frame: &mut Frame<D>, active: Active, exit: &mut Exit<D>) -> Active {
        let lanes = active.into_list();
        let (open, rest): (Vec<u32>, Vec<u32>) =
            lanes.into_iter().partition(|lane| exit.state.has(*lane) || frame.returned[*lane as usize]);
        exit.state.widen(&open);
        exit.lanes.extend(&open);
        self.widen_results(frame, &open);
        Active::some(frame.lanes, rest)
    }
}

impl<D: Domain> Exit<D> {
    fn arrive(&mut self, frame: &Frame<D>, lanes: Active) {
        let lanes = lanes.into_list();
        if !D::DECIDED {
            self.state.add(frame, &lanes);
        }
        self.lanes.extend(lanes);
    }
}
