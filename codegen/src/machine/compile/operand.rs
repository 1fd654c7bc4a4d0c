//! What an expression or statement reads.

use naga::{Expression, Handle, ImageQuery, SampleLevel, Statement};

type Operands = Vec<Handle<Expression>>;

/// The expressions that an expression is made of.
pub(super) fn operands(expression: &Expression) -> Operands {
    match expression {
        Expression::Compose { components, .. } => components.clone(),
        Expression::Access { base, index } => vec![*base, *index],
        Expression::AccessIndex { base, .. } => vec![*base],
        Expression::Splat { value, .. } => vec![*value],
        Expression::Swizzle { vector, .. } => vec![*vector],
        Expression::Load { pointer } => vec![*pointer],
        Expression::ImageSample { image, sampler, coordinate, array_index, offset, level, .. } => {
            let footprint = match *level {
                SampleLevel::Exact(level) | SampleLevel::Bias(level) => [Some(level), None],
                SampleLevel::Gradient { x, y } => [Some(x), Some(y)],
                SampleLevel::Auto | SampleLevel::Zero => [None, None],
            };
            let all = [Some(*image), Some(*sampler), Some(*coordinate), *array_index, *offset];
            all.into_iter().chain(footprint).flatten().collect()
        }
        Expression::ImageLoad { image, coordinate, array_index, sample, level } => {
            [Some(*image), Some(*coordinate), *array_index, *sample, *level].into_iter().flatten().collect()
        }
        Expression::ImageQuery { image, query: ImageQuery::Size { level: Some(level) } } => vec![*image, *level],
        Expression::ImageQuery { image, .. } => vec![*image],
        Expression::Unary { expr, .. } | Expression::As { expr, .. } | Expression::Derivative { expr, .. } => {
            vec![*expr]
        }
        Expression::Binary { left, right, .. } => vec![*left, *right],
        Expression::Select { condition, accept, reject } => vec![*condition, *accept, *reject],
        Expression::Relational { argument, .. } => vec![*argument],
        Expression::Math { arg, arg1, arg2, arg3, .. } => {
            [Some(*arg), *arg1, *arg2, *arg3].into_iter().flatten().collect()
        }
        // The rest has no operands, or is refused when it is compiled.
        _ => Vec::new(),
    }
}

/// The expressions that a statement reads itself, nested blocks aside.
pub(super) fn statement_operands(statement: &Statement) -> Operands {
    match statement {
        Statement::If { condition, .. } => vec![*condition],
        Statement::Switch { selector, .. } => vec![*selector],
        Statement::Return { value } => value.iter().copied().collect(),
        Statement::Store { pointer, value } => vec![*pointer, *value],
        Statement::Call { arguments, .. } => arguments.clone(),
        // A loop's condition is read at its end.
        _ => Vec::new(),
    }
}
