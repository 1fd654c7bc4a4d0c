//! The shader library of Terrane: plain WGSL, one file per node, and nothing else.
//!
//! A file's stem is the node's name in a graph, its folder is the category, and the signature of its function is the
//! only declaration of the node's ports. `terrane-codegen` reads the files; any engine can read them as they are.

pub mod heightfield;
pub mod hosts;
pub mod relief;

/// One WGSL file of the library.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SourceFile {
    /// Path below `wgsl/`, with `/` on every platform: `blend/overlay.wgsl`.
    pub path: &'static str,
    /// The file, byte for byte.
    pub text: &'static str,
}

/// Every file of the library, sorted by path.
pub const FILES: &[SourceFile] = include!(concat!(env!("OUT_DIR"), "/files.rs"));
