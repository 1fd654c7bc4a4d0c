//! `cargo demo`: from a fresh clone to a picture.

use crate::setup;
use crate::step::{cargo, root, step, succeed};
use crate::vulkan;

const SCENE: &str = "graphs/scenes/alpine.ron";
const PICTURE: &str = "out/alpine.png";

/// Sets up Vulkan, builds, renders, and says where the picture is.
///
/// # Errors
/// The first step that fails, in words.
pub(crate) fn run() -> Result<(), String> {
    setup::install(vulkan::missing().as_slice())?;
    step("build", || succeed(cargo(&["build", "--release", "--locked"])))?;
    let picture = root().join(PICTURE);
    // `cargo run` and not a path: the user may have moved the target folder.
    let render = ["run", "--release", "--locked", "--quiet", "--", "render", SCENE, "-o", PICTURE];
    step(&format!("render {SCENE}"), || {
        let mut render = cargo(&render);
        // Mesa's layer that picks devices asks for a window system, and where there is none complains of an error.
        render.env("NODEVICE_SELECT", "1");
        succeed(render)
    })?;
    if !picture.is_file() {
        return Err(format!("terrane reported no error, but there is no {}", picture.display()));
    }
    println!("\nThe picture is {}", picture.display());
    Ok(())
}
