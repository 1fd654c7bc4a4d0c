//! Graph files: RON, decoded with places, resolved to typed graphs.
//!
//! ```text
//! text     --syntax-->  values with their bytes in the file      `ron` alone judges syntax
//!          --file-->    surfaces, terrains … as written           one finding does not hide the next
//!          --resolve--> model: every name bound, every input typed
//! ```
//!
//! [`Project`] is the door: it opens a folder with a `terrane.ron` and answers questions about its files.

pub mod codes;
mod file;
mod files;
mod image;
pub mod limits;
mod made;
pub mod model;
mod names;
mod path;
mod project;
pub mod recipe;
mod resolve;
mod suggest;
mod syntax;

pub use file::FileRole;
pub use files::{Disk, FileError, Files, Memory};
pub use image::ImageHeader;
pub use made::Made;
pub use project::{Answer, OpenError, PROJECT_FILE, Project};
pub use suggest::nearest;
