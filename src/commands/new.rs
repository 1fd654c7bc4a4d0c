//! `terrane new`: a small project that works, to be changed into one's own.

use std::path::PathBuf;

use terrane::file;

use super::Failure;

/// Start a project: two surfaces, an instance, a terrain and a scene
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  terrane new my_terrain && cd my_terrain && terrane render graphs/scenes/first_light.ron"
)]
pub(crate) struct New {
    /// The folder to make; it must not be there, or be empty
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

macro_rules! starter {
    ($($path:literal),* $(,)?) => {
        &[$(($path, include_str!(concat!("starter/", $path)))),*]
    };
}

/// What a new project consists of.
const FILES: &[(&str, &str)] = starter![
    "graphs/instances/ragged_edge.ron",
    "graphs/scenes/first_light.ron",
    "graphs/surfaces/meadow.ron",
    "graphs/surfaces/rock.ron",
    "graphs/terrains/land.ron",
    // Last: a folder without it is no project yet.
    "terrane.ron",
];

impl New {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let taken = std::fs::read_dir(&self.folder).is_ok_and(|mut entries| entries.next().is_some());
        if taken || self.folder.is_file() {
            let folder = self.folder.display();
            return Err(Failure::Usage(format!("{folder} is there already; name a folder that is not")));
        }
        for (path, text) in FILES {
            file::write(&self.folder.join(path), text.as_bytes())?;
        }
        println!("cd {}", self.folder.display());
        println!("terrane render graphs/scenes/first_light.ron -o first_light.png");
        Ok(())
    }
}
