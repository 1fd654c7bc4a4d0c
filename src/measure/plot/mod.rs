//! Error against what it costs, on logarithmic axes, a panel for each map.

mod axis;
mod figure;
mod legend;
mod panel;
mod pen;
mod points;
mod style;

use plotters::prelude::{BitMapBackend, IntoDrawingArea as _, SVGBackend};

use super::row::Row;
use crate::render::Image;
use figure::Figure;
use pen::Pen;

pub use pen::PlotError;

/// What an error is set against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cost {
    /// Nanoseconds a ray.
    Time,
    /// Nodes and patches, or samples, a ray.
    Loads,
}

/// Rows as a picture. Equal rows give equal bytes.
#[derive(Clone, Copy, Debug)]
pub struct Plot<'a> {
    /// What was measured.
    pub rows: &'a [Row],
    /// What the error is set against.
    pub cost: Cost,
}

/// Pixels of a PNG to a pixel of the drawing.
const FINE: u32 = 2;
/// Samples of such a pixel on a side: the drawing library knows no soft edges.
const SAMPLES: u32 = 2;

impl Plot<'_> {
    /// As SVG, whose text any font draws.
    ///
    /// # Errors
    /// If the drawing library refuses.
    pub fn svg(&self) -> Result<String, PlotError> {
        let figure = Figure::new(self.rows, self.cost);
        let mut text = String::new();
        let area = SVGBackend::with_string(&mut text, figure.size().into()).into_drawing_area();
        figure.draw(&Pen::new(&area, 1))?;
        drop(area);
        Ok(text)
    }

    /// As an image of twice as many pixels.
    ///
    /// # Errors
    /// If the drawing library refuses.
    pub fn image(&self) -> Result<Image, PlotError> {
        let figure = Figure::new(self.rows, self.cost);
        let scale = FINE * SAMPLES;
        let [width, height] = figure.size().map(|side| side * scale);
        let mut pixels = vec![255; width as usize * height as usize * 3];
        {
            let area = BitMapBackend::with_buffer(&mut pixels, (width, height)).into_drawing_area();
            figure.draw(&Pen::new(&area, scale))?;
        }
        Ok(halved(&pixels, [width, height]))
    }
}

/// Each pixel the mean of its samples.
fn halved(samples: &[u8], [width, height]: [u32; 2]) -> Image {
    let [columns, rows] = [width / SAMPLES, height / SAMPLES];
    let stride = width as usize * 3;
    let mut pixels = Vec::with_capacity(columns as usize * rows as usize * 3);
    for (y, x, channel) in (0..rows as usize)
        .flat_map(|y| (0..columns as usize).flat_map(move |x| (0..3).map(move |channel| (y, x, channel))))
    {
        let first = y * SAMPLES as usize * stride + x * SAMPLES as usize * 3 + channel;
        let offsets = (0..SAMPLES as usize).flat_map(|j| (0..SAMPLES as usize).map(move |i| j * stride + 3 * i));
        let sum: u32 = offsets.map(|offset| u32::from(samples[first + offset])).sum();
        pixels.push(((sum + SAMPLES * SAMPLES / 2) / (SAMPLES * SAMPLES)) as u8);
    }
    Image { width: columns, height: rows, pixels }
}

#[cfg(test)]
mod tests;
