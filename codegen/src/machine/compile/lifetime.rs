//! Which loads need no copy: those whose variable is not stored to before the value's last use.
//!
//! naga loads a variable at every mention, so most instructions would otherwise be copies.

use naga::{Block, Expression, Function, Handle, Statement};

use super::operand::{operands, statement_operands};

/// For each expression, whether it is a load that may stand for the variable's own registers.
pub(super) fn steady_loads(function: &Function) -> Vec<bool> {
    let mut history = History {
        function,
        time: 0,
        emitted: vec![0; function.expressions.len()],
        uses: Vec::new(),
        stores: Vec::new(),
        loops: Vec::new(),
    };
    history.block(&function.body);
    let last = history.last_uses();
    let steady = |(handle, expression): (Handle<Expression>, &Expression)| {
        let Expression::Load { pointer } = expression else { return false };
        let Some(variable) = history.variable(*pointer) else { return false };
        let (from, to) = (history.emitted[handle.index()], last[handle.index()]);
        !history.stores.iter().any(|(stored, time)| *stored == variable && from < *time && *time <= to)
    };
    function.expressions.iter().map(steady).collect()
}

/// When, in the order of the text, expressions are emitted and used and variables are stored to.
struct History<'a> {
    function: &'a Function,
    time: u32,
    /// By expression.
    emitted: Vec<u32>,
    uses: Vec<(Handle<Expression>, u32)>,
    stores: Vec<(Variable, u32)>,
    /// First and last time of each loop.
    loops: Vec<(u32, u32)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Variable {
    Local(usize),
    Parameter(u32),
}

impl History<'_> {
    fn block(&mut self, block: &Block) {
        for statement in block.iter() {
            self.time += 1;
            self.statement(statement);
        }
    }

    fn statement(&mut self, statement: &Statement) {
        let function = self.function;
        for operand in statement_operands(statement) {
            self.uses.push((operand, self.time));
        }
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    self.emitted[handle.index()] = self.time;
                    let uses = operands(&function.expressions[handle]).into_iter().map(|operand| (operand, self.time));
                    self.uses.extend(uses);
                }
            }
            Statement::Block(block) => self.block(block),
            Statement::If { accept, reject, .. } => {
                self.block(accept);
                self.block(reject);
            }
            Statement::Switch { cases, .. } => cases.iter().for_each(|case| self.block(&case.body)),
            Statement::Loop { body, continuing, break_if } => {
                let start = self.time;
                self.block(body);
                self.block(continuing);
                self.time += 1;
                self.uses.extend(break_if.map(|condition| (condition, self.time)));
                self.loops.push((start, self.time));
            }
            Statement::Store { pointer, .. } => self.store(*pointer),
            // Any pointer among the arguments may be written through.
            Statement::Call { arguments, .. } => arguments.iter().for_each(|argument| self.store(*argument)),
            _ => {}
        }
    }

    fn store(&mut self, pointer: Handle<Expression>) {
        if let Some(variable) = self.variable(pointer) {
            self.stores.push((variable, self.time));
        }
    }

    /// The variable that a pointer points into.
    fn variable(&self, pointer: Handle<Expression>) -> Option<Variable> {
        match self.function.expressions[pointer] {
            Expression::LocalVariable(variable) => Some(Variable::Local(variable.index())),
            Expression::FunctionArgument(index) => Some(Variable::Parameter(index)),
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => self.variable(base),
            _ => None,
        }
    }

    /// When each expression is used for the last time, by itself or under another name.
    fn last_uses(&self) -> Vec<u32> {
        let mut last = vec![0; self.emitted.len()];
        for (used, time) in &self.uses {
            let emitted = self.emitted[used.index()];
            // What a loop uses from outside, it uses in its last turn as well.
            let around = self.loops.iter().filter(|(start, end)| emitted < *start && start <= time && time <= end);
            let time = around.map(|(_, end)| *end).max().unwrap_or(*time);
            last[used.index()] = time.max(last[used.index()]);
        }
        for (handle, expression) in self.function.expressions.iter().rev() {
            if renames(expression) {
                for operand in operands(expression) {
                    last[operand.index()] = last[operand.index()].max(last[handle.index()]);
                }
            }
        }
        last
    }
}

/// Whether the registers of an expression may be those of its operands.
fn renames(expression: &Expression) -> bool {
    matches!(
        expression,
        Expression::Compose { .. }
            | Expression::Access { .. }
            | Expression::AccessIndex { .. }
            | Expression::Splat { .. }
            | Expression::Swizzle { .. }
            | Expression::As { .. }
            | Expression::Math { .. }
    )
}
