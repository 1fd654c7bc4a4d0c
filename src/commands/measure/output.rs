//! The files of `terrane measure -o`.

use std::path::{Path, PathBuf};

use terrane::file;
use terrane::measure::{Cost, Plot, Row, csv};

use super::super::Failure;

/// The plots, and what is added to the name of the file of values.
const PLOTS: [(Cost, &str); 2] = [(Cost::Time, "time"), (Cost::Loads, "loads")];

/// Whether all of them can be written; of pyramids there are only values.
pub(super) fn check(path: &Path, values_only: bool) -> Result<(), Failure> {
    file::check(path)?;
    let plots = PLOTS.iter().flat_map(|(_, word)| ["svg", "png"].map(|ending| beside(path, word, ending)));
    for plot in plots.filter(|_| !values_only) {
        file::check(&plot)?;
    }
    Ok(())
}

/// Writes values and plots.
pub(super) fn write(path: &Path, rows: &[Row]) -> Result<(), Failure> {
    file::write(path, csv(rows).as_bytes())?;
    for (cost, word) in PLOTS {
        let plot = Plot { rows, cost };
        let failed = |error: terrane::measure::PlotError| Failure::Machine(error.to_string());
        file::write(&beside(path, word, "svg"), plot.svg().map_err(failed)?.as_bytes())?;
        plot.image().map_err(failed)?.write_png(&beside(path, word, "png"))?;
    }
    Ok(())
}

/// `rock_time.svg` beside `rock.csv`.
fn beside(path: &Path, word: &str, ending: &str) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}_{word}.{ending}"))
}
