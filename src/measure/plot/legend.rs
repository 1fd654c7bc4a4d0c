//! Which mark is whose.

use plotters::prelude::DrawingBackend;

use super::pen::{Pen, Result, Type};
use super::points::Chart;
use super::style::{GREY, INK, Mark};
use terrane_shaderlib::relief::Method;

/// The names of a figure, exact ones first.
pub(super) struct Legend {
    entries: Vec<Entry>,
}

struct Entry {
    name: String,
    exact: bool,
    mark: Mark,
}

/// Pixels of an entry's line.
const LINE: f64 = 22.0;
/// Pixels to a letter, and beside each name.
const LETTER: f64 = 7.4;
const BESIDE: f64 = 52.0;

impl Legend {
    /// Of all methods that the charts show, in their order.
    pub(super) fn new(charts: &[Chart]) -> Self {
        let mut entries: Vec<Entry> = Vec::new();
        for exact in [true, false] {
            let first = entries.len();
            let points = charts.iter().flat_map(|chart| &chart.points);
            for method in points.map(|point| point.method).filter(|method| method.is_exact() == exact) {
                let name = method.name();
                if !entries[first..].iter().any(|entry| entry.name == name) {
                    let mark = Mark::new(entries.len() - first, exact);
                    entries.push(Entry { name, exact, mark });
                }
            }
        }
        Self { entries }
    }

    /// The mark of a method.
    pub(super) fn mark(&self, method: Method) -> Mark {
        let (name, exact) = (method.name(), method.is_exact());
        let found = self.entries.iter().find(|entry| entry.name == name && entry.exact == exact);
        found.map_or(Mark::new(0, exact), |entry| entry.mark)
    }

    /// Columns that a width has room for, and pixels of one.
    fn columns(&self, width: f64) -> (usize, f64) {
        let longest = self.entries.iter().map(|entry| entry.text().chars().count()).max().unwrap_or(0);
        let column = BESIDE + LETTER * longest as f64;
        (((width / column) as usize).max(1), column)
    }

    /// Pixels down.
    pub(super) fn height(&self, width: f64) -> f64 {
        let (columns, _) = self.columns(width);
        self.entries.len().div_ceil(columns) as f64 * LINE + LINE
    }

    /// Draws it from a place to the right and down.
    pub(super) fn draw<B: DrawingBackend>(&self, pen: &Pen<'_, B>, [left, top]: [f64; 2], width: f64) -> Result {
        let (columns, column) = self.columns(width);
        for (index, entry) in self.entries.iter().enumerate() {
            let at = [left + (index % columns) as f64 * column + 10.0, top + (index / columns) as f64 * LINE];
            entry.mark.draw(pen, at, true)?;
            pen.text(&entry.text(), [at[0] + 14.0, at[1]], Type::new(14.0, INK))?;
        }
        let down = top + self.entries.len().div_ceil(columns) as f64 * LINE;
        let note = "Marks: largest error of any view; thin lines: down to the 99th percentile. Grey: what no other method \
                    beats. Crossed out: left rays undecided or wrong.";
        pen.text(note, [left, down], Type::new(13.0, GREY))
    }
}

impl Entry {
    fn text(&self) -> String {
        if self.exact { format!("{} (exact)", self.name) } else { self.name.clone() }
    }
}
