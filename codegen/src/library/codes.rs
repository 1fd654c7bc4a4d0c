//! What can be wrong with a WGSL file of the library or of a project's `nodes/` folder.

use crate::diagnostic::Code;

/// naga refuses the text.
pub const INVALID_WGSL: Code = Code { id: "TG001", name: "invalid-wgsl" };
/// A declaration that a library file must not hold.
pub const FOREIGN_DECLARATION: Code = Code { id: "TG002", name: "foreign-declaration" };
/// A name that does not begin with the file's stem, or that exists already.
pub const NAME_WITHOUT_STEM: Code = Code { id: "TG003", name: "name-without-stem" };
/// A port line that is missing or that the grammar does not know.
pub const PORT_UNDOCUMENTED: Code = Code { id: "TG004", name: "port-undocumented" };
/// A port of a type that cannot flow along a wire.
pub const PORT_TYPE: Code = Code { id: "TG005", name: "port-type" };
/// A node without summary, source or example.
pub const NODE_UNDOCUMENTED: Code = Code { id: "TG006", name: "node-undocumented" };
/// A default that does not fit its port.
pub const PORT_DEFAULT: Code = Code { id: "TG007", name: "port-default" };
