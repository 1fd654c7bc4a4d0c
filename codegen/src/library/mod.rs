//! The node library: WGSL files joined to one text, parsed once by naga, read as node kinds.
//!
//! The signature of a function is the only declaration of a node. Names and types come from naga; meaning, unit, range
//! and default come from the `///` line above each parameter, which naga drops and a scan of ours reads. Both must agree.

pub mod codes;
mod cost;
mod exact;
mod item;
mod kind;
mod load;
pub(crate) use load::causes;
mod port_line;
mod read_kind;
mod shake;
mod token;

use std::collections::BTreeMap;
use std::ops::Range;

use crate::diagnostic::{SourceId, Span};
pub use cost::{Cost, costs};
pub use item::Item;
pub(crate) use item::texture_variables;
pub use kind::{Example, Kind, Overload, Port};

/// Every node that a graph may use, and the WGSL behind it.
#[derive(Debug)]
pub struct Library {
    /// All files, joined byte for byte.
    pub text: String,
    /// The files, in the order of the text.
    pub files: Vec<LibraryFile>,
    /// The declarations, in the order of the text.
    pub items: Vec<Item>,
    /// Position in `items` by name.
    pub names: BTreeMap<String, usize>,
    /// The text as naga sees it.
    pub module: naga::Module,
    /// naga's analysis of it.
    pub info: naga::valid::ModuleInfo,
    /// The node kinds by name.
    pub kinds: BTreeMap<String, Kind>,
    /// Functions whose result is the same on every device, rounding aside.
    pub exact: std::collections::BTreeSet<String>,
    /// Members of every struct, with their documentation, by struct name.
    pub structs: BTreeMap<String, Vec<Port>>,
}

/// Where a file lies in the joined text.
#[derive(Clone, Debug)]
pub struct LibraryFile {
    /// The file among the run's sources.
    pub source: SourceId,
    /// `blend/overlay.wgsl`, or `nodes/…` for a project's own.
    pub path: String,
    /// Its bytes in [`Library::text`].
    pub range: Range<usize>,
}

impl Library {
    /// The file's own span of a range of the joined text.
    pub fn span(&self, range: Range<usize>) -> Span {
        load::span(&self.files, range)
    }

    /// The file that holds a declaration.
    pub fn file_of(&self, item: &Item) -> &LibraryFile {
        load::file(&self.files, item.range.start)
    }
}
