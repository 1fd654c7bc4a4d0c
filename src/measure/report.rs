//! Rows as text.

use std::fmt::Write as _;

use super::run::Row;

const HEAD: [&str; 17] = [
    "map",
    "side",
    "elevation",
    "method",
    "time_ns",
    "time_ratio",
    "steps",
    "steps_p99",
    "steps_max",
    "leaves",
    "missed_ppm",
    "false_ppm",
    "unresolved_ppm",
    "error_mean",
    "error_p99",
    "error_p999",
    "error_max",
];

/// Comma-separated values with a head line. Times are nanoseconds a ray, errors texels.
#[must_use]
pub fn csv(rows: &[Row]) -> String {
    let lines = rows.iter().map(|row| cells(row, false).join(",") + "\n");
    std::iter::once(HEAD.join(",") + "\n").chain(lines).collect()
}

/// The same for the eye.
#[must_use]
pub fn table(rows: &[Row]) -> String {
    let lines: Vec<Vec<String>> =
        std::iter::once(HEAD.map(str::to_owned).to_vec()).chain(rows.iter().map(|row| cells(row, true))).collect();
    let widths: Vec<usize> =
        (0..HEAD.len()).map(|column| lines.iter().map(|line| line[column].len()).max().unwrap_or(0)).collect();
    let mut text = String::new();
    for line in &lines {
        for (index, (cell, width)) in line.iter().zip(&widths).enumerate() {
            // Names to the left, numbers to the right. Writing to a string cannot fail.
            let _ = if [0, 3].contains(&index) {
                write!(text, "{cell:width$}  ")
            } else {
                write!(text, "{cell:>width$}  ")
            };
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

fn cells(row: &Row, round: bool) -> Vec<String> {
    let errors = &row.errors;
    let number = |value: f64, digits: usize| if round { format!("{value:.digits$}") } else { value.to_string() };
    let small = |value: f64| if round { format!("{value:.1e}") } else { value.to_string() };
    let method = if round { row.method.to_string() } else { format!("\"{}\"", row.method) };
    vec![
        row.map.clone(),
        row.side.to_string(),
        number(row.elevation, 0),
        method,
        number(row.time, 1),
        number(row.ratio, 2),
        number(row.steps[0], 1),
        number(row.steps[1], 0),
        number(row.steps[2], 0),
        number(row.leaves, 2),
        number(errors.missed, 0),
        number(errors.false_hits, 0),
        number(errors.unresolved, 0),
        small(errors.mean),
        small(errors.p99),
        small(errors.p999),
        small(errors.max),
    ]
}
