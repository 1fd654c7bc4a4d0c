//! Content that the project makes itself: height maps of terrains, and materials that tile.
//!
//! A recipe is a pure function of its arguments and gives the same bytes on every machine and for every number of
//! threads: random numbers are integer hashes, transcendental functions come from `libm`, sums run in a fixed order.
//! Files know their recipe, so that [`make`] works only where something is missing or has changed.

pub mod canvas;
pub mod cells;
pub mod color;
pub mod error;
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

use std::path::{Path, PathBuf};

use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

pub use error::Error;
pub use recipe::Recipe;
use recipe::{Arguments, Maker};

/// One entry of a project's `made`.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// Beginning of the file names, relative to the project root: `textures/granite`.
    pub key: String,
    /// What to make.
    pub recipe: Recipe,
}

/// A job whose recipe is known and whose arguments are complete.
struct Order<'a> {
    job: &'a Job,
    maker: &'static Maker,
    arguments: Arguments,
}

/// Makes what is missing under `root`, or was made by another recipe. Returns the files that it wrote. Progress goes to
/// stderr if that is a terminal.
///
/// # Errors
/// If a recipe or an argument is unknown or out of range: then nothing is made. If a file cannot be written: then it is
/// as it was before.
pub fn make(jobs: &[Job], root: &Path) -> Result<Vec<PathBuf>, Error> {
    let orders = jobs.iter().map(Order::new).collect::<Result<Vec<_>, _>>()?;
    let due: Vec<_> = orders.iter().filter(|order| !order.is_done(root)).collect();
    let bar = bar(due.len());
    let written = due
        .par_iter()
        .map(|order| {
            bar.set_message(order.job.key.clone());
            let files = order.fill(root);
            bar.inc(1);
            files
        })
        .collect::<Result<Vec<_>, _>>();
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

impl<'a> Order<'a> {
    fn new(job: &'a Job) -> Result<Self, Error> {
        let unknown = || Error::UnknownRecipe { key: job.key.clone(), name: job.recipe.name.clone() };
        let maker = recipe::find(&job.recipe.name).ok_or_else(unknown)?;
        let arguments = Arguments::complete(&job.key, maker, &job.recipe.args)?;
        Ok(Self { job, maker, arguments })
    }

    /// What the files are marked with.
    fn mark(&self) -> String {
        format!("{}({}) revision {}", self.maker.name, self.arguments.text(), self.maker.revision)
    }

    fn path(&self, root: &Path, suffix: &str) -> PathBuf {
        root.join(format!("{}{suffix}.png", self.job.key))
    }

    fn is_done(&self, root: &Path) -> bool {
        let mark = self.mark();
        self.maker.suffixes.iter().all(|suffix| store::is_current(&self.path(root, suffix), &mark))
    }

    fn fill(&self, root: &Path) -> Result<Vec<PathBuf>, Error> {
        let mark = self.mark();
        let write = |map: &map::Map| {
            let path = self.path(root, map.suffix);
            store::write(&path, map, &mark).map(|()| path)
        };
        (self.maker.make)(&self.arguments).iter().map(write).collect()
    }
}
