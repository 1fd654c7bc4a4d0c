//! Pictures of terrain, headless, through wgpu.
//!
//! ```text
//! HeightField --geometry--> Bounds, Patches        quadtree of 33 × 33 grids, no T-junction
//!             --light-----> LightMap               sun's horizon, visible sky: swept on the CPU
//! turbidity, sun --air----> Atmosphere             sun's colour, sky, haze: tables in f64
//! Material    --material--> group 1                arrays with mips, samplers, parameters
//! all of it   --frame-----> Image                  depth, light, sky, objects, tone curve
//! ```
//!
//! Only core WebGPU with its default limits is asked for, so that what is drawn here can be drawn anywhere.

pub mod air;
mod camera;
mod error;
mod frame;
pub mod geometry;
mod gpu;
mod height_field;
mod image;
pub mod light;
mod lights;
pub mod material;
mod object;
mod preview;
mod progress;
mod scene;
mod search;

pub use camera::{Camera, NEAR, View, sun_direction};
pub use error::{RenderError, Result};
pub use gpu::{Gpu, Selection};
pub use height_field::HeightField;
pub use image::Image;
pub use lights::{Lights, luminance};
pub use object::{Object, Solid};
pub use preview::{Preview, render_preview};
pub use progress::{Phase, Progress};
pub use scene::{RenderScene, Rendered, render_scene, render_with_depth};
pub use search::{Searched, search_scene, searched_beside};
