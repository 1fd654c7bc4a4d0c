//! What the bounds of a map cost: bytes, and time to build on all cores.

use std::fmt::Write as _;
use std::time::Instant;

use terrane_shaderlib::heightfield::pyramid::{Bound, Pyramid, Wide};
use terrane_shaderlib::relief::{Bounds, Method, Placed, Unplaceable};

use super::subject::Subject;

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
}

/// Every kind of pyramid over a map, and everything that the methods ask for.
///
/// # Errors
/// Where the map cannot be placed.
pub fn pyramids(subject: &Subject, rounds: u32) -> Result<Vec<Built>, Unplaceable> {
    let heights = &subject.heights;
    let texels = heights.size().map(f64::from).iter().product::<f64>();
    let mut all = Vec::new();
    let mut add = |form, bounds: String, (time, bytes): (f64, usize)| {
        let (map, side) = (subject.name.clone(), heights.size()[0]);
        all.push(Built { map, side, form, bounds, bytes: bytes as f64 / texels, time });
    };
    for bound in [Bound::TexelMax, Bound::CellMax, Bound::CellMin] {
        add("pyramid", words(&bound), timed(rounds, || Pyramid::new(heights, bound).bytes()));
    }
    if Wide::new(heights).is_ok() {
        add("pyramid", "wide".into(), timed(rounds, || Wide::new(heights).map_or(0, |wide| wide.bytes())));
    }
    for bounds in placed() {
        // Asked once for its error, which every round would have.
        Placed::new(heights, bounds, 1)?;
        let bytes = || Placed::new(heights, bounds, 1).map_or(0, |placed| placed.bounds.bytes());
        add("placed", words(&bounds), timed(rounds, bytes));
    }
    Ok(all)
}

/// The bounds of all methods.
fn placed() -> Vec<Bounds> {
    let mut bounds: Vec<Bounds> = Method::all().into_iter().map(Method::bounds).collect();
    bounds.sort_unstable();
    bounds.dedup();
    bounds
}

/// `CellMax` as `cell_max`.
fn words(name: &impl std::fmt::Debug) -> String {
    let mut words = String::new();
    for letter in format!("{name:?}").chars() {
        if letter.is_uppercase() && !words.is_empty() {
            words.push('_');
        }
        words.extend(letter.to_lowercase());
    }
    words
}

/// Milliseconds that it takes, and what it gives.
fn timed(rounds: u32, build: impl Fn() -> usize) -> (f64, usize) {
    let mut bytes = 0;
    let mut times: Vec<f64> = (0..rounds.max(1))
        .map(|_| {
            let start = Instant::now();
            bytes = std::hint::black_box(build());
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[times.len() / 2], bytes)
}

/// Comma-separated values with a head line.
#[must_use]
pub fn pyramids_csv(all: &[Built]) -> String {
    let lines = all.iter().map(|one| {
        let Built { map, side, form, bounds, bytes, time } = one;
        format!("{map},{side},{form},{bounds},{bytes},{time}\n")
    });
    std::iter::once("map,side,form,bounds,bytes_per_texel,time_ms\n".to_owned()).chain(lines).collect()
}

/// The same for the eye.
#[must_use]
pub fn pyramids_table(all: &[Built]) -> String {
    let mut text = String::from("map           side  form     bounds             bytes/texel  build ms\n");
    for Built { map, side, form, bounds, bytes, time } in all {
        let _ = writeln!(text, "{map:<12} {side:>5}  {form:<7}  {bounds:<17}  {bytes:>11.3}  {time:>8.2}");
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
        let all = pyramids(&subject, 1).unwrap();
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
        assert!(all.iter().all(|one| one.time > 0.0 && one.side == 64));
        assert_eq!(pyramids_csv(&all).lines().count(), all.len() + 1);
        assert_eq!(pyramids_table(&all).lines().count(), all.len() + 1);
    }
}
