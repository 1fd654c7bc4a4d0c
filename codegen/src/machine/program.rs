//! A function in the form that the machine runs: dense registers, no handles to look up.

use super::domain::{
    FloatBinary, FloatComparison, FloatTernary, FloatUnary, IntBinary, IntComparison, IntUnary, TruthBinary,
};

/// Which kind of scalar a register holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bank {
    Float,
    Int,
    Truth,
    Handle,
}

impl Bank {
    pub(super) fn family(self) -> &'static str {
        match self {
            Self::Float => "f32",
            Self::Int => "integer",
            Self::Truth => "bool",
            Self::Handle => "texture or sampler",
        }
    }
}

/// A scalar's place in its function's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Register {
    pub(super) bank: Bank,
    pub(super) index: u32,
}

/// A function, compiled.
#[derive(Clone, Debug, Default)]
pub(super) struct Program {
    pub(super) name: String,
    /// How many registers of each bank, in [`Bank`]'s order.
    pub(super) registers: [u32; 4],
    /// Registers that never change, with their bits.
    pub(super) constants: Vec<(Register, u32)>,
    /// Textures and samplers that are global variables: the register, and the variable's index.
    pub(super) globals: Vec<(Register, usize)>,
    /// The scalars of each parameter; those of the pointee for a pointer.
    pub(super) parameters: Vec<Vec<Register>>,
    /// The scalars of the result.
    pub(super) results: Vec<Register>,
    /// The pointees of pointer parameters: what the caller sees of the call beside the result.
    pub(super) outliving: Vec<Register>,
    pub(super) body: Vec<Step>,
}

/// Something that depends on, or changes, which lanes execute or what variables hold. `stored` lists the variables that
/// nested steps store to.
#[derive(Clone, Debug)]
pub(super) enum Step {
    Compute(Vec<Instruction>),
    Store { to: Vec<Register>, from: Vec<Register> },
    StoreElement { to: Element, from: Vec<Register> },
    Block(Vec<Step>),
    If { condition: u32, accept: Vec<Step>, reject: Vec<Step>, stored: Vec<Register> },
    Switch { selector: u32, cases: Vec<Case>, stored: Vec<Register> },
    Loop { body: Vec<Step>, continuing: Vec<Step>, break_if: Option<u32>, stored: Vec<Register> },
    Break,
    Continue,
    Return { values: Vec<Register> },
    Call(Call),
}

impl Step {
    /// The variables that steps store to, each once.
    pub(super) fn stored(steps: &[Self]) -> Vec<Register> {
        let mut all = Vec::new();
        steps.iter().for_each(|step| step.collect_stored(&mut all));
        all.sort_unstable_by_key(|register| (register.bank as u8, register.index));
        all.dedup();
        all
    }

    fn collect_stored(&self, out: &mut Vec<Register>) {
        match self {
            Self::Store { to, .. } => out.extend(to),
            Self::StoreElement { to, .. } => out.extend(&to.table),
            Self::Block(steps) => steps.iter().for_each(|step| step.collect_stored(out)),
            Self::If { stored, .. } | Self::Switch { stored, .. } | Self::Loop { stored, .. } => out.extend(stored),
            Self::Compute(_) | Self::Break | Self::Continue | Self::Return { .. } | Self::Call(_) => {}
        }
    }
}

/// A case of a switch.
#[derive(Clone, Debug)]
pub(super) struct Case {
    /// The selectors that lead here.
    pub(super) values: Vec<u32>,
    /// Whether all others lead here as well.
    pub(super) default: bool,
    pub(super) body: Vec<Step>,
}

/// A call of another function.
#[derive(Clone, Debug)]
pub(super) struct Call {
    /// Index in the machine's programs.
    pub(super) function: usize,
    /// In the order of the callee's parameters' scalars.
    pub(super) arguments: Vec<Register>,
    /// The caller's registers for the callee's results.
    pub(super) results: Vec<Register>,
    /// Pointees to copy back: callee's register, caller's register. WGSL forbids aliases, so a copy is as good.
    pub(super) returned: Vec<(Register, Register)>,
}

/// A place in an array, vector or matrix that is known at run time only.
#[derive(Clone, Debug)]
pub(super) struct Element {
    /// The scalars of the whole.
    pub(super) table: Vec<Register>,
    /// Where the element is if all indices are 0.
    pub(super) offset: u32,
    pub(super) terms: Vec<Term>,
}

/// One index of an [`Element`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    /// Integer register. As an unsigned number it is clamped to the last element.
    pub(super) index: u32,
    pub(super) count: u32,
    /// Scalars from one element to the next.
    pub(super) stride: u32,
}

/// A computation on all active lanes. Destinations are written once per execution, operands are other registers.
#[derive(Clone, Debug)]
pub(super) enum Instruction {
    Copy { bank: Bank, to: u32, from: u32 },
    FloatUnary { op: FloatUnary, to: u32, x: u32 },
    FloatBinary { op: FloatBinary, to: u32, a: u32, b: u32 },
    FloatTernary { op: FloatTernary, to: u32, a: u32, b: u32, c: u32 },
    FloatComparison { op: FloatComparison, to: u32, a: u32, b: u32 },
    Dot { to: u32, a: Vec<u32>, b: Vec<u32> },
    SquareSum { to: u32, x: Vec<u32> },
    IntUnary { op: IntUnary, to: u32, x: u32 },
    IntBinary { op: IntBinary, to: u32, a: u32, b: u32 },
    IntComparison { op: IntComparison, to: u32, a: u32, b: u32 },
    Not { to: u32, x: u32 },
    TruthBinary { op: TruthBinary, to: u32, a: u32, b: u32 },
    Select { bank: Bank, to: u32, condition: u32, accept: u32, reject: u32 },
    Convert { op: Conversion, to: u32, x: u32 },
    Scale { to: u32, x: u32, exponent: u32 },
    Element { bank: Bank, to: u32, from: Element },
    Sample(Sample),
    Load(Load),
    Size { to: [u32; 2], texture: u32, level: Option<u32> },
    Layers { to: u32, texture: u32 },
    Levels { to: u32, texture: u32 },
}

/// From one bank to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Conversion {
    FloatFromSigned,
    FloatFromUnsigned,
    SignedFromFloat,
    UnsignedFromFloat,
    FloatFromBits,
    BitsFromFloat,
    HalfBits,
    FloatFromHalf,
    Exponent,
}

/// A filtered texture read.
#[derive(Clone, Debug)]
pub(super) struct Sample {
    /// Four float registers.
    pub(super) to: [u32; 4],
    /// Handle registers.
    pub(super) texture: u32,
    pub(super) sampler: u32,
    /// Integer register, signed.
    pub(super) layer: Option<u32>,
    pub(super) uv: [u32; 2],
    /// In texels.
    pub(super) offset: [i32; 2],
    pub(super) footprint: Footprint,
}

/// How wide a sample is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Footprint {
    /// The finest mip level.
    Finest,
    /// Float register.
    Level(u32),
    /// Float registers.
    Gradient { ddx: [u32; 2], ddy: [u32; 2] },
}

/// A read of one texel.
#[derive(Clone, Debug)]
pub(super) struct Load {
    /// Four registers of the bank.
    pub(super) bank: Bank,
    pub(super) to: [u32; 4],
    /// Handle register.
    pub(super) texture: u32,
    /// Integer registers, signed.
    pub(super) at: [u32; 2],
    pub(super) layer: Option<u32>,
    pub(super) level: Option<u32>,
}
