//! Colours and marks of methods.

use plotters::prelude::{DrawingBackend, RGBColor};

use super::pen::{At, Pen, Result};

pub(super) const WHITE: RGBColor = RGBColor(255, 255, 255);
pub(super) const INK: RGBColor = RGBColor(34, 34, 34);
pub(super) const GREY: RGBColor = RGBColor(110, 110, 110);
pub(super) const FRAME: RGBColor = RGBColor(150, 150, 150);
pub(super) const GRID: RGBColor = RGBColor(222, 222, 222);
pub(super) const FAINT: RGBColor = RGBColor(241, 241, 241);
pub(super) const FRONT: RGBColor = RGBColor(205, 205, 205);

/// Told apart by people who see no red or no green as well. Source: Okabe and Ito, "Color Universal Design", 2008; without
/// its yellow, which white paper swallows, and with a brown.
const COLORS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(60, 60, 60),
    RGBColor(140, 86, 45),
];

/// How a method is marked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mark {
    color: RGBColor,
    shape: Shape,
    exact: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    Circle,
    Square,
    Triangle,
    Diamond,
    Star,
}

impl Mark {
    /// That of the method at a place among those of its kind. Exact ones are diamonds and stars with a dark border.
    pub(super) fn new(index: usize, exact: bool) -> Self {
        let shapes = if exact {
            &[Shape::Diamond, Shape::Star][..]
        } else {
            &[Shape::Circle, Shape::Square, Shape::Triangle][..]
        };
        // The second kind begins elsewhere, so that few methods of either kind share no colour.
        let color = COLORS[(index + if exact { 0 } else { 4 }) % COLORS.len()];
        Self { color, shape: shapes[index / COLORS.len() % shapes.len()], exact }
    }

    pub(super) fn color(self) -> RGBColor {
        self.color
    }

    /// Draws it; `decided` is false where the method left rays wrong, which a cross shows.
    pub(super) fn draw<B: DrawingBackend>(self, pen: &Pen<'_, B>, at: At, decided: bool) -> Result {
        let radius = if self.exact { 6.5 } else { 4.2 };
        self.shape(pen, at, radius + 1.4, if self.exact { INK } else { WHITE })?;
        self.shape(pen, at, radius, self.color)?;
        if decided {
            return Ok(());
        }
        for side in [1.0, -1.0] {
            pen.line(&[[at[0] - 6.0, at[1] - 6.0 * side], [at[0] + 6.0, at[1] + 6.0 * side]], INK, 1.5)?;
        }
        Ok(())
    }

    fn shape<B: DrawingBackend>(self, pen: &Pen<'_, B>, at: At, radius: f64, color: RGBColor) -> Result {
        /// Corners at so many steps of a turn, as far out as each of `reach` in turn.
        fn corners(at: At, radius: f64, count: u32, reach: [f64; 2], turn: f64) -> Vec<At> {
            let corner = |index: u32| {
                let angle = (f64::from(index) / f64::from(count) + turn) * std::f64::consts::TAU;
                let far = radius * reach[index as usize % 2];
                [at[0] + far * libm::sin(angle), at[1] - far * libm::cos(angle)]
            };
            (0..count).map(corner).collect()
        }
        match self.shape {
            Shape::Circle => pen.circle(at, radius, color),
            Shape::Square => pen.polygon(&corners(at, 1.25 * radius, 4, [1.0; 2], 0.125), color),
            Shape::Triangle => pen.polygon(&corners(at, 1.35 * radius, 3, [1.0; 2], 0.0), color),
            Shape::Diamond => pen.polygon(&corners(at, 1.1 * radius, 4, [1.0; 2], 0.0), color),
            Shape::Star => pen.polygon(&corners(at, 1.25 * radius, 10, [1.0, 0.5], 0.0), color),
        }
    }
}
