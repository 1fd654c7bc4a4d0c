//! `terrane measure`: relief methods, time against error.

mod output;

use std::path::PathBuf;

use terrane::file;
use terrane::measure::{Attack, BuiltIn, MAPS, Plan, Row, Subject, measure, pyramids, pyramids_csv, pyramids_table};
use terrane::measure::{attack, blocks, read, recommend, table, verdicts};
use terrane::relief::Timing;
use terrane::render::{Gpu, Progress, Selection};
use terrane_codegen::graph::nearest;
use terrane_shaderlib::heightfield::Border;
use terrane_shaderlib::relief::{Bounds, Method, MethodError, Placed};

use super::Failure;

/// Time relief methods and judge their errors against the exact reference, on maps of Terrane or on your own
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  terrane measure
  terrane measure --heightmap rock.png --depths 0.08 --max-error 0.5 -o rock.csv
  terrane measure --maps bricks,noise --methods \"walk,linear_secant(64)\" --elevations 20,2
  terrane measure --pyramids --sides 1024,4096
  terrane measure --adversary 100000000

Tables go to stdout. With -o rock.csv, plots of error against time and against loads stand beside it: rock_time.svg,
rock_time.png, rock_loads.svg, rock_loads.png. A time is nanoseconds a ray: what the processor spends on all cores of a
software device, the timestamps of a GPU, or else the wall's clock. Ratios are taken in the same rounds.")]
pub(crate) struct Measure {
    /// A grey PNG of 8 or 16 bits, instead of the built-in maps
    #[arg(long, value_name = "PNG", conflicts_with_all = ["maps", "sides"])]
    heightmap: Option<PathBuf>,
    /// The height map does not tile: it ends at its border
    #[arg(long, requires = "heightmap")]
    clamp: bool,
    /// Built-in maps by name; all of them if there are none
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = BuiltIn::named)]
    maps: Vec<BuiltIn>,
    /// Texels a side of the built-in maps
    #[arg(long, value_delimiter = ',', default_value = "1024", value_parser = side)]
    sides: Vec<u32>,
    /// Methods, with their budgets or by name alone; all of them if there are none
    #[arg(long, value_name = "NAMES", value_parser = methods)]
    methods: Option<Methods>,
    /// How deep the relief is, over the side of the map
    #[arg(long, value_delimiter = ',', default_value = "0.05", value_parser = depth)]
    depths: Vec<f64>,
    /// Degrees between the view and the ground
    #[arg(long, value_delimiter = ',', default_value = "45,20,8", value_parser = elevation)]
    elevations: Vec<f64>,
    /// Columns and rows of rays, as in 640x360
    #[arg(long, value_name = "WxH", value_parser = super::render::size, default_value = "640x360")]
    size: [u32; 2],
    /// Times that each method is traced; the median counts
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    rounds: u32,
    /// Recommend what no hit is farther off, for the least time
    #[arg(long, value_name = "TEXELS", value_parser = max_error, conflicts_with = "pyramids")]
    max_error: Option<f64>,
    /// Report bytes of bounds instead, and times to build them and to bring them up to date, on all cores and on the device if there is one
    #[arg(long, conflicts_with_all = ["methods", "depths", "elevations", "size"])]
    pyramids: bool,
    /// Comma-separated values with every digit, to this file, and plots beside it
    #[arg(short, long, value_name = "CSV")]
    output: Option<PathBuf>,
    /// Trace so many rays that are made to make exact methods fail, over as many small maps, and report every fault
    #[arg(long, value_name = "RAYS", conflicts_with_all = ["heightmap", "output", "pyramids"])]
    adversary: Option<u64>,
    /// The device to trace or to build on: its number, or a part of its name
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
}

/// As clap wants them: one value of the command line.
#[derive(Clone, Debug)]
struct Methods(Vec<Method>);

fn methods(text: &str) -> Result<Methods, String> {
    Method::list(text).map(Methods).map_err(|error| said(&error))
}

/// One method with its budget.
pub(super) fn method(text: &str) -> Result<Method, String> {
    text.parse().map_err(|error| said(&error))
}

/// An error, with the method that was perhaps meant.
fn said(error: &MethodError) -> String {
    let near = match error {
        MethodError::Unknown(name) => nearest(name, Method::names()).map(|near| (name, near)),
        MethodError::Budget(..) => None,
    };
    near.map_or_else(
        || error.to_string(),
        |(name, near)| format!("there is no method `{name}`; did you mean `{near}`?"),
    )
}

fn number(text: &str, range: std::ops::RangeInclusive<f64>, what: &str) -> Result<f64, String> {
    let found = text.parse().ok().filter(|number| range.contains(number));
    found.ok_or_else(|| format!("{what} are {} to {}", range.start(), range.end()))
}

fn depth(text: &str) -> Result<f64, String> {
    number(text, 0.001..=10.0, "depths")
}

