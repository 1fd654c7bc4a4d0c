//! Relief methods, time against error: `cargo bench --bench time_error`. As a test it runs once, small.

use terrane::measure::{BuiltIn, Plan, Row, measure, table};
use terrane::render::{Gpu, Progress, Selection};
use terrane_shaderlib::relief::Method;

/// Maps and what is done with them.
struct Extent {
    maps: &'static [&'static str],
    side: u32,
    elevations: &'static [f64],
    size: [u32; 2],
    rounds: u32,
}

/// What a run takes that is for its figures.
const FULL: Extent = Extent {
    maps: &["hills", "cracked_rock", "pebbles", "bricks", "terrain", "needles", "noise"],
    side: 1024,
    elevations: &[45.0, 20.0, 8.0],
    size: [640, 360],
    rounds: 7,
};

/// What shows that it still works.
const SMALL: Extent = Extent { maps: &["bricks"], side: 64, elevations: &[20.0], size: [64, 32], rounds: 1 };

fn main() {
    // cargo says `--bench` where figures are wanted; a test runs without.
    let extent = if std::env::args().any(|word| word == "--bench") { FULL } else { SMALL };
    match Gpu::measuring(&Selection::Best) {
        Ok(gpu) => print!("{}", table(&rows(&gpu, &extent))),
        Err(error) => println!("skipped: {error}"),
    }
}

fn rows(gpu: &Gpu, extent: &Extent) -> Vec<Row> {
    let plan = Plan {
        methods: Method::all(),
        elevations: extent.elevations.to_vec(),
        depths: vec![0.05],
        size: extent.size,
        rounds: extent.rounds,
        limit: 1 << 16,
    };
    let subjects = extent.maps.iter().map(|name| BuiltIn::named(name).expect("it is a map").make(extent.side));
    let rows = subjects.flat_map(|subject| {
        measure(gpu, &subject, &plan, Progress::Stderr).unwrap_or_else(|error| panic!("{}: {error}", subject.name))
    });
    rows.collect()
}
