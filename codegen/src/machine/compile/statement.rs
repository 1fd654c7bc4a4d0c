//! Statements, and the evaluation order that they fix: expressions are computed where naga's `Emit` says.

use naga::{Block, Expression, Function, Handle, Range, Statement, SwitchCase, SwitchValue};

use super::super::program::{Call, Case, Register, Step};
use super::{Compiler, Known, Pointer, Result};

impl Compiler<'_> {
    /// Local variables start with their initial value, or zero.
    pub(super) fn initialise(&mut self) -> Result<Vec<Step>> {
        let function = self.function;
        let mut steps = Vec::new();
        for (_, variable) in function.local_variables.iter() {
            let to = self.allocate_type(&self.module.types[variable.ty].inner)?;
            self.variables.push(to.clone());
            let from = match variable.init {
                Some(init) => self.initial(init)?,
                None => self.zero(variable.ty)?,
            };
            steps.push(Step::Store { to, from });
        }
        Ok(steps)
    }

    /// An initial value is a constant expression: no `Emit` covers it.
    fn initial(&mut self, init: Handle<Expression>) -> Result<Vec<Register>> {
        if self.known[init.index()].is_none() {
            if let Expression::Compose { components, .. } = &self.function.expressions[init] {
                for component in components {
                    self.initial(*component)?;
                }
            }
            if let Expression::Splat { value, .. } = self.function.expressions[init] {
                self.initial(value)?;
            }
            self.known[init.index()] = Some(self.expression(init)?);
        }
        self.value(init)
    }

    pub(super) fn block(&mut self, block: &Block) -> Result<Vec<Step>> {
        let mut steps = Vec::new();
        for statement in block.iter() {
            if let Statement::Emit(range) = statement {
                self.emit(range)?;
                continue;
            }
            let step = self.statement(statement, &mut steps)?;
            self.flush(&mut steps);
            steps.extend(step);
        }
        self.flush(&mut steps);
        Ok(steps)
    }

    fn emit(&mut self, range: &Range<Expression>) -> Result<()> {
        for handle in range.clone() {
            self.known[handle.index()] = Some(self.expression(handle)?);
        }
        Ok(())
    }

    fn flush(&mut self, steps: &mut Vec<Step>) {
        if !self.pending.is_empty() {
            steps.push(Step::Compute(std::mem::take(&mut self.pending)));
        }
    }

    /// The steps of a statement. What its own operands need is pending before, or goes to `steps`.
    fn statement(&mut self, statement: &Statement, steps: &mut Vec<Step>) -> Result<Vec<Step>> {
        let step = match statement {
            Statement::Block(block) => {
                self.flush(steps);
                Step::Block(self.block(block)?)
            }
            Statement::If { condition, accept, reject } => {
                let condition = self.scalar(*condition)?;
                self.flush(steps);
                let (accept, reject) = (self.block(accept)?, self.block(reject)?);
                let stored = both(Step::stored(&accept), Step::stored(&reject));
                Step::If { condition, accept, reject, stored }
            }
            Statement::Switch { selector, cases } => {
                let selector = self.scalar(*selector)?;
                self.flush(steps);
                let cases = self.cases(cases)?;
                let stored = cases.iter().map(|case| Step::stored(&case.body)).fold(Vec::new(), both);
                Step::Switch { selector, cases, stored }
            }
            Statement::Loop { body, continuing, break_if } => {
                self.flush(steps);
                let (body, continuing) = (self.block(body)?, self.block(continuing)?);
                let break_if = break_if.map(|condition| self.scalar(condition)).transpose()?;
                let stored = both(Step::stored(&body), Step::stored(&continuing));
                Step::Loop { body, continuing, break_if, stored }
            }
            Statement::Break => Step::Break,
            Statement::Continue => Step::Continue,
            Statement::Return { value } => {
                Step::Return { values: value.map_or(Ok(Vec::new()), |value| self.value(value))? }
            }
            Statement::Store { pointer, value } => {
                let value = self.value(*value)?;
                let pointer = self.pointer(*pointer)?;
                store(&pointer, value)
            }
            Statement::Call { function, arguments, result } => return self.call(*function, arguments, *result),
            other => return self.unsupported(format!("the statement {}", name(other))),
        };
        Ok(vec![step])
    }

    fn pointer(&mut self, expression: Handle<Expression>) -> Result<Pointer> {
        match self.known(expression)? {
            Known::Pointer(pointer) => Ok(pointer.clone()),
            Known::Value(_) => self.unsupported("a value as a pointer"),
        }
    }

    /// Empty cases that fall through lend their values to the next one; WGSL has no other sort of falling through.
    fn cases(&mut self, cases: &[SwitchCase]) -> Result<Vec<Case>> {
        let mut compiled = Vec::new();
        let (mut values, mut default) = (Vec::new(), false);
        for case in cases {
            match case.value {
                SwitchValue::I32(value) => values.push(value as u32),
                SwitchValue::U32(value) => values.push(value),
                SwitchValue::Default => default = true,
            }
            if case.fall_through {
                if !case.body.is_empty() {
                    return self.unsupported("a case that runs on into the next one");
                }
                continue;
            }
            let body = self.block(&case.body)?;
            compiled.push(Case { values: std::mem::take(&mut values), default, body });
            default = false;
        }
        Ok(compiled)
    }

    fn call(
        &mut self,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
    ) -> Result<Vec<Step>> {
        let callee = self.programs[function.index()].as_ref().map_err(Clone::clone)?;
        let (mut registers, mut returned, mut stores) = (Vec::new(), Vec::new(), Vec::new());
        for (argument, parameter) in arguments.iter().zip(&callee.parameters) {
            match self.known(*argument)?.clone() {
                Known::Value(value) => registers.extend(value),
                Known::Pointer(pointer) => {
                    let value = self.load(&pointer)?;
                    returned.extend(parameter.iter().copied().zip(value.iter().copied()));
                    registers.extend(value.iter().copied());
                    stores.push(store(&pointer, value));
                }
            }
        }
        let results: Vec<_> = callee.results.iter().map(|register| self.allocate(register.bank)).collect();
        if let Some(result) = result {
            self.known[result.index()] = Some(Known::Value(results.clone()));
        }
        let call = Call { function: function.index(), arguments: registers, results, returned };
        Ok(std::iter::once(Step::Call(call)).chain(stores).collect())
    }
}

/// The registers of both lists.
fn both(mut a: Vec<Register>, b: Vec<Register>) -> Vec<Register> {
    let new: Vec<Register> = b.into_iter().filter(|register| !a.contains(register)).collect();
    a.extend(new);
    a
}

fn store(pointer: &Pointer, from: Vec<Register>) -> Step {
    if pointer.terms.is_empty() {
        Step::Store { to: pointer.registers().to_vec(), from }
    } else {
        Step::StoreElement { to: pointer.element(), from }
    }
}

/// The variant's name: a statement's own `Debug` prints whole blocks.
fn name(statement: &Statement) -> String {
    let text = format!("{statement:?}");
    text.chars().take_while(|c| c.is_alphanumeric()).collect()
}
