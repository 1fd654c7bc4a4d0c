//! All panels under one title.

use plotters::prelude::DrawingBackend;

use super::Cost;
use super::axis::Axis;
use super::legend::Legend;
use super::panel::Panel;
use super::pen::{Pen, Result, Type};
use super::points::{Chart, charts};
use super::style::{GREY, INK, WHITE};
use crate::measure::row::Row;
use crate::relief::Timing;

/// A figure, ready to be drawn.
pub(super) struct Figure {
    charts: Vec<Chart>,
    legend: Legend,
    axes: [Axis; 2],
    names: [&'static str; 2],
    title: String,
    views: String,
}

/// Pixels of a panel; one alone may be larger.
const PANEL: [f64; 2] = [460.0, 380.0];
const ALONE: [f64; 2] = [860.0, 600.0];
/// Panels beside each other, at most.
const BESIDE: usize = 3;
/// Pixels around all, and over the first panel.
const EDGE: f64 = 22.0;
const TITLE: f64 = 66.0;

impl Figure {
    pub(super) fn new(rows: &[Row], cost: Cost) -> Self {
        let charts = charts(rows, cost);
        let points = || charts.iter().flat_map(|chart| &chart.points);
        // The same axes in all panels, so that they compare.
        let costs = Axis::new(points().map(|point| point.cost));
        let errors = Axis::new(points().flat_map(|point| [point.max, point.p99]));
        Self {
            legend: Legend::new(&charts),
            axes: [costs, errors],
            names: [name(cost, rows.first().map(|row| row.timing)), "largest error, texels along the ray"],
            title: match cost {
                Cost::Time => "Relief: error against time".into(),
                Cost::Loads => "Relief: error against loads".into(),
            },
            views: views(rows),
            charts,
        }
    }

    fn panel(&self) -> [f64; 2] {
        if self.charts.len() == 1 { ALONE } else { PANEL }
    }

    /// Panels beside each other, and under.
    fn grid(&self) -> [usize; 2] {
        let columns = self.charts.len().clamp(1, BESIDE);
        [columns, self.charts.len().div_ceil(columns).max(1)]
    }

    fn width(&self) -> f64 {
        self.grid()[0] as f64 * self.panel()[0]
    }

    /// Columns and rows of pixels.
    pub(super) fn size(&self) -> [u32; 2] {
        let height = TITLE + self.grid()[1] as f64 * self.panel()[1] + self.legend.height(self.width());
        [(self.width() + 2.0 * EDGE) as u32, (height + 2.0 * EDGE) as u32]
    }

    pub(super) fn draw<B: DrawingBackend>(&self, pen: &Pen<'_, B>) -> Result {
        let [width, height] = self.size().map(f64::from);
        pen.fill([0.0; 2], [width, height], WHITE)?;
        pen.text(&self.title, [EDGE, EDGE + 8.0], Type { bold: true, ..Type::new(23.0, INK) })?;
        pen.text(&self.views, [EDGE, EDGE + 34.0], Type::new(14.0, GREY))?;
        let [columns, rows] = self.grid();
        for (index, chart) in self.charts.iter().enumerate() {
            let place = [(index % columns) as f64, (index / columns) as f64];
            let size = self.panel();
            let corner = [EDGE + place[0] * size[0], EDGE + TITLE + place[1] * size[1]];
            Panel { chart, legend: &self.legend, axes: self.axes, names: self.names, corner, size }.draw(pen)?;
        }
        let under = EDGE + TITLE + rows as f64 * self.panel()[1] + 12.0;
        self.legend.draw(pen, [EDGE, under], self.width())
    }
}

fn name(cost: Cost, timing: Option<Timing>) -> &'static str {
    match (cost, timing) {
        (Cost::Loads, _) => "loads a ray (nodes and patches, or samples)",
        (Cost::Time, Some(Timing::Device)) => "time a ray, ns (timestamps of the device)",
        (Cost::Time, Some(Timing::Processor)) => "time a ray, ns (processor, all cores)",
        (Cost::Time, _) => "time a ray, ns (wall's clock)",
    }
}

/// Which views the marks sum up.
fn views(rows: &[Row]) -> String {
    fn listed<T: PartialEq + ToString>(all: impl Iterator<Item = T>, unit: &str) -> String {
        let mut each: Vec<T> = Vec::new();
        for one in all {
            if !each.contains(&one) {
                each.push(one);
            }
        }
        each.iter().map(|one| one.to_string() + unit).collect::<Vec<_>>().join(", ")
    }
    format!(
        "{} texels a side; views from {} above the ground; depth {} of the side. Costs: geometric mean over the views.",
        listed(rows.iter().map(|row| row.side), ""),
        listed(rows.iter().map(|row| row.elevation), "°"),
        listed(rows.iter().map(|row| row.depth), ""),
    )
}