fn elevation(text: &str) -> Result<f64, String> {
    number(text, 0.5..=75.0, "degrees")
}

fn max_error(text: &str) -> Result<f64, String> {
    number(text, 0.0..=1e6, "texels")
}

fn side(text: &str) -> Result<u32, String> {
    let side = text.parse().ok().filter(|side: &u32| (16..=8192).contains(side) && side.is_power_of_two());
    side.ok_or_else(|| "built-in maps tile: their sides are powers of two from 16 to 8192".into())
}

impl Measure {
    pub(crate) fn run(self) -> Result<(), Failure> {
        // What cannot be written is said before anybody waits for it.
        self.output.as_deref().map_or(Ok(()), |path| output::check(path, self.pyramids))?;
        if self.pyramids {
            return self.report_pyramids();
        }
        if let Some(rays) = self.adversary {
            return self.attack(rays);
        }
        let own = self.heightmap.as_ref().map(|_| self.own()).transpose()?;
        let gpu = Gpu::measuring(&self.adapter.as_deref().map_or(Selection::Best, Selection::parse))?;
        eprintln!("device: {}, time: {}", gpu.name(), Timing::of(&gpu));
        let mut rows: Vec<Row> = Vec::new();
        for subject in self.subjects(own) {
            let new = measure(&gpu, &subject, &self.plan(), Progress::Stderr)?;
            // At once: whoever stops a long run keeps what it has found.
            print!("{}", if rows.is_empty() { table(&new) } else { blocks(&new) });
            rows.extend(new);
        }
        self.print_recommendation(&rows);
        match &self.output {
            Some(path) => output::write(path, &rows),
            None => Ok(()),
        }
    }

    fn attack(&self, rays: u64) -> Result<(), Failure> {
        let gpu = super::render::open(self.adapter.as_deref())?;
        let methods = self.plan().methods.into_iter().filter(|method| method.is_exact()).collect();
        let found = attack(&gpu, &Attack { methods, rays, seed: 1 }, Progress::Stderr)?;
        print!("{}", verdicts(&found));
        for text in found.iter().flat_map(|verdict| verdict.first.iter().chain(&verdict.far)) {
            eprintln!("{text}");
        }
        let faults: u64 = found.iter().map(|verdict| verdict.faults()).sum();
        if faults > 0 { Err(Failure::Machine(format!("{faults} faults"))) } else { Ok(()) }
    }

    fn print_recommendation(&self, rows: &[Row]) {
        let Some(max_error) = self.max_error else { return };
        println!("\nOver all views, where rays do not graze (|n·d| > 0.01):");
        for one in recommend(rows, max_error) {
            println!("{one}");
        }
    }

    fn report_pyramids(&self) -> Result<(), Failure> {
        let own = self.heightmap.as_ref().map(|_| self.own()).transpose()?;
        let gpu = match &self.adapter {
            Some(name) => Some(Gpu::measuring(&Selection::parse(name))?),
            // What the host builds needs none.
            None => Gpu::measuring(&Selection::Best).ok(),
        };
        eprintln!("device: {}", gpu.as_ref().map_or("none", Gpu::name));
        let mut all = Vec::new();
        for subject in self.subjects(own) {
            all.extend(pyramids(&subject, self.rounds, gpu.as_ref())?);
        }
        print!("{}", pyramids_table(&all));
        match &self.output {
            Some(path) => Ok(file::write(path, pyramids_csv(&all).as_bytes())?),
            None => Ok(()),
        }
    }

    /// The user's map, or every map that was named in every size. Large ones are made one after the other.
    fn subjects(&self, own: Option<Subject>) -> Box<dyn Iterator<Item = Subject> + '_> {
        if own.is_some() {
            return Box::new(own.into_iter());
        }
        let maps = if self.maps.is_empty() { &MAPS[..] } else { &self.maps[..] };
        Box::new(maps.iter().flat_map(|map| self.sides.iter().map(|side| map.make(*side))))
    }

    /// Reads the user's map; what cannot be traced is said before a device is opened.
    fn own(&self) -> Result<Subject, Failure> {
        let path = self.heightmap.as_deref().unwrap_or(std::path::Path::new(""));
        let border = if self.clamp { Border::Clamp } else { Border::Wrap };
        let usage = |error: &dyn std::fmt::Display| Failure::Usage(format!("{}: {error}", path.display()));
        let subject = read(path, border).map_err(|error| usage(&error))?;
        Placed::new(&subject.heights, Bounds::None, 1).map_err(|error| usage(&error))?;
        Ok(subject)
    }

    fn plan(&self) -> Plan {
        Plan {
            methods: self.methods.as_ref().map_or_else(Method::all, |methods| methods.0.clone()),
            elevations: self.elevations.clone(),
            depths: self.depths.clone(),
            size: self.size,
            rounds: self.rounds,
            limit: 1 << 15,
        }
    }
}
