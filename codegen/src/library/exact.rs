//! Which functions WGSL defines to the last bit, rounding aside: only those may be folded.
//!
//! WGSL 15.7.4: `+ - *`, comparisons, selection, `min`, `max`, `floor` and their like are correctly rounded. Division,
//! roots, transcendentals, `mix` and `fma` may differ between devices, and so may everything that calls them.

use std::collections::BTreeSet;

use naga::{BinaryOperator, Block, Expression, Function, Handle, MathFunction, Module, Statement};

/// The names of all functions whose result is the same on every device.
pub(super) fn exact_functions(module: &Module) -> BTreeSet<String> {
    let mut exact: BTreeSet<Handle<Function>> = BTreeSet::new();
    let mut names = BTreeSet::new();
    // naga keeps callees before callers.
    for (handle, function) in module.functions.iter() {
        let expressions = function.expressions.iter().all(|(_, expression)| is_exact(expression));
        if expressions && calls(&function.body).iter().all(|callee| exact.contains(callee)) {
            exact.insert(handle);
            names.extend(function.name.clone());
        }
    }
    names
}

fn is_exact(expression: &Expression) -> bool {
    match expression {
        Expression::Binary { op, .. } => !matches!(op, BinaryOperator::Divide | BinaryOperator::Modulo),
        Expression::Math { fun, .. } => is_exact_math(*fun),
        Expression::Literal(_)
        | Expression::Constant(_)
        | Expression::ZeroValue(_)
        | Expression::Compose { .. }
        | Expression::Access { .. }
        | Expression::AccessIndex { .. }
        | Expression::Splat { .. }
        | Expression::Swizzle { .. }
        | Expression::FunctionArgument(_)
        | Expression::LocalVariable(_)
        | Expression::Load { .. }
        | Expression::Unary { .. }
        | Expression::Select { .. }
        | Expression::Relational { .. }
        | Expression::CallResult(_) => true,
        _ => false,
    }
}

fn is_exact_math(function: MathFunction) -> bool {
    use MathFunction as M;
    matches!(
        function,
        M::Abs
            | M::Min
            | M::Max
            | M::Clamp
            | M::Saturate
            | M::Floor
            | M::Ceil
            | M::Round
            | M::Trunc
            | M::Sign
            | M::Step
    )
}

/// Every function that a block calls.
fn calls(block: &Block) -> Vec<Handle<Function>> {
    let mut found = Vec::new();
    for statement in block.iter() {
        match statement {
            Statement::Call { function, .. } => found.push(*function),
            Statement::Block(inner) => found.extend(calls(inner)),
            Statement::If { accept, reject, .. } => {
                found.extend(calls(accept));
                found.extend(calls(reject));
            }
            Statement::Switch { cases, .. } => cases.iter().for_each(|case| found.extend(calls(&case.body))),
            Statement::Loop { body, continuing, .. } => {
                found.extend(calls(body));
                found.extend(calls(continuing));
            }
            _ => {}
        }
    }
    found
}
