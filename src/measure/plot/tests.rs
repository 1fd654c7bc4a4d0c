//! Plots of rows that were made up.

use super::super::row::tests::row;
use super::*;
use terrane_shaderlib::relief::Method;

fn rows() -> Vec<Row> {
    let map = |map: &str, hard: f64| {
        [
            row(map, 20.0, Method::MaximumMipmaps, 80.0 * hard, 0.004),
            row(map, 20.0, Method::Walk, 40.0 * hard, 0.004),
            row(map, 20.0, Method::Linear(32, 0), 14.0, 60.0 * hard),
            row(map, 20.0, Method::Linear(128, 0), 45.0, 12.0 * hard),
            row(map, 20.0, Method::Linear(32, 6), 20.0, 55.0 * hard),
        ]
    };
    let mut rows = [map("hills", 0.5), map("rock", 1.0), map("pebbles", 1.5), map("needles", 2.0)].concat();
    rows[1].errors.facing.p99 = 0.0;
    rows[17].errors.missed = 3.0;
    rows
}

#[test]
fn equal_rows_give_equal_bytes() {
    let rows = rows();
    let plot = |cost| Plot { rows: &rows, cost };
    for cost in [Cost::Time, Cost::Loads] {
        assert_eq!(plot(cost).svg().unwrap(), plot(cost).svg().unwrap());
        let (first, second) = (plot(cost).image().unwrap(), plot(cost).image().unwrap());
        assert!(first == second && first.pixels.len() == first.width as usize * first.height as usize * 3);
    }
}

#[test]
fn a_plot_names_what_it_shows() {
    let rows = rows();
    let svg = Plot { rows: &rows, cost: Cost::Time }.svg().unwrap();
    let wanted = [
        "needles",
        "linear_secant",
        "walk (exact)",
        "time a ray, ns (processor, all cores)",
        "largest error, texels",
        "worst of the rest: 120 texels, linear_secant(32) (1024, 20°, depth 0.05)",
        "worst exact: 0.0040 texels",
    ];
    for text in wanted {
        assert!(svg.contains(text), "{text}");
    }
    let loads = Plot { rows: &rows, cost: Cost::Loads }.svg().unwrap();
    assert!(loads.contains("loads a ray (nodes and patches, or samples)"));
}

/// Text is drawn as pixels, or a machine without fonts would show bare axes.
#[test]
fn letters_are_drawn() {
    let rows = rows();
    let image = Plot { rows: &rows, cost: Cost::Time }.image().unwrap();
    // The title stands in the upper left corner, and nothing else does.
    let dark = |x: u32, y: u32| image.pixels[(y * image.width + x) as usize * 3] < 128;
    let count = (20..80).flat_map(|y| (40..600).map(move |x| (x, y))).filter(|(x, y)| dark(*x, *y)).count();
    assert!(count > 800, "{count} dark pixels");
}

#[test]
fn nothing_measured_is_an_empty_plot() {
    assert!(Plot { rows: &[], cost: Cost::Time }.svg().is_ok());
}
