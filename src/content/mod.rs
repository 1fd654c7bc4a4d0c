//! Content that the project makes itself: height maps of terrains, and materials that tile.
//!
//! A recipe is a pure function of its arguments and gives the same bytes on every machine and for every number of
//! threads: random numbers are integer hashes, transcendental functions come from `libm`, sums run in a fixed order.
//! Files know their recipe, so that [`make`] works only where something is missing or has changed.

pub mod canvas;
pub mod cells;
pub mod color;
pub mod field;
pub mod filter;
pub mod hash;
pub mod map;
pub mod material;
pub mod noise;
pub mod phasor;
pub mod recipe;
pub mod store;
pub mod terrain;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use terrane_codegen::graph::{Made, Project};

use crate::file::Error;
use recipe::{Arguments, Maker, maker};

/// Makes those of the project's recipes that give one of `files` (project-relative paths), where a file is missing or
/// was made by another recipe. Returns the files that it wrote. Progress goes to stderr if that is a terminal.
///
/// # Errors
/// If a file cannot be written: then it is as it was before.
pub fn make(project: &Project, files: &BTreeSet<String>) -> Result<Vec<PathBuf>, Error> {
    let wanted = |made: &&Made| made.files.iter().any(|(file, _)| files.contains(file));
    let made: Vec<&Made> = project.made.iter().filter(wanted).collect();
    make_under(project.root(), &made)
}

/// Like [`make`], for given recipes and a given folder.
///
/// # Errors
/// Those of [`make`].
pub fn make_under(root: &Path, made: &[&Made]) -> Result<Vec<PathBuf>, Error> {
    let due: Vec<Order> = made.iter().map(|made| Order::new(made, root)).filter(|order| !order.is_done()).collect();
    let bar = bar(due.len());
    let written = due.par_iter().map(|order| {
        bar.set_message(order.made.path.clone());
        let files = order.fill();
        bar.inc(1);
        files
    });
    let written = written.collect::<Result<Vec<_>, _>>();
    bar.finish_and_clear();
    Ok(written?.concat())
}

fn bar(count: usize) -> ProgressBar {
    if count == 0 {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(count as u64);
    let style = ProgressStyle::with_template("making {bar:30} {pos}/{len} {wide_msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.enable_steady_tick(std::time::Duration::from_millis(200));
    bar
}

/// One recipe to be made in one place.
struct Order<'a> {
    made: &'a Made,
    maker: &'static Maker,
    arguments: Arguments,
    root: &'a Path,
}

impl<'a> Order<'a> {
    fn new(made: &'a Made, root: &'a Path) -> Self {
        Self { made, maker: maker(made.recipe.name), arguments: Arguments::of(made), root }
    }

    /// What the files are marked with.
    fn mark(&self) -> String {
        format!("{}({}) revision {}", self.maker.name, self.arguments.text(), self.maker.revision)
    }

    fn is_done(&self) -> bool {
        let mark = self.mark();
        self.made.files.iter().all(|(file, _)| store::is_current(&self.root.join(file), &mark))
    }

    fn fill(&self) -> Result<Vec<PathBuf>, Error> {
        let mark = self.mark();
        let start = Instant::now();
        let maps = (self.maker.make)(&self.arguments);
        log::debug!("{}: {:.3} s", self.made.path, start.elapsed().as_secs_f64());
        let write = |((file, _), map): (&(String, _), &map::Map)| {
            let path = self.root.join(file);
            store::write(&path, map, &mark).map(|()| path)
        };
        self.made.files.iter().zip(&maps).map(write).collect()
    }
}
