//! From files to the model: every name bound, every input typed, every fault found.

mod access;
mod allow;
mod call;
mod channel;
mod fault;
mod fit;
mod graph;
mod images;
mod instances;
mod layer;
mod order;
mod output;
mod port;
mod scene;
mod scope;
mod session;
mod terrain;
mod texture;
mod unused;
mod wire;

pub(super) use fault::{bad_path, file_error};
pub(super) use session::{Session, Texts};
