//! The reference tracer against what knows better: exact arithmetic, symmetry, and very many small steps.

mod cases;
mod judge;
mod march;
mod oracle;
mod symmetry;
