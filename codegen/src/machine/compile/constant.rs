//! Literals and module constants.

use naga::{Expression, Handle, Literal, Type};

use super::{Bank, Compiler, Register, Result};

impl Compiler<'_> {
    /// The register that holds these bits in all lanes.
    pub(super) fn constant(&mut self, bank: Bank, bits: u32) -> Register {
        if let Some(register) = self.constants.get(&(bank as u8, bits)) {
            return *register;
        }
        let register = self.allocate(bank);
        self.program.constants.push((register, bits));
        self.constants.insert((bank as u8, bits), register);
        register
    }

    pub(super) fn float_constant(&mut self, value: f32) -> u32 {
        self.constant(Bank::Float, value.to_bits()).index
    }

    pub(super) fn int_constant(&mut self, bits: u32) -> u32 {
        self.constant(Bank::Int, bits).index
    }

    pub(super) fn literal(&mut self, literal: Literal) -> Result<Vec<Register>> {
        let register = match literal {
            Literal::F32(value) => self.constant(Bank::Float, value.to_bits()),
            Literal::U32(value) => self.constant(Bank::Int, value),
            Literal::I32(value) => self.constant(Bank::Int, value as u32),
            Literal::Bool(value) => self.constant(Bank::Truth, u32::from(value)),
            other => return self.unsupported(format!("the literal {other:?}")),
        };
        Ok(vec![register])
    }

    /// All bits 0.
    pub(super) fn zero(&mut self, ty: Handle<Type>) -> Result<Vec<Register>> {
        let banks = self.banks(&self.module.types[ty].inner)?;
        Ok(banks.into_iter().map(|bank| self.constant(bank, 0)).collect())
    }

    /// An expression of the module's own, which naga has evaluated as far as it can be.
    pub(super) fn global_expression(&mut self, handle: Handle<Expression>) -> Result<Vec<Register>> {
        let module = self.module;
        match &module.global_expressions[handle] {
            Expression::Literal(literal) => self.literal(*literal),
            Expression::Constant(constant) => self.global_expression(module.constants[*constant].init),
            Expression::ZeroValue(ty) => self.zero(*ty),
            Expression::Splat { size, value } => Ok(self.global_expression(*value)?.repeat(*size as usize)),
            Expression::Compose { components, .. } => {
                let mut registers = Vec::new();
                for component in components {
                    registers.extend(self.global_expression(*component)?);
                }
                Ok(registers)
            }
            other => self.unsupported(format!("the constant expression {other:?}")),
        }
    }
}
