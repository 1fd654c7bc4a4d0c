//! What the bounds of a map cost: bytes, and time to build on all cores and on a device.

use std::fmt::Write as _;
use std::time::Instant;

use terrane_shaderlib::heightfield::Heights;
use terrane_shaderlib::heightfield::pyramid::{Bound, Pyramid, Wide};
use terrane_shaderlib::relief::{Bounds, MapTexture, Method, Placed, Region};

use super::subject::Subject;
use crate::relief::{Built as Textures, BuiltPyramid};
use crate::render::{Gpu, RenderError};

/// One kind of bounds of one map.
#[derive(Clone, Debug, PartialEq)]
pub struct Built {
    /// The map.
    pub map: String,
    /// Its texels a side.
    pub side: u32,
    /// `pyramid` for one of the map itself, `placed` for all that a device gets of it, with those of its mips.
    pub form: &'static str,
    /// Which bounds.
    pub bounds: String,
    /// Bytes to a texel of the map.
    pub bytes: f64,
    /// Milliseconds by the wall's clock: the middle of several.
    pub time: f64,
    /// The same on the device, from the map in the processor's memory until all that shaders read is there, placed heights as
    /// well; `None` without a device, and for what it does not build.
    pub device: Option<f64>,
}

/// Every kind of pyramid over a map, and everything that the methods ask for.
///
/// # Errors
/// Where the map cannot be placed, or the device fails.
pub fn pyramids(subject: &Subject, rounds: u32, gpu: Option<&Gpu>) -> Result<Vec<Built>, RenderError> {
    let heights = &subject.heights;
    let texels = heights.size().map(f64::from).iter().product::<f64>();
    let mut all = Vec::new();
    let mut add = |form, bounds: String, (time, bytes): (f64, usize), device| {
        let (map, side) = (subject.name.clone(), heights.size()[0]);
        all.push(Built { map, side, form, bounds, bytes: bytes as f64 / texels, time, device });
    };
    for bound in [Bound::TexelMax, Bound::CellMax, Bound::CellMin] {
        let host = timed(rounds, || Ok(Pyramid::new(heights, bound).bytes()))?;
        let device = gpu.map(|gpu| pyramid_on(gpu, heights, bound, rounds)).transpose()?;
        add("pyramid", words(&bound), host, device);
    }
    if Wide::new(heights).is_ok() {
        let host = timed(rounds, || Ok(Wide::new(heights).map_or(0, |wide| wide.bytes())))?;
        add("pyramid", "wide".into(), host, None);
    }
    for bounds in placed() {
        let place = || Placed::new(heights, bounds, 1).map_err(|error| RenderError::Scene(error.to_string()));
        let host = timed(rounds, || Ok(place()?.bounds.bytes()))?;
        let device = gpu.map(|gpu| placed_on(gpu, heights, bounds, rounds)).transpose()?;
        add("placed", words(&bounds), host, device);
    }
    Ok(all)
}

/// Milliseconds that a device takes for a pyramid.
fn pyramid_on(gpu: &Gpu, heights: &Heights, bound: Bound, rounds: u32) -> Result<f64, RenderError> {
    let built = BuiltPyramid::new(gpu, heights, bound)?;
    timed_on(gpu, rounds, || built.update(heights, &whole(heights)))
}

/// Milliseconds that a device takes for the textures of a method.
fn placed_on(gpu: &Gpu, heights: &Heights, bounds: Bounds, rounds: u32) -> Result<f64, RenderError> {
    let textures: Vec<MapTexture> = bounds.surface().into_iter().chain([MapTexture::Bounds(bounds)]).collect();
    let built = Textures::new(gpu, heights, &textures)?;
    timed_on(gpu, rounds, || built.update(heights, &whole(heights)))
}

fn whole(heights: &Heights) -> Region {
    heights.size().map(|side| 0..side)
}

/// Milliseconds until a device is done; it has nothing left to do when this begins.
fn timed_on(gpu: &Gpu, rounds: u32, build: impl Fn() -> Result<(), RenderError>) -> Result<f64, RenderError> {
    gpu.wait()?;
    let (time, _) = timed(rounds, || {
        build()?;
        gpu.wait()?;
        Ok(0)
    })?;
    Ok(time)
}

/// The bounds of all methods.
fn placed() -> Vec<Bounds> {
    let mut bounds: Vec<Bounds> = Method::all().into_iter().map(Method::bounds).collect();
    bounds.sort_unstable();
    bounds.dedup();
    bounds
}

/// `CellMax` as `cell_max`, `Cones(Step)` as `cones(step)`.
fn words(name: &impl std::fmt::Debug) -> String {
    let mut words = String::new();
    for letter in format!("{name:?}").chars() {
        if letter.is_uppercase() && words.ends_with(char::is_alphanumeric) {
            words.push('_');
        }
        words.extend(letter.to_lowercase());
    }
    words
}

/// Milliseconds that it takes, and what it gives.
fn timed(rounds: u32, build: impl Fn() -> Result<usize, RenderError>) -> Result<(f64, usize), RenderError> {
    let mut bytes = 0;
    let mut times = Vec::new();
    for _ in 0..rounds.max(1) {
        let start = Instant::now();
        bytes = std::hint::black_box(build()?);
        times.push(start.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_by(f64::total_cmp);
    Ok((times[times.len() / 2], bytes))
}

/// Comma-separated values with a head line.
#[must_use]
pub fn pyramids_csv(all: &[Built]) -> String {
    let lines = all.iter().map(|one| {
        let Built { map, side, form, bounds, bytes, time, device } = one;
        let device = device.map_or_else(String::new, |time| time.to_string());
        format!("{map},{side},{form},{bounds},{bytes},{time},{device}\n")
    });
    std::iter::once("map,side,form,bounds,bytes_per_texel,time_ms,device_ms\n".to_owned()).chain(lines).collect()
}

/// The same for the eye.
#[must_use]
pub fn pyramids_table(all: &[Built]) -> String {
    let mut text =
        String::from("map           side  form     bounds             bytes/texel  build ms  on the device\n");
    for Built { map, side, form, bounds, bytes, time, device } in all {
        let device = device.map_or_else(|| "-".into(), |time| format!("{time:.2}"));
        let _ =
            writeln!(text, "{map:<12} {side:>5}  {form:<7}  {bounds:<17}  {bytes:>11.3}  {time:>8.2}  {device:>13}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::maps::BuiltIn;
    use super::*;

    #[test]
    fn bytes_are_those_of_their_definition() {
        let subject = BuiltIn::named("hills").unwrap().make(64);
        let all = pyramids(&subject, 1, None).unwrap();
        let bytes = |form: &str, bounds: &str| {
            let found = all.iter().find(|one| one.form == form && one.bounds == bounds);
            found.unwrap_or_else(|| panic!("{form} {bounds} in {all:?}")).bytes
        };
        // Two bytes of 4^6 texels and of all levels over them.
        let levels: u32 = (0..=6).map(|level| 4_u32.pow(level)).sum();
        assert_eq!(bytes("pyramid", "cell_max"), f64::from(2 * levels) / 4096.0);
        assert_eq!(bytes("pyramid", "texel_max"), bytes("pyramid", "cell_min"));
        // An image as high again as the map.
        assert_eq!(bytes("placed", "cell_max"), 4.0);
        assert!(all.iter().all(|one| one.time > 0.0 && one.side == 64 && one.device.is_none()));
        assert_eq!(pyramids_csv(&all).lines().count(), all.len() + 1);
        assert_eq!(pyramids_table(&all).lines().count(), all.len() + 1);
    }
}
