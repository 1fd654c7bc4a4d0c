//! naga's function to a [`Program`]: expressions become scalar registers, renamings (swizzles, constructors, member
//! accesses) become nothing at all.

mod access;
mod arithmetic;
mod bits;
mod constant;
mod convert;
mod emit;
mod expression;
mod geometry;
mod lifetime;
mod maths;
mod matrix;
mod operand;
mod shape;
mod statement;
mod texture;

use std::collections::BTreeMap;

use naga::valid::FunctionInfo;
use naga::{Expression, Function, Handle, Module, ScalarKind, TypeInner};

use super::error::MachineError;
use super::program::{Bank, Instruction, Program, Register, Term};

/// The state of compiling one function.
pub(super) struct Compiler<'a> {
    module: &'a Module,
    function: &'a Function,
    info: &'a FunctionInfo,
    /// The functions before this one, among them all that it calls.
    programs: &'a [Result<Program, MachineError>],
    program: Program,
    /// What each expression has become, once it is emitted.
    known: Vec<Option<Known>>,
    variables: Vec<Vec<Register>>,
    /// Loads that need no copy, by expression.
    steady: Vec<bool>,
    constants: BTreeMap<(u8, u32), Register>,
    /// Instructions since the last step.
    pending: Vec<Instruction>,
}

/// What an expression has become.
#[derive(Clone, Debug)]
enum Known {
    /// The scalars of its value.
    Value(Vec<Register>),
    Pointer(Pointer),
}

/// A place in a variable.
#[derive(Clone, Debug)]
struct Pointer {
    /// The variable's scalars.
    table: Vec<Register>,
    /// The first scalar of the pointee if all indices are 0.
    offset: u32,
    /// How many scalars the pointee has.
    size: u32,
    /// Indices known at run time only.
    terms: Vec<Term>,
}

type Result<T, E = MachineError> = std::result::Result<T, E>;

/// Compiles one function; those that it calls come before it in `programs`.
pub(super) fn compile(
    module: &Module,
    info: &FunctionInfo,
    function: &Function,
    programs: &[Result<Program>],
) -> Result<Program> {
    let mut compiler = Compiler {
        module,
        function,
        info,
        programs,
        program: Program { name: function.name.clone().unwrap_or_default(), ..Program::default() },
        known: vec![None; function.expressions.len()],
        variables: Vec::new(),
        steady: lifetime::steady_loads(function),
        constants: BTreeMap::new(),
        pending: Vec::new(),
    };
    compiler.signature()?;
    let mut body = compiler.initialise()?;
    body.extend(compiler.block(&function.body)?);
    compiler.program.body = body;
    Ok(compiler.program)
}

impl Compiler<'_> {
    fn signature(&mut self) -> Result<()> {
        for argument in &self.function.arguments {
            let ty = match self.module.types[argument.ty].inner {
                TypeInner::Pointer { base, .. } => base,
                _ => argument.ty,
            };
            let registers = self.allocate_type(&self.module.types[ty].inner)?;
            if ty != argument.ty {
                self.program.outliving.extend(&registers);
            }
            self.program.parameters.push(registers);
        }
        if let Some(result) = &self.function.result {
            self.program.results = self.allocate_type(&self.module.types[result.ty].inner)?;
        }
        Ok(())
    }

    fn unsupported<T>(&self, construct: impl Into<String>) -> Result<T> {
        Err(MachineError::Unsupported { function: self.program.name.clone(), construct: construct.into() })
    }

    fn inner(&self, expression: Handle<Expression>) -> &TypeInner {
        self.info[expression].ty.inner_with(&self.module.types)
    }

    /// The scalar kind of a scalar, vector or matrix expression.
    fn kind(&self, expression: Handle<Expression>) -> Option<ScalarKind> {
        self.inner(expression).scalar().map(|scalar| scalar.kind)
    }

    fn is_float(&self, expression: Handle<Expression>) -> bool {
        self.kind(expression) == Some(ScalarKind::Float)
    }

    fn is_signed(&self, expression: Handle<Expression>) -> bool {
        self.kind(expression) == Some(ScalarKind::Sint)
    }

    fn allocate(&mut self, bank: Bank) -> Register {
        let count = &mut self.program.registers[bank as usize];
        let register = Register { bank, index: *count };
        *count += 1;
        register
    }

    /// A register for each scalar of a type.
    fn allocate_type(&mut self, ty: &TypeInner) -> Result<Vec<Register>> {
        let banks = self.banks(ty)?;
        Ok(banks.into_iter().map(|bank| self.allocate(bank)).collect())
    }
}
