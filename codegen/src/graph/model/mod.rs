//! A project after resolution: every name is bound, every input has a type, instances are still calls.

mod frame;
mod graph;
mod interface;
mod node;
mod object;
mod relief;
mod scene;
mod terrain;
mod texture;

pub use frame::FrameField;
pub use graph::{Allowed, Graph, GraphId, Graphs, Output, Role, SURFACE_OUTPUTS};
pub use interface::{InstanceInput, Parameter};
pub use node::{Access, Callee, Input, InputValue, Node};
pub use object::{HeightFrom, Object, Solid};
pub use relief::{Relief, ReliefMethod, ReliefShadow, ReliefTrace, ReliefWeights};
pub use scene::{Camera, Scene, Sun};
pub use terrain::{Blend, HeightMap, Layer, LayerMask, Shadow, Terrain};
pub use texture::{ColorSpace, Filter, Texture, Wrap};
