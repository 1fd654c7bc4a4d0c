//! What can go wrong between a scene and its picture.

use std::path::PathBuf;

/// A failure of the renderer. The message says what to do where something can be done.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// No driver offers an adapter.
    #[error(
        "no graphics adapter found: neither a GPU driver nor a software one is installed; on Debian and Ubuntu run \
         `apt-get install -y --no-install-recommends mesa-vulkan-drivers libvulkan1`"
    )]
    NoAdapter,
    /// The wanted adapter does not exist.
    #[error("no adapter called `{wanted}`; there is {}", .known.join(", "))]
    UnknownAdapter {
        /// What was asked for.
        wanted: String,
        /// What exists, as `index: name`.
        known: Vec<String>,
    },
    /// The adapter exists but gives no device with the default limits of WebGPU.
    #[error("adapter `{adapter}` gives no device: {reason}")]
    Device {
        /// Name of the adapter.
        adapter: String,
        /// What the driver says.
        reason: String,
    },
    /// A shader or a pipeline was refused.
    #[error("the graphics device refuses the {what}: {reason}")]
    Refused {
        /// What was to be created.
        what: &'static str,
        /// What wgpu says, with source text where it has some.
        reason: String,
    },
    /// The device was lost, or memory ran out, while drawing.
    #[error("drawing failed: {0}")]
    Lost(String),
    /// A scene that cannot be drawn.
    #[error("{0}")]
    Scene(String),
    /// A texture file that cannot be used.
    #[error("{}: {reason}", .path.display())]
    Texture {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: String,
    },
}

/// What every fallible function here returns.
pub type Result<T> = std::result::Result<T, RenderError>;
