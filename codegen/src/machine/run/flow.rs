//! Statements: which lanes go where.

use super::super::program::{Case, Register, Step};
use super::Run;
use super::active::Active;
use super::frame::{Frame, Scope};
use super::joined::Joined;
use super::transfer::store_element;
use crate::machine::domain::Domain;
use crate::machine::error::MachineError;

pub(super) type Result<T> = std::result::Result<T, MachineError>;

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
            }
            Step::Store { to, from } => {
                to.iter().zip(from).for_each(|(to, from)| frame.store(&active, *to, *from));
            }
            Step::StoreElement { to, from } => store_element(frame, &active, to, from),
            Step::Call(call) => self.call(frame, call, &active)?,
            Step::Block(steps) => return self.steps(frame, steps, active),
            Step::If { condition, accept, reject, stored } => {
                self.counts.branches += active.count() as u64;
                let (accepted, rejected) = split(frame, *condition, active);
                return self.diverge(frame, stored, [(&accept[..], accepted), (&reject[..], rejected)]);
            }
            Step::Switch { selector, cases, stored } => return self.switch(frame, *selector, cases, stored, active),
            Step::Loop { body, continuing, break_if, stored } => {
                return self.repeat(frame, [body, continuing], *break_if, stored, active);
            }
            Step::Break => return Ok(leave(frame, active)),
            Step::Continue => return Ok(skip(frame, active)),
            Step::Return { values } => return Ok(self.finish(frame, values, active)),
        }
        Ok(active)
    }

    /// Runs each side on its lanes. A lane in several sides takes each from the same state, and comes out with the
    /// states joined.
    fn diverge<'s>(
        &mut self,
        frame: &mut Frame<D>,
        stored: &[Register],
        sides: impl IntoIterator<Item = (&'s [Step], Active)>,
    ) -> Result<Active> {
        let mut end = Active::none(frame.lanes);
        if D::DECIDED {
            for (steps, active) in sides {
                end = end.union(self.steps(frame, steps, active)?);
            }
            return Ok(end);
        }
        let sides: Vec<_> = sides.into_iter().collect();
        let open = several(sides.iter().map(|(_, active)| active), frame.lanes);
        let mut before = Joined::new(stored, frame.lanes);
        before.add(frame, &open);
        let mut after = Joined::new(stored, frame.lanes);
        for (steps, active) in sides {
            before.write(frame);
            let rest = self.steps(frame, steps, active)?;
            let arrived: Vec<u32> = rest.clone().into_list().into_iter().filter(|lane| before.has(*lane)).collect();
            after.add(frame, &arrived);
            end = end.union(rest);
        }
        after.write(frame);
        Ok(end)
    }

    fn switch(
        &mut self,
        frame: &mut Frame<D>,
        selector: u32,
        cases: &[Case],
        stored: &[Register],
        active: Active,
    ) -> Result<Active> {
        self.counts.branches += active.count() as u64;
        let chosen = choose(frame, selector, cases, &active);
        frame.scopes.push(Scope::new(false, stored, frame.lanes));
        let lanes = frame.lanes;
        let sides = cases.iter().zip(chosen).map(|(case, list)| (&case.body[..], Active::some(lanes, list)));
        let end = self.diverge(frame, stored, sides)?;
        Ok(end.union_at(frame.scopes.pop().map(|scope| (scope.broken, scope.at_break)), frame))
    }

    fn finish(&mut self, frame: &mut Frame<D>, values: &[Register], active: Active) -> Active {
        let results = self.results(frame);
        if D::DECIDED {
            results.iter().zip(values).for_each(|(to, from)| frame.store(&active, *to, *from));
            return Active::none(frame.lanes);
        }
        results.iter().zip(values).for_each(|(to, from)| frame.store_result(&active, *to, *from));
        self.depart(frame, active);
        Active::none(frame.lanes)
    }

    /// Notes that lanes leave the function in the present state.
    pub(super) fn depart(&mut self, frame: &mut Frame<D>, active: Active) {
        if !D::DECIDED {
            active.each(|lane| frame.returned[lane] = true);
            let mut state = std::mem::replace(&mut frame.at_return, Joined::new(&[], 0));
            state.add(frame, &active.into_list());
            frame.at_return = state;
        }
    }
}

