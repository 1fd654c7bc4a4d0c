//! Terrain material graphs in, specialised single-pass WGSL out.
//!
//! ```text
//! shaderlib/wgsl/**.wgsl --read-->   Library                joined once, parsed once by naga
//! graphs/**.ron          --read-->   Project of Graphs      typed: every input is a literal, a wire, a default …
//!                        --intern--> Program                equal sub-trees are one value, across all materials
//! terrain                --combine--> Combination           which layers occur
//!                        --specialize--> Specialization     live values in order, what sits under which guard
//!                        --emit-->   Shader                 text, and a map from its bytes to the graph nodes
//!                        --check-->  Checked                naga's verdict; a failure is a diagnostic on the graph
//!                        --manifest--> Manifest             everything an engine must know
//! ```
//!
//! Every stage is a pure function of the one before it: equal input gives equal bytes, on every machine.

pub mod check;
pub mod compile;
pub mod diagnostic;
pub mod emit;
pub mod graph;
pub mod library;
pub mod machine;
pub mod manifest;
pub mod patch;
pub mod program;
mod stage;
pub mod value;
