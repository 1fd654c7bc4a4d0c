//! What a function costs, counted in its parsed form: never declared, so never wrong.

use std::collections::BTreeMap;
use std::ops::AddAssign;

use naga::{BinaryOperator, Block, Expression, Function, Handle, MathFunction, Module, Statement};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Operations in the text of a function and of what it calls. Both sides of a branch count, and a loop's body once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Cost {
    /// Filtered texture reads.
    pub samples: u32,
    /// Unfiltered texture reads.
    pub loads: u32,
    /// Additions, products, comparisons, selections and cheap builtins, a vector as one.
    pub arithmetic: u32,
    /// Divisions, roots, exponentials, trigonometry.
    pub slow: u32,
    /// Branches.
    pub branches: u32,
    /// Loops.
    pub loops: u32,
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        self.samples += other.samples;
        self.loads += other.loads;
        self.arithmetic += other.arithmetic;
        self.slow += other.slow;
        self.branches += other.branches;
        self.loops += other.loops;
    }
}

/// The cost of every function of a module, by name.
pub fn costs(module: &Module) -> BTreeMap<String, Cost> {
    let mut counted: BTreeMap<Handle<Function>, Cost> = BTreeMap::new();
    let mut named = BTreeMap::new();
    // naga keeps callees before callers.
    for (handle, function) in module.functions.iter() {
        let mut cost = Cost::default();
        for (_, expression) in function.expressions.iter() {
            cost += expression_cost(expression);
        }
        cost += block_cost(&function.body, &counted);
        counted.insert(handle, cost);
        named.insert(function.name.clone().unwrap_or_default(), cost);
    }
    named
}

fn expression_cost(expression: &Expression) -> Cost {
    let mut cost = Cost::default();
    match expression {
        Expression::ImageSample { .. } => cost.samples = 1,
        Expression::ImageLoad { .. } => cost.loads = 1,
        Expression::Binary { op: BinaryOperator::Divide | BinaryOperator::Modulo, .. } => cost.slow = 1,
        Expression::Math { fun, .. } if is_slow(*fun) => cost.slow = 1,
        Expression::Binary { .. }
        | Expression::Unary { .. }
        | Expression::Math { .. }
        | Expression::Select { .. }
        | Expression::Relational { .. }
        | Expression::As { .. } => cost.arithmetic = 1,
        _ => {}
    }
    cost
}

fn is_slow(function: MathFunction) -> bool {
    use MathFunction as M;
    matches!(
        function,
        M::Sqrt
            | M::InverseSqrt
            | M::Length
            | M::Distance
            | M::Normalize
            | M::Pow
            | M::Exp
            | M::Exp2
            | M::Log
            | M::Log2
            | M::Sin
            | M::Cos
            | M::Tan
            | M::Asin
            | M::Acos
            | M::Atan
            | M::Atan2
            | M::Sinh
            | M::Cosh
            | M::Tanh
            | M::SmoothStep
            | M::Refract
    )
}

fn block_cost(block: &Block, known: &BTreeMap<Handle<Function>, Cost>) -> Cost {
    let mut cost = Cost::default();
    for statement in block.iter() {
        cost += statement_cost(statement, known);
    }
    cost
}

fn statement_cost(statement: &Statement, known: &BTreeMap<Handle<Function>, Cost>) -> Cost {
    let mut cost = Cost::default();
    match statement {
        Statement::Call { function, .. } => cost = known.get(function).copied().unwrap_or_default(),
        Statement::Block(block) => cost = block_cost(block, known),
        Statement::If { accept, reject, .. } => {
            cost.branches = 1;
            cost += block_cost(accept, known);
            cost += block_cost(reject, known);
        }
        Statement::Switch { cases, .. } => {
            cost.branches = 1;
            cases.iter().for_each(|case| cost += block_cost(&case.body, known));
        }
        Statement::Loop { body, continuing, .. } => {
            cost.loops = 1;
            cost += block_cost(body, known);
            cost += block_cost(continuing, known);
        }
        _ => {}
    }
    cost
}
