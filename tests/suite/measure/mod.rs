//! `terrane measure` as a user meets it.

use std::fs;

use terrane::measure::{BuiltIn, Plan, measure};
use terrane::relief::{Segment, Timing, Tracer};
use terrane::render::{Gpu, Progress, Selection};
use terrane_shaderlib::heightfield::Ray;
use terrane_shaderlib::relief::{Method, Placed};

use crate::picture::Picture;
use crate::scratch::Scratch;
use crate::skip::Skip;

const TINY: [&str; 7] = ["measure", "--maps", "bricks", "--sides", "32", "--size", "64x16"];

fn device() -> Option<Gpu> {
    Gpu::measuring(&Selection::Best).map_err(|error| Skip(error.to_string()).report()).ok()
}

fn said(scratch: &Scratch, arguments: &[&str]) -> (String, Option<i32>) {
    let output = scratch.run(arguments);
    (String::from_utf8(output.stderr).expect("text"), output.status.code())
}

#[test]
fn two_methods_on_a_tiny_map_give_a_table_values_and_plots() {
    let Some(gpu) = device() else { return };
    drop(gpu);
    let scratch = Scratch::of("examples/build_script");
    let more = ["--methods", "walk,linear_secant(16)", "--elevations", "30", "--rounds", "1", "--max-error", "0.5"];
    let run = scratch.run(&[&TINY[..], &more, &["-o", "out/tiny.csv"]].concat());
    let (table, notes) = (String::from_utf8(run.stdout).unwrap(), String::from_utf8(run.stderr).unwrap());
    assert!(run.status.success(), "{notes}");
    assert!(table.contains("\nbricks, 32, depth 0.05, 30°\n") && table.contains("\n  linear_secant(16) "), "{table}");
    assert!(table.contains("\nbricks, at most 0.5 texels off: take `"), "{table}");
    assert!(notes.contains("device: ") && notes.contains(", time: "), "{notes}");
    let values = fs::read_to_string(scratch.path("out/tiny.csv")).unwrap();
    // The baseline is measured besides.
    let methods: Vec<&str> = values.lines().skip(1).filter_map(|line| line.split('"').nth(1)).collect();
    assert_eq!(methods, ["maximum_mipmaps", "walk", "linear_secant(16)"]);
    for plot in ["out/tiny_time.png", "out/tiny_loads.png"] {
        let picture = Picture::read(&scratch.path(plot)).unwrap();
        assert!(picture.width > 1000 && picture.pixels.iter().any(|pixel| pixel[0] < 64), "{plot} is bare");
    }
    assert!(fs::read_to_string(scratch.path("out/tiny_time.svg")).unwrap().starts_with("<svg"));
}

#[test]
fn exact_methods_are_measured_as_exact() {
    let Some(gpu) = device() else { return };
    let plan = Plan {
        methods: vec![Method::Walk, Method::Linear(8, 0)],
        elevations: vec![20.0],
        depths: vec![0.05, 0.1],
        size: [64, 64],
        rounds: 1,
        limit: 1 << 16,
    };
    let subject = BuiltIn::named("bricks").unwrap().make(128);
    let rows = measure(&gpu, &subject, &plan, Progress::Hidden).expect("the device measures");
    assert_eq!(rows.len(), 6);
    for row in &rows {
        let (errors, exact) = (&row.errors, row.method.is_exact());
        assert!(errors.is_decided() && row.time > 0.0, "{row:?}");
        assert_eq!(errors.facing.p999 < 0.01, exact, "{row:?}");
        assert_eq!(errors.normal.p99 < 0.1, exact, "{row:?}");
        assert!(!exact || row.over_exact >= 1.0, "{row:?}");
    }
    assert!(rows.iter().any(|row| row.over_exact == 1.0), "none is the fastest exact method");
}

#[test]
fn a_device_with_timestamps_times_itself() {
    let Some(gpu) = device() else { return };
    if !gpu.has_timestamps() {
        return Skip("no timestamps".into()).report();
    }
    let subject = BuiltIn::named("hills").unwrap().make(64);
    let placed = Placed::new(&subject.heights, Method::Walk.bounds(), 1 << 16).unwrap();
    let tracer = Tracer::new(&gpu, &subject.heights, &placed, Method::Walk).unwrap().timed(Timing::Device);
    let ray = Ray { origin: [0.5, 0.5, 65_535.0], direction: [1.0, 0.3, -9000.0] };
    let rays = vec![Segment { ray, range: (0.0, 10.0) }; 4096];
    let start = std::time::Instant::now();
    let (traced, time) = tracer.trace(&rays).unwrap();
    assert_eq!(traced.len(), rays.len());
    assert!(!time.is_zero() && time < start.elapsed(), "{time:?} of {:?}", start.elapsed());
}

#[test]
fn mistakes_are_said_before_anything_is_measured() {
    let scratch = Scratch::of("examples/build_script");
    for (arguments, why) in [
        (&["--methods", "wlak"][..], "there is no method `wlak`; did you mean `walk`?"),
        (&["--methods", "linear_secant(0)"], "`(0)` is no budget of `linear_secant(STEPS)`"),
        (&["--maps", "brick"], "there is no map `brick`; did you mean `bricks`?"),
        (&["--sides", "1000"], "their sides are powers of two from 16 to 8192"),
        (&["--elevations", "20,0.1"], "degrees are 0.5 to 75"),
        (&["--depths", "0"], "depths are 0.001 to 10"),
        (&["--max-error=-1"], "texels are 0 to 1000000"),
        (&["--heightmap", "rock.png", "--sides", "64"], "cannot be used with"),
        (&["--heightmap", "rock.png"], "rock.png: cannot be read: "),
    ] {
        let (said, code) = said(&scratch, &[&["measure"], arguments].concat());
        assert!(said.contains(why), "{arguments:?}: {said}");
        assert_eq!(code, Some(2), "{arguments:?}: {said}");
    }
    fs::create_dir(scratch.path("tiny_loads.svg")).unwrap();
    let (said, code) = said(&scratch, &[&TINY[..], &["-o", "tiny.csv"]].concat());
    assert_eq!((&said[..], code), ("error: cannot write tiny_loads.svg: it is there and no file\n", Some(3)));
}

#[test]
fn pyramids_are_reported() {
    let scratch = Scratch::of("examples/build_script");
    let run = scratch.run(&[
        "measure",
        "--pyramids",
        "--rounds",
        "1",
        "--maps",
        "hills",
        "--sides",
        "32,64",
        "-o",
        "pyramids.csv",
    ]);
    assert!(run.status.success());
    let table = String::from_utf8(run.stdout).unwrap();
    for bounds in ["texel_max", "cell_max", "cell_min", "wide"] {
        assert!(table.contains(&format!("  pyramid  {bounds} ")), "{table}");
    }
    let values = fs::read_to_string(scratch.path("pyramids.csv")).unwrap();
    assert_eq!(values.lines().count(), table.lines().count());
    assert!(
        values.starts_with(
            "map,side,form,bounds,bytes_per_texel,time_ms,update_ms,device_ms,device_update_ms\nhills,32,"
        )
    );
    let has_device = Gpu::new(&Selection::Best).is_ok();
    for line in values.lines().skip(1) {
        // The device packs nodes of what is placed alone.
        assert_eq!(line.ends_with(','), line.contains("pyramid,wide,") || !has_device, "{line}");
    }
}
