//! What the bounds of a map cost: bytes, and time to build and to bring up to date, on all cores and on a device.

mod brush;
mod told;

use std::time::Instant;

use terrane_shaderlib::heightfield::Heights;
use terrane_shaderlib::heightfield::pyramid::{Bound, Pyramid, Wide};
use terrane_shaderlib::relief::{Bounds, MapTexture, Method, Placed, Region};

use self::brush::Stroke;
pub use self::told::{pyramids_csv, pyramids_table};
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
    /// On all cores.
    pub host: Spent,
    /// On the device, from the map in the processor's memory until all that shaders read is there, placed heights as
    /// well; `None` without a device, and for what it does not build.
    pub device: Option<Spent>,
}

/// Milliseconds by the wall's clock: the middle of several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spent {
    /// For all of it.
    pub build: f64,
    /// For what a stroke of 32 by 32 texels in the middle changes.
    pub update: f64,
}

/// Every kind of pyramid over a map, and everything that the methods ask for.
///
/// # Errors
/// Where the map cannot be placed, or the device fails.
pub fn pyramids(subject: &Subject, rounds: u32, gpu: Option<&Gpu>) -> Result<Vec<Built>, RenderError> {
    let heights = &subject.heights;
    let stroke = Stroke::new(heights);
    let texels = heights.size().map(f64::from).iter().product::<f64>();
    let mut all = Vec::new();
    let mut add = |form, bounds: String, (host, bytes): (Spent, usize), device| {
        let (map, side) = (subject.name.clone(), heights.size()[0]);
        all.push(Built { map, side, form, bounds, bytes: bytes as f64 / texels, host, device });
    };
    for bound in [Bound::TexelMax, Bound::CellMax, Bound::CellMin] {
        let host = times(rounds, &stroke, &|map| Ok(Pyramid::new(map, bound)), &|pyramid, map| {
            pyramid.update(map, stroke.texels.clone());
            Ok(())
        })?;
        let device = gpu.map(|gpu| pyramid_on(gpu, &stroke, bound, rounds)).transpose()?;
        add("pyramid", words(&bound), (host.0, host.1.bytes()), device);
    }
    if Wide::new(heights).is_ok() {
        let (host, bytes) = wide(&stroke, rounds)?;
        add("pyramid", "wide".into(), (host, bytes), None);
    }
    for bounds in placed() {
        let place = |map: &Heights| Placed::new(map, bounds, 1).map_err(|error| RenderError::Scene(error.to_string()));
        let host = times(rounds, &stroke, &place, &|placed, map| {
            placed.update(map, bounds, &stroke.texels);
            Ok(())
        })?;
        let device = gpu.map(|gpu| placed_on(gpu, &stroke, bounds, rounds)).transpose()?;
        add("placed", words(&bounds), (host.0, host.1.bounds.bytes()), device);
    }
    Ok(all)
}

/// A wide pyramid, with the pyramid that it is packed from.
fn wide(stroke: &Stroke, rounds: u32) -> Result<(Spent, usize), RenderError> {
    let build = |map: &Heights| {
        let pyramid = Pyramid::new(map, Bound::CellMax);
        let wide = Wide::over(&pyramid).map_err(|error| RenderError::Scene(error.to_string()))?;
        Ok((pyramid, wide))
    };
    let (times, (_, wide)) = times(rounds, stroke, &build, &|(pyramid, wide), map| {
        pyramid.update(map, stroke.texels.clone());
        wide.update(pyramid, map, &stroke.texels);
        Ok(())
    })?;
    Ok((times, wide.bytes()))
}

/// What a device takes for a pyramid.
fn pyramid_on(gpu: &Gpu, stroke: &Stroke, bound: Bound, rounds: u32) -> Result<Spent, RenderError> {
    let built = BuiltPyramid::new(gpu, &stroke.maps[0], bound)?;
    on(gpu, rounds, stroke, &built, |built, map, texels| built.update(map, texels))
}

/// What a device takes for the textures of a method.
fn placed_on(gpu: &Gpu, stroke: &Stroke, bounds: Bounds, rounds: u32) -> Result<Spent, RenderError> {
    let textures: Vec<MapTexture> = bounds.surface().into_iter().chain([MapTexture::Bounds(bounds)]).collect();
    let built = Textures::new(gpu, &stroke.maps[0], &textures)?;
    on(gpu, rounds, stroke, &built, |built, map, texels| built.update(map, texels))
}

/// Spent what is built, and brought up to date with a stroke that comes and goes.
fn times<T>(
    rounds: u32,
    stroke: &Stroke,
    build: &dyn Fn(&Heights) -> Result<T, RenderError>,
    update: &dyn Fn(&mut T, &Heights) -> Result<(), RenderError>,
) -> Result<(Spent, T), RenderError> {
    let mut built = None;
    let whole = timed(rounds, |_| {
        // Two at once may be more than there is room for.
        built = None;
        built = Some(build(&stroke.maps[0])?);
        Ok(())
    })?;
    let mut built = built.expect("there is at least one round");
    let part = timed(rounds, |round| update(&mut built, &stroke.maps[(round + 1) % 2]))?;
    Ok((Spent { build: whole, update: part }, built))
}

/// The same until a device is done; it has nothing left to do when this begins.
fn on<T>(
    gpu: &Gpu,
    rounds: u32,
    stroke: &Stroke,
    built: &T,
    update: impl Fn(&T, &Heights, &Region) -> Result<(), RenderError>,
) -> Result<Spent, RenderError> {
    gpu.wait()?;
    let until_done = |texels: &Region| {
        timed(rounds, |round| {
            update(built, &stroke.maps[(round + 1) % 2], texels)?;
            gpu.wait()
        })
    };
    let build = until_done(&stroke.maps[0].size().map(|side| 0..side))?;
    Ok(Spent { build, update: until_done(&stroke.texels)? })
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

/// Milliseconds that it takes: the middle of some rounds, which it is told by their numbers.
fn timed(rounds: u32, mut run: impl FnMut(usize) -> Result<(), RenderError>) -> Result<f64, RenderError> {
    let mut times = Vec::new();
    for round in 0..rounds.max(1) as usize {
        let start = Instant::now();
        run(round)?;
        times.push(start.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_by(f64::total_cmp);
    Ok(times[times.len() / 2])
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
        assert!(
            all.iter()
                .all(|one| one.host.build > 0.0 && one.host.update > 0.0 && one.side == 64 && one.device.is_none())
        );
        assert_eq!(pyramids_csv(&all).lines().count(), all.len() + 1);
        assert_eq!(pyramids_table(&all).lines().count(), all.len() + 1);
    }
}
