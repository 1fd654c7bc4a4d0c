//! The class of an instruction, for the costs.

use super::super::program::Instruction;
use super::Run;
use crate::machine::domain::{Domain, FloatBinary, FloatTernary, FloatUnary};

impl<D: Domain> Run<'_, D> {
    pub(super) fn count(&mut self, instruction: &Instruction, lanes: usize) {
        let counts = &mut self.counts;
        let (class, times) = match instruction {
            Instruction::Copy { .. }
            | Instruction::Size { .. }
            | Instruction::Layers { .. }
            | Instruction::Levels { .. } => return,
            Instruction::FloatUnary { op, .. } => match op {
                FloatUnary::Sqrt | FloatUnary::InverseSqrt => (&mut counts.division, 1),
                op if is_arithmetic(*op) => (&mut counts.arithmetic, 1),
                _ => (&mut counts.transcendental, 1),
            },
            Instruction::FloatBinary { op, .. } => match op {
                FloatBinary::Divide | FloatBinary::Remainder => (&mut counts.division, 1),
                FloatBinary::Pow | FloatBinary::Atan2 => (&mut counts.transcendental, 1),
                FloatBinary::Step => (&mut counts.decision, 1),
                _ => (&mut counts.arithmetic, 1),
            },
            Instruction::FloatTernary { op, .. } => match op {
                FloatTernary::Clamp => (&mut counts.arithmetic, 2),
                FloatTernary::Fma => (&mut counts.arithmetic, 1),
                FloatTernary::Mix => (&mut counts.arithmetic, 4),
                FloatTernary::SmoothStep => {
                    counts.division += lanes as u64;
                    (&mut counts.arithmetic, 8)
                }
            },
            Instruction::Dot { a, .. } | Instruction::SquareSum { x: a, .. } => {
                (&mut counts.arithmetic, 2 * a.len() as u64 - 1)
            }
            Instruction::IntUnary { .. } | Instruction::IntBinary { .. } => (&mut counts.integer, 1),
            Instruction::FloatComparison { .. }
            | Instruction::IntComparison { .. }
            | Instruction::Not { .. }
            | Instruction::TruthBinary { .. }
            | Instruction::Select { .. } => (&mut counts.decision, 1),
            Instruction::Convert { .. } | Instruction::Scale { .. } => (&mut counts.conversion, 1),
            Instruction::Element { .. } => (&mut counts.indexed, 1),
            Instruction::Sample(_) => (&mut counts.texture_samples, 1),
            Instruction::Load(_) => (&mut counts.texture_loads, 1),
        };
        *class += times * lanes as u64;
    }
}

fn is_arithmetic(op: FloatUnary) -> bool {
    matches!(
        op,
        FloatUnary::Negate
            | FloatUnary::Abs
            | FloatUnary::Sign
            | FloatUnary::Floor
            | FloatUnary::Ceil
            | FloatUnary::Round
            | FloatUnary::Trunc
            | FloatUnary::Fract
            | FloatUnary::Saturate
            | FloatUnary::Square
            | FloatUnary::Radians
            | FloatUnary::Degrees
            | FloatUnary::QuantizeToF16
            | FloatUnary::Unspecified
            | FloatUnary::FrexpFraction
    )
}
