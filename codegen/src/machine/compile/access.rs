//! Parts of values, and places in variables.

use naga::{Expression, Handle};

use super::super::program::{Element, Instruction, Register, Term};
use super::{Bank, Compiler, Known, Pointer, Result};

impl Compiler<'_> {
    /// A member, element, column or component known by number.
    pub(super) fn access_index(&mut self, base: Handle<Expression>, index: u32) -> Result<Known> {
        let (offset, size) = self.part(self.inner(base), index)?;
        match self.known(base)? {
            Known::Value(registers) => Ok(Known::Value(registers[offset as usize..(offset + size) as usize].to_vec())),
            Known::Pointer(pointer) => {
                let offset = pointer.offset + offset;
                Ok(Known::Pointer(Pointer { offset, size, ..pointer.clone() }))
            }
        }
    }

    /// An element, column or component known at run time.
    pub(super) fn access(&mut self, base: Handle<Expression>, index: Handle<Expression>) -> Result<Known> {
        let (count, stride) = self.elements(self.inner(base))?;
        let term = Term { index: self.scalar(index)?, count, stride };
        let pointer = match self.known(base)?.clone() {
            Known::Pointer(mut pointer) => {
                pointer.terms.push(term);
                return Ok(Known::Pointer(Pointer { size: stride, ..pointer }));
            }
            Known::Value(table) => Pointer { table, offset: 0, size: stride, terms: vec![term] },
        };
        self.load(&pointer).map(Known::Value)
    }

    /// The value behind a pointer, now.
    pub(super) fn load(&mut self, pointer: &Pointer) -> Result<Vec<Register>> {
        if pointer.terms.is_empty() {
            let registers = pointer.registers().to_vec();
            return Ok(registers.into_iter().map(|from| self.copy_register(from)).collect());
        }
        let parts: Vec<Register> = pointer.registers().to_vec();
        let mut loaded = Vec::new();
        for (i, part) in parts.iter().enumerate() {
            let to = self.allocate(part.bank);
            let mut from = pointer.element();
            from.offset += i as u32;
            self.pending.push(Instruction::Element { bank: part.bank, to: to.index, from });
            loaded.push(to);
        }
        Ok(loaded)
    }

    fn copy_register(&mut self, from: Register) -> Register {
        Register { bank: from.bank, index: self.copy(from.bank, from.index) }
    }

    pub(super) fn swizzle(&mut self, vector: Handle<Expression>, pattern: &[naga::SwizzleComponent]) -> Result<Known> {
        let registers = self.value(vector)?;
        Ok(Known::Value(pattern.iter().map(|component| registers[*component as usize]).collect()))
    }

    /// What an expression has become; it must have been emitted.
    pub(super) fn known(&mut self, expression: Handle<Expression>) -> Result<&Known> {
        if self.known[expression.index()].is_none() {
            if !self.function.expressions[expression].needs_pre_emit() {
                let construct = format!("{:?} before it is emitted", self.function.expressions[expression]);
                return self.unsupported(construct);
            }
            let known = self.expression(expression)?;
            self.known[expression.index()] = Some(known);
        }
        match &self.known[expression.index()] {
            Some(known) => Ok(known),
            None => unreachable!("it has just been set"),
        }
    }

    /// The scalars of an expression that is a value.
    pub(super) fn value(&mut self, expression: Handle<Expression>) -> Result<Vec<Register>> {
        match self.known(expression)? {
            Known::Value(registers) => Ok(registers.clone()),
            Known::Pointer(_) => self.unsupported("a pointer as a value"),
        }
    }

    /// The indices of a value whose scalars are all in one bank.
    pub(super) fn indices(&mut self, expression: Handle<Expression>) -> Result<Vec<u32>> {
        Ok(self.value(expression)?.into_iter().map(|register| register.index).collect())
    }

    /// The index of a scalar.
    pub(super) fn scalar(&mut self, expression: Handle<Expression>) -> Result<u32> {
        match self.value(expression)?.as_slice() {
            [register] => Ok(register.index),
            _ => self.unsupported("a vector where a scalar belongs"),
        }
    }
}

impl Pointer {
    /// All of a variable.
    pub(super) fn whole(table: Vec<Register>) -> Self {
        Self { offset: 0, size: table.len() as u32, terms: Vec::new(), table }
    }

    /// The pointee's scalars if all indices are 0: they have the banks of the real ones.
    pub(super) fn registers(&self) -> &[Register] {
        &self.table[self.offset as usize..(self.offset + self.size) as usize]
    }

    pub(super) fn element(&self) -> Element {
        Element { table: self.table.clone(), offset: self.offset, terms: self.terms.clone() }
    }
}

/// Registers of one bank.
pub(super) fn registers(bank: Bank, indices: impl IntoIterator<Item = u32>) -> Vec<Register> {
    indices.into_iter().map(|index| Register { bank, index }).collect()
}
