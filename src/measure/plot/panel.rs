//! One map's methods on two axes.

use plotters::prelude::DrawingBackend;

use super::axis::Axis;
use super::legend::Legend;
use super::pen::{At, Pen, Result, Type};
use super::points::{Chart, Point};
use super::style::{FAINT, FRAME, FRONT, GREY, GRID, INK, WHITE};
use terrane_shaderlib::relief::Method;

/// Where a panel stands, and what it shows.
pub(super) struct Panel<'a> {
    pub(super) chart: &'a Chart,
    pub(super) legend: &'a Legend,
    /// Of what the methods cost, and of their errors.
    pub(super) axes: [Axis; 2],
    /// The names of both.
    pub(super) names: [&'static str; 2],
    /// The upper left corner and the size, with everything around the axes.
    pub(super) corner: At,
    pub(super) size: [f64; 2],
}

/// Pixels around the axes: left, above, right, below.
const MARGIN: [f64; 4] = [74.0, 62.0, 14.0, 50.0];

impl Panel<'_> {
    /// The place of two parts of the axes.
    fn place(&self, [along, up]: [f64; 2]) -> At {
        let [left, above, right, below] = MARGIN;
        let [width, height] = [self.size[0] - left - right, self.size[1] - above - below];
        [self.corner[0] + left + width * along, self.corner[1] + above + height * (1.0 - up)]
    }

    fn at(&self, cost: f64, error: f64) -> At {
        self.place([self.axes[0].at(cost), self.axes[1].at(error)])
    }

    pub(super) fn draw<B: DrawingBackend>(&self, pen: &Pen<'_, B>) -> Result {
        pen.fill(self.place([0.0, 1.0]), self.place([1.0, 0.0]), WHITE)?;
        self.grid(pen)?;
        self.front(pen)?;
        self.families(pen)?;
        for exact in [false, true] {
            for point in self.chart.points.iter().filter(|point| point.method.is_exact() == exact) {
                self.point(pen, point)?;
            }
        }
        self.frame(pen)?;
        self.words(pen)
    }

    fn grid<B: DrawingBackend>(&self, pen: &Pen<'_, B>) -> Result {
        for (axis, across) in self.axes.into_iter().zip([false, true]) {
            for tick in axis.ticks() {
                let end = |end: f64| self.place(if across { [end, tick.at] } else { [tick.at, end] });
                pen.line(&[end(0.0), end(1.0)], if tick.label.is_some() { GRID } else { FAINT }, 1.0)?;
                let Some(label) = &tick.label else { continue };
                let [x, y] = end(0.0);
                let (at, anchor) = if across { ([x - 7.0, y], 1.0) } else { ([x, y + 13.0], 0.5) };
                pen.text(label, at, Type { anchor, ..Type::new(13.0, INK) })?;
            }
        }
        Ok(())
    }

    fn frame<B: DrawingBackend>(&self, pen: &Pen<'_, B>) -> Result {
        let corners = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]].map(|at| self.place(at));
        pen.line(&corners, FRAME, 1.0)?;
        let Some(gap) = self.axes[1].broken() else { return Ok(()) };
        // Two strokes through both sides, and white between them.
        for side in [0.0, 1.0] {
            let [x, y] = self.place([side, gap]);
            pen.polygon(&[[x - 6.0, y + 1.0], [x + 6.0, y - 5.0], [x + 6.0, y - 1.0], [x - 6.0, y + 5.0]], WHITE)?;
            for off in [-2.0, 2.0] {
                pen.line(&[[x - 6.0, y + 3.0 + off], [x + 6.0, y - 3.0 + off]], FRAME, 1.0)?;
            }
        }
        Ok(())
    }

    /// What no other method beats, as stairs.
    fn front<B: DrawingBackend>(&self, pen: &Pen<'_, B>) -> Result {
        let points: Vec<At> = self.chart.front().iter().map(|point| self.at(point.cost, point.max)).collect();
        let Some((first, last)) = points.first().zip(points.last()) else { return Ok(()) };
        let stairs = points.windows(2).flat_map(|pair| [pair[0], [pair[1][0], pair[0][1]]]);
        let (top, right) = (self.place([0.0, 1.0])[1], self.place([1.0, 0.0])[0]);
        let line: Vec<At> = std::iter::once([first[0], top]).chain(stairs).chain([*last, [right, last[1]]]).collect();
        pen.line(&line, FRONT, 4.0)
    }

    /// A line through the budgets of each method.
    fn families<B: DrawingBackend>(&self, pen: &Pen<'_, B>) -> Result {
        let mut names: Vec<String> = Vec::new();
        for point in &self.chart.points {
            let name = point.method.name();
            if names.contains(&name) {
                continue;
            }
            let mut budgets: Vec<&Point> =
                self.chart.points.iter().filter(|other| other.method.name() == name).collect();
            budgets.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            let line: Vec<At> = budgets.iter().map(|point| self.at(point.cost, point.max)).collect();
            if line.len() > 1 {
                pen.line(&line, self.legend.mark(point.method).color(), 1.5)?;
            }
            names.push(name);
        }
        Ok(())
    }

    fn point<B: DrawingBackend>(&self, pen: &Pen<'_, B>, point: &Point) -> Result {
        let mark = self.legend.mark(point.method);
        let at = self.at(point.cost, point.max);
        pen.line(&[at, self.at(point.cost, point.p99)], mark.color(), 1.0)?;
        mark.draw(pen, at, point.decided)?;
        match budget(point.method) {
            Some(budget) => pen.text(&budget, [at[0] + 9.0, at[1] - 9.0], Type::new(12.0, GREY)),
            None => Ok(()),
        }
    }

    fn words<B: DrawingBackend>(&self, pen: &Pen<'_, B>) -> Result {
        let left = self.place([0.0, 1.0])[0];
        let top = self.corner[1];
        pen.text(&self.chart.map, [left, top + 12.0], Type { bold: true, ..Type::new(17.0, INK) })?;
        for (line, exact) in [true, false].into_iter().enumerate() {
            let Some(point) = self.chart.worst(exact) else { continue };
            let kind = if exact { "worst exact" } else { "worst of the rest" };
            let text = format!("{kind}: {} texels, {} ({})", rounded(point.max), point.method, point.worst);
            pen.text(&text, [left, top + 32.0 + 17.0 * line as f64], Type::new(12.0, GREY))?;
        }
        let [x, y] = self.place([0.5, 0.0]);
        pen.text(self.names[0], [x, y + 34.0], Type { anchor: 0.5, ..Type::new(13.5, INK) })?;
        let [x, y] = self.place([0.0, 0.5]);
        pen.text(self.names[1], [x - 58.0, y], Type { anchor: 0.5, rises: true, ..Type::new(13.5, INK) })
    }
}

/// What stands in a method's brackets.
fn budget(method: Method) -> Option<String> {
    let text = method.to_string();
    Some(text.split_once('(')?.1.trim_end_matches(')').to_owned())
}

/// Two digits that count.
fn rounded(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let decimals = (1 - value.log10().floor() as i32).clamp(0, 9) as usize;
    format!("{value:.decimals$}")
}
