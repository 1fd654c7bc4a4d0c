//! Matrices: columns of floats, one after the other.

use naga::{Expression, Handle, TypeInner};

use super::access::registers;
use super::{Bank, Compiler, Register, Result};
use crate::machine::domain::{FloatBinary, FloatUnary};

/// The scalars of a matrix.
struct Matrix {
    scalars: Vec<u32>,
    rows: usize,
}

impl Matrix {
    fn column(&self, column: usize) -> &[u32] {
        &self.scalars[column * self.rows..(column + 1) * self.rows]
    }

    fn row(&self, row: usize) -> Vec<u32> {
        self.scalars.iter().skip(row).step_by(self.rows).copied().collect()
    }

    fn columns(&self) -> usize {
        self.scalars.len() / self.rows
    }
}

impl Compiler<'_> {
    fn matrix(&mut self, expression: Handle<Expression>) -> Result<Option<Matrix>> {
        let TypeInner::Matrix { rows, .. } = *self.inner(expression) else { return Ok(None) };
        Ok(Some(Matrix { scalars: self.indices(expression)?, rows: rows as usize }))
    }

    /// A product in which one side at least is a matrix.
    pub(super) fn matrix_product(
        &mut self,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Result<Vec<Register>> {
        let results: Vec<u32> = match (self.matrix(left)?, self.matrix(right)?) {
            (Some(a), Some(b)) => (0..b.columns())
                .flat_map(|column| (0..a.rows).map(move |row| (row, column)))
                .map(|(row, column)| self.dot(a.row(row), b.column(column).to_vec()))
                .collect(),
            (Some(a), None) => {
                let vector = self.indices(right)?;
                if let [scalar] = vector[..] {
                    self.scaled(&a.scalars, scalar)
                } else {
                    (0..a.rows).map(|row| self.dot(a.row(row), vector.clone())).collect()
                }
            }
            (None, Some(b)) => {
                let vector = self.indices(left)?;
                if let [scalar] = vector[..] {
                    self.scaled(&b.scalars, scalar)
                } else {
                    (0..b.columns()).map(|column| self.dot(vector.clone(), b.column(column).to_vec())).collect()
                }
            }
            (None, None) => return self.unsupported("a matrix product of no matrices"),
        };
        Ok(registers(Bank::Float, results))
    }

    fn scaled(&mut self, scalars: &[u32], factor: u32) -> Vec<u32> {
        scalars.iter().map(|scalar| self.float_binary(FloatBinary::Multiply, *scalar, factor)).collect()
    }

    pub(super) fn transpose(&mut self, argument: Handle<Expression>) -> Result<Vec<Register>> {
        let Some(matrix) = self.matrix(argument)? else { return self.unsupported("a transposed value, no matrix") };
        Ok(registers(Bank::Float, (0..matrix.rows).flat_map(|row| matrix.row(row))))
    }

    pub(super) fn determinant(&mut self, argument: Handle<Expression>) -> Result<Vec<Register>> {
        let Some(matrix) = self.matrix(argument)? else { return self.unsupported("the determinant of no matrix") };
        let columns: Vec<Vec<u32>> = (0..matrix.columns()).map(|column| matrix.column(column).to_vec()).collect();
        let value = self.minor(&columns);
        let result = self.float_unary(FloatUnary::Unspecified, value);
        Ok(registers(Bank::Float, [result]))
    }

    /// The determinant by expansion along the first column.
    fn minor(&mut self, columns: &[Vec<u32>]) -> u32 {
        if let [column] = columns {
            return column[0];
        }
        let mut cofactors = Vec::new();
        for row in 0..columns.len() {
            let rest: Vec<Vec<u32>> = columns[1..]
                .iter()
                .map(|column| column.iter().enumerate().filter(|(i, _)| *i != row).map(|(_, x)| *x).collect())
                .collect();
            let minor = self.minor(&rest);
            cofactors.push(if row % 2 == 0 { minor } else { self.float_unary(FloatUnary::Negate, minor) });
        }
        self.dot(columns[0].clone(), cofactors)
    }
}
