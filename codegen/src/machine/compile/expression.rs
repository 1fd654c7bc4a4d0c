//! One expression.

use naga::{Expression, Handle, RelationalFunction};

use super::access::registers;
use super::{Bank, Compiler, Known, Pointer, Result, TypeInner};
use crate::machine::domain::TruthBinary;

impl Compiler<'_> {
    /// Compiles an expression whose operands are known.
    pub(super) fn expression(&mut self, handle: Handle<Expression>) -> Result<Known> {
        let function = self.function;
        let value = match &function.expressions[handle] {
            Expression::Literal(literal) => self.literal(*literal)?,
            Expression::Constant(constant) => self.global_expression(self.module.constants[*constant].init)?,
            Expression::ZeroValue(ty) => self.zero(*ty)?,
            Expression::Compose { components, .. } => {
                let mut registers = Vec::new();
                for component in components {
                    registers.extend(self.value(*component)?);
                }
                registers
            }
            Expression::Access { base, index } => return self.access(*base, *index),
            Expression::AccessIndex { base, index } => return self.access_index(*base, *index),
            Expression::Splat { size, value } => self.value(*value)?.repeat(*size as usize),
            Expression::Swizzle { size, vector, pattern } => return self.swizzle(*vector, &pattern[..*size as usize]),
            Expression::FunctionArgument(index) => return Ok(self.argument(*index as usize)),
            Expression::GlobalVariable(variable) => self.global_variable(*variable)?,
            Expression::LocalVariable(variable) => {
                return Ok(Known::Pointer(Pointer::whole(self.variables[variable.index()].clone())));
            }
            Expression::Load { pointer } => match self.known(*pointer)?.clone() {
                Known::Pointer(pointer) if self.steady[handle.index()] && pointer.terms.is_empty() => {
                    pointer.registers().to_vec()
                }
                Known::Pointer(pointer) => self.load(&pointer)?,
                Known::Value(_) => return self.unsupported("a load from a value"),
            },
            Expression::ImageSample { .. } => self.image_sample(handle)?,
            Expression::ImageLoad { image, coordinate, array_index, sample: None, level } => {
                self.image_load(*image, *coordinate, *array_index, *level)?
            }
            Expression::ImageQuery { image, query } => self.image_query(*image, *query)?,
            Expression::Unary { op, expr } => self.unary(*op, *expr)?,
            Expression::Binary { op, left, right } => self.binary(*op, *left, *right)?,
            Expression::Select { condition, accept, reject } => self.selection(*condition, *accept, *reject)?,
            Expression::Relational { fun, argument } => self.relational(*fun, *argument)?,
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                let arguments: Vec<_> = [Some(*arg), *arg1, *arg2, *arg3].into_iter().flatten().collect();
                self.maths(*fun, &arguments)?
            }
            Expression::As { expr, kind, convert } => self.cast(*expr, *kind, convert.is_some())?,
            Expression::Derivative { .. } => {
                return self.unsupported("a screen-space derivative, which has no meaning on the CPU");
            }
            other => return self.unsupported(format!("the expression {other:?}")),
        };
        Ok(Known::Value(value))
    }

    fn argument(&self, index: usize) -> Known {
        let registers = self.program.parameters[index].clone();
        match self.module.types[self.function.arguments[index].ty].inner {
            TypeInner::Pointer { .. } => Known::Pointer(Pointer::whole(registers)),
            _ => Known::Value(registers),
        }
    }

    fn global_variable(&mut self, handle: Handle<naga::GlobalVariable>) -> Result<Vec<super::Register>> {
        let variable = &self.module.global_variables[handle];
        if variable.space != naga::AddressSpace::Handle {
            let name = variable.name.clone().unwrap_or_default();
            return self.unsupported(format!("the global variable `{name}`, which is no texture or sampler"));
        }
        let register = self.allocate(Bank::Handle);
        self.program.globals.push((register, handle.index()));
        Ok(vec![register])
    }

    fn selection(
        &mut self,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> Result<Vec<super::Register>> {
        let condition = self.indices(condition)?;
        let (accept, reject) = (self.value(accept)?, self.value(reject)?);
        let pairs = accept.into_iter().zip(reject).enumerate();
        Ok(pairs
            .map(|(i, (accept, reject))| super::Register {
                bank: accept.bank,
                index: self.select(accept.bank, lane_of(&condition, i), accept.index, reject.index),
            })
            .collect())
    }

    fn relational(&mut self, fun: RelationalFunction, argument: Handle<Expression>) -> Result<Vec<super::Register>> {
        let op = match fun {
            RelationalFunction::All => TruthBinary::And,
            RelationalFunction::Any => TruthBinary::Or,
            other => return self.unsupported(format!("{other:?}")),
        };
        let parts = self.indices(argument)?;
        let joined = parts[1..].iter().fold(parts[0], |joined, part| self.truth_binary(op, joined, *part));
        Ok(registers(Bank::Truth, [joined]))
    }
}

/// A component, where a scalar stands for as many as are needed.
pub(super) fn lane_of(registers: &[u32], component: usize) -> u32 {
    if registers.len() == 1 { registers[0] } else { registers[component] }
}
