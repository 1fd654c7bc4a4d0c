//! `terrane measure`: relief methods, time against error.

use std::path::PathBuf;

use terrane::file;
use terrane::measure::{Plan, Row, Subject, built_in, csv, measure, read, table};
use terrane::render::{Gpu, Progress};
use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::relief::{Bounds, Method, Placed};

use super::Failure;

/// Time relief methods and judge their errors against the exact reference, on maps of Terrane or on your own
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  terrane measure
  terrane measure --heightmap rock.png --depth 0.08 -o rock.csv
  terrane measure --side 1024 --elevations 45,20,8,2

A table goes to stdout. Times are nanoseconds a ray, all cores of the device together, and beside them as a ratio to the
first method in the same rounds. Errors are texels along the ray, against the reference in f64.")]
pub(crate) struct Measure {
    /// A grey PNG of 8 or 16 bits, instead of the built-in maps
    #[arg(long, value_name = "PNG")]
    heightmap: Option<PathBuf>,
    /// The height map does not tile: it ends at its border
    #[arg(long, requires = "heightmap")]
    clamp: bool,
    /// Texels a side of the built-in maps
    #[arg(long, default_value_t = 1024, value_parser = clap::value_parser!(u32).range(16..=8192))]
    side: u32,
    /// How deep the relief is, over the side of the map
    #[arg(long, default_value_t = 0.05)]
    depth: f64,
    /// Degrees between the view and the ground
    #[arg(long, value_delimiter = ',', default_value = "45,20,8")]
    elevations: Vec<f64>,
    /// Columns and rows of rays, as in 640x360
    #[arg(long, value_name = "WxH", value_parser = super::render::size, default_value = "640x360")]
    size: [u32; 2],
    /// Times that each method is traced; the median counts
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    rounds: u32,
    /// Comma-separated values with every digit, to this file
    #[arg(short, long, value_name = "CSV")]
    output: Option<PathBuf>,
    /// The device to trace on: its number, or a part of its name
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
}

impl Measure {
    pub(crate) fn run(self) -> Result<(), Failure> {
        self.validate()?;
        let subjects = self.subjects()?;
        let gpu = super::render::open_as(self.adapter.as_deref(), Gpu::with_largest_textures)?;
        let plan = self.plan();
        let mut rows: Vec<Row> = Vec::new();
        for subject in &subjects {
            rows.extend(measure(&gpu, subject, &plan, Progress::Stderr)?);
        }
        print!("{}", table(&rows));
        if let Some(path) = &self.output {
            file::write(path, csv(&rows).as_bytes())?;
        }
        Ok(())
    }

    fn validate(&self) -> Result<(), Failure> {
        let usage = |text: String| Err(Failure::Usage(text));
        if !(self.depth > 0.0 && self.depth <= 10.0) {
            return usage(format!("--depth {} is not in 0..10 and above 0", self.depth));
        }
        if !self.side.is_power_of_two() {
            return usage(format!("--side {}: built-in maps tile, and their sides are powers of two", self.side));
        }
        if let Some(elevation) = self.elevations.iter().find(|elevation| !(1.0..=75.0).contains(*elevation)) {
            return usage(format!("--elevations: {elevation} is not in 1..75 degrees"));
        }
        match &self.output {
            Some(path) => Ok(file::check(path)?),
            None => Ok(()),
        }
    }

    fn subjects(&self) -> Result<Vec<Subject>, Failure> {
        let Some(path) = &self.heightmap else { return Ok(built_in(self.side)) };
        let border = if self.clamp { Border::Clamp } else { Border::Wrap };
        let usage = |error: &dyn std::fmt::Display| Failure::Usage(format!("{}: {error}", path.display()));
        let subject = read(path, border).map_err(|error| usage(&error))?;
        Placed::new(&subject.heights, Bounds::None, 1)
            .map_err(|error| usage(&format!("{error}, or give --clamp if it does not tile")))?;
        Ok(vec![subject])
    }

    fn plan(&self) -> Plan {
        let linear = [32, 128, 512].map(|steps| Method::Linear(steps, 0));
        let binary = [Method::Linear(32, 6), Method::Linear(128, 6)];
        let methods = [Method::MaximumMipmaps, Method::Walk, Method::Sprint, Method::Wide]
            .into_iter()
            .chain(linear)
            .chain(binary)
            .collect();
        Plan {
            methods,
            elevations: self.elevations.clone(),
            depth: self.depth,
            size: self.size,
            rounds: self.rounds,
            limit: 1 << 16,
        }
    }
}