impl Active {
    /// These lanes and others that jumped here, and the state that the latter had.
    pub(super) fn union_at<D: Domain>(self, arrived: Option<(Vec<u32>, Joined<D>)>, frame: &mut Frame<D>) -> Self {
        let Some((mut list, mut state)) = arrived else { return self };
        if !D::DECIDED {
            let twice: Vec<u32> = self.clone().into_list().into_iter().filter(|lane| state.has(*lane)).collect();
            state.add(frame, &twice);
            state.write(frame);
        }
        list.sort_unstable();
        list.dedup();
        self.union(Self::some(frame.lanes, list))
    }
}

/// `break`: the lanes go to the end of the innermost loop or switch.
fn leave<D: Domain>(frame: &mut Frame<D>, active: Active) -> Active {
    if let Some(mut scope) = frame.scopes.pop() {
        let list = active.into_list();
        if !D::DECIDED {
            scope.at_break.add(frame, &list);
        }
        scope.broken.extend(list);
        frame.scopes.push(scope);
    }
    Active::none(frame.lanes)
}

/// `continue`: the lanes go to the continuing block of the innermost loop.
fn skip<D: Domain>(frame: &mut Frame<D>, active: Active) -> Active {
    if let Some(index) = frame.scopes.iter().rposition(|scope| scope.is_loop) {
        let list = active.into_list();
        if !D::DECIDED {
            let mut state = std::mem::replace(&mut frame.scopes[index].at_continue, Joined::new(&[], 0));
            state.add(frame, &list);
            frame.scopes[index].at_continue = state;
        }
        frame.scopes[index].continued.extend(list);
    }
    Active::none(frame.lanes)
}

/// The lanes where a condition holds, and those where it does not; a lane where it is open is in both.
pub(super) fn split<D: Domain>(frame: &Frame<D>, condition: u32, active: Active) -> (Active, Active) {
    let condition = frame.truth(condition);
    if let super::lane::View::One(condition) = condition {
        let none = Active::none(frame.lanes);
        return match D::decide(condition) {
            Some(true) => (active, none),
            Some(false) => (none, active),
            None => (active.clone(), active),
        };
    }
    let (mut accepted, mut rejected) = (Vec::new(), Vec::new());
    active.each(|lane| {
        let holds = D::decide(condition.at(lane));
        if holds != Some(false) {
            accepted.push(lane as u32);
        }
        if holds != Some(true) {
            rejected.push(lane as u32);
        }
    });
    (Active::some(frame.lanes, accepted), Active::some(frame.lanes, rejected))
}

/// The lanes of each case; all of them, for a selector of which nothing is known.
fn choose<D: Domain>(frame: &Frame<D>, selector: u32, cases: &[Case], active: &Active) -> Vec<Vec<u32>> {
    let default = cases.iter().position(|case| case.default);
    let of = |value: u32| cases.iter().position(|case| case.values.contains(&value)).or(default);
    let mut chosen = vec![Vec::new(); cases.len()];
    let selector = frame.int(selector);
    active.each(|lane| {
        let value = selector.at(lane);
        if let Some(value) = D::known(value) {
            of(value).into_iter().for_each(|case| chosen[case].push(lane as u32));
            return;
        }
        let mut places: Vec<usize> = match D::candidates(value) {
            Some(values) => values.into_iter().filter_map(of).collect(),
            None => (0..cases.len()).collect(),
        };
        places.sort_unstable();
        places.dedup();
        places.into_iter().for_each(|case| chosen[case].push(lane as u32));
    });
    chosen
}

/// The lanes that are in more than one set.
fn several<'a>(sets: impl Iterator<Item = &'a Active>, lanes: usize) -> Vec<u32> {
    let mut times = vec![0; lanes];
    sets.for_each(|set| set.each(|lane| times[lane] += 1));
    (0..lanes as u32).filter(|lane| times[*lane as usize] > 1).collect()
}
