//! Lines, marks and text on any backend of the drawing library, in pixels of the drawing.

use std::fmt;
use std::sync::Once;

use plotters::coord::Shift;
use plotters::prelude::{Circle, DrawingArea, DrawingBackend, PathElement, Polygon, RGBColor, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, FontDesc, FontFamily, FontStyle, FontTransform, TextStyle, register_font};

/// The drawing library's own words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlotError(String);

impl fmt::Display for PlotError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "the plot cannot be drawn: {}", self.0)
    }
}

impl std::error::Error for PlotError {}

pub(super) type Result = std::result::Result<(), PlotError>;

/// A place in pixels of the drawing.
pub(super) type At = [f64; 2];

/// How text looks.
#[derive(Clone, Copy)]
pub(super) struct Type {
    /// Height of a line in pixels.
    pub(super) size: f64,
    pub(super) bold: bool,
    pub(super) color: RGBColor,
    /// Which part of it stands at its place, from 0 at the left to 1 at the right.
    pub(super) anchor: f64,
    /// From the bottom upwards.
    pub(super) rises: bool,
}

impl Type {
    /// Text that begins at its place.
    pub(super) fn new(size: f64, color: RGBColor) -> Self {
        Self { size, bold: false, color, anchor: 0.0, rises: false }
    }
}

/// A pen on a drawing.
pub(super) struct Pen<'a, B: DrawingBackend> {
    area: &'a DrawingArea<B, Shift>,
    scale: f64,
}

impl<'a, B: DrawingBackend> Pen<'a, B> {
    /// A pen that draws so many pixels of the backend for one of the drawing.
    pub(super) fn new(area: &'a DrawingArea<B, Shift>, scale: u32) -> Self {
        fonts();
        Self { area, scale: f64::from(scale) }
    }

    fn at(&self, [x, y]: At) -> (i32, i32) {
        ((x * self.scale).round() as i32, (y * self.scale).round() as i32)
    }

    fn width(&self, width: f64) -> u32 {
        (width * self.scale).round().max(1.0) as u32
    }

    pub(super) fn line(&self, points: &[At], color: RGBColor, width: f64) -> Result {
        let points: Vec<(i32, i32)> = points.iter().map(|at| self.at(*at)).collect();
        said(self.area.draw(&PathElement::new(points, color.stroke_width(self.width(width)))))
    }

    pub(super) fn polygon(&self, points: &[At], color: RGBColor) -> Result {
        let points: Vec<(i32, i32)> = points.iter().map(|at| self.at(*at)).collect();
        said(self.area.draw(&Polygon::new(points, color.filled())))
    }

    pub(super) fn circle(&self, at: At, radius: f64, color: RGBColor) -> Result {
        said(self.area.draw(&Circle::new(self.at(at), self.width(radius), color.filled())))
    }

    pub(super) fn fill(&self, from: At, to: At, color: RGBColor) -> Result {
        said(self.area.draw(&Rectangle::new([self.at(from), self.at(to)], color.filled())))
    }

    /// Text whose middle is at the height of its place.
    pub(super) fn text(&self, text: &str, at: At, look: Type) -> Result {
        let style = if look.bold { FontStyle::Bold } else { FontStyle::Normal };
        let anchor = match look.anchor {
            anchor if anchor < 0.25 => HPos::Left,
            anchor if anchor < 0.75 => HPos::Center,
            _ => HPos::Right,
        };
        let turn = if look.rises { FontTransform::Rotate270 } else { FontTransform::None };
        let font = FontDesc::new(FontFamily::SansSerif, look.size * self.scale, style).transform(turn);
        let style = TextStyle::from(font).color(&look.color).pos(Pos::new(anchor, VPos::Center));
        said(self.area.draw(&Text::new(text, self.at(at), style)))
    }
}

fn said<E: std::error::Error + Send + Sync>(
    result: std::result::Result<(), plotters::drawing::DrawingAreaErrorKind<E>>,
) -> Result {
    result.map_err(|error| PlotError(error.to_string()))
}

/// The same letters on every machine: those of the system's fonts would differ.
fn fonts() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let faces = [
            (FontStyle::Normal, &include_bytes!("font/regular.ttf")[..]),
            (FontStyle::Bold, &include_bytes!("font/bold.ttf")[..]),
        ];
        for (style, bytes) in faces {
            // A face that cannot be read is missed, and said, when text is drawn.
            let _ = register_font("sans-serif", style, bytes);
        }
    });
}
