//! Rows as text.

use std::fmt::Write as _;

use super::row::Row;

/// A column of the table for the eye: its head, and a row's cell.
type Column = (&'static str, fn(&Row) -> String);
/// A column of the values: its head, and a row's cell with every digit.
type Value = (&'static str, fn(&Row) -> String);

const VALUES: [Value; 27] = [
    ("map", |row| row.map.clone()),
    ("side", |row| row.side.to_string()),
    ("depth", |row| row.depth.to_string()),
    ("elevation", |row| row.elevation.to_string()),
    ("method", |row| format!("\"{}\"", row.method)),
    ("clock", |row| row.timing.to_string()),
    ("time_ns", |row| row.time.to_string()),
    ("time_over_maximum_mipmaps", |row| row.ratio.to_string()),
    ("time_over_best_exact", |row| row.over_exact.to_string()),
    ("steps", |row| row.steps[0].to_string()),
    ("steps_p99", |row| row.steps[1].to_string()),
    ("steps_max", |row| row.steps[2].to_string()),
    ("leaves", |row| row.leaves.to_string()),
    ("missed_ppm", |row| row.errors.missed.to_string()),
    ("false_ppm", |row| row.errors.false_hits.to_string()),
    ("unresolved_ppm", |row| row.errors.unresolved.to_string()),
    ("decided_by_rounding_ppm", |row| row.errors.decided.to_string()),
    ("error_mean", |row| row.errors.distance.mean.to_string()),
    ("error_p99", |row| row.errors.distance.p99.to_string()),
    ("error_p999", |row| row.errors.distance.p999.to_string()),
    ("error_max", |row| row.errors.distance.max.to_string()),
    ("error_facing_p99", |row| row.errors.facing.p99.to_string()),
    ("error_facing_p999", |row| row.errors.facing.p999.to_string()),
    ("error_facing_max", |row| row.errors.facing.max.to_string()),
    ("normal_mean", |row| row.errors.normal.mean.to_string()),
    ("normal_p99", |row| row.errors.normal.p99.to_string()),
    ("normal_max", |row| row.errors.normal.max.to_string()),
];

const COLUMNS: [Column; 16] = [
    ("method", |row| row.method.to_string()),
    ("ns/ray", |row| time(row.time)),
    ("/mm", |row| format!("{:.2}", row.ratio)),
    ("/exact", |row| format!("{:.2}", row.over_exact)),
    ("steps", |row| format!("{:.1}", row.steps[0])),
    ("p99", |row| format!("{:.0}", row.steps[1])),
    ("max", |row| format!("{:.0}", row.steps[2])),
    ("leaves", |row| format!("{:.2}", row.leaves)),
    ("missed", |row| format!("{:.0}", row.errors.missed)),
    ("false", |row| format!("{:.0}", row.errors.false_hits)),
    ("unres.", |row| format!("{:.0}", row.errors.unresolved)),
    ("decided", |row| format!("{:.0}", row.errors.decided)),
    ("p99", |row| short(row.errors.facing.p99)),
    ("p99.9", |row| short(row.errors.facing.p999)),
    ("max", |row| short(row.errors.facing.max)),
    ("normal", |row| short(row.errors.normal.p99)),
];

/// Comma-separated values with a head line. Times are nanoseconds a ray, errors texels, those of normals degrees.
#[must_use]
pub fn csv(rows: &[Row]) -> String {
    let head = VALUES.map(|(name, _)| name).join(",");
    let lines = rows.iter().map(|row| VALUES.map(|(_, cell)| cell(row)).join(","));
    std::iter::once(head).chain(lines).map(|line| line + "\n").collect()
}

/// For the eye: what the columns are, then a block of methods for each view.
#[must_use]
pub fn table(rows: &[Row]) -> String {
    rows.first().map_or_else(String::new, |row| head(row) + &blocks(rows))
}

/// The blocks alone.
#[must_use]
pub fn blocks(rows: &[Row]) -> String {
    let mut text = String::new();
    let lines: Vec<[String; 16]> = rows.iter().map(|row| COLUMNS.map(|(_, cell)| cell(row))).collect();
    let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; 16] = std::array::from_fn(|column| width(column).max(COLUMNS[column].0.len()));
    for (index, row) in rows.iter().enumerate() {
        if index == 0 || rows[index - 1].scene() != row.scene() {
            let _ = writeln!(text, "\n{}", row.scene());
            text.push_str(&line(&COLUMNS.map(|(name, _)| name.to_owned()), &widths));
        }
        text.push_str(&line(&lines[index], &widths));
    }
    text
}

/// What the columns are.
fn head(row: &Row) -> String {
    let clock = match row.timing {
        crate::relief::Timing::Processor => "processor time of all cores",
        crate::relief::Timing::Device => "the device's own timestamps",
        crate::relief::Timing::Wall => "the wall's clock",
    };
    format!(
        "Time is {clock}; /mm over maximum_mipmaps, /exact over the fastest exact method, in the same rounds.\n\
         Steps are nodes or samples a ray, leaves patches; missed, false and unresolved hits a million rays, and right ones far\n\
         off because rounding decides what is met. Other errors are texels along the ray where it does not graze\n\
         (|n·d| > 0.01), of normals degrees, which one in a hundred exceeds.\n"
    )
}

/// Names to the left, numbers to the right.
fn line(cells: &[String; 16], widths: &[usize; 16]) -> String {
    let cells = cells.iter().zip(widths).enumerate();
    let text: String = cells
        .map(|(index, (cell, width))| if index == 0 { format!("  {cell:width$}") } else { format!("  {cell:>width$}") })
        .collect();
    text.trim_end().to_owned() + "\n"
}

/// Nanoseconds: a GPU takes less than one for a ray.
fn time(number: f64) -> String {
    if number < 10.0 { format!("{number:.3}") } else { format!("{number:.1}") }
}

/// A number that may be of any size.
fn short(value: f64) -> String {
    if value == 0.0 || (0.01..10_000.0).contains(&value) { format!("{value:.2}") } else { format!("{value:.1e}") }
}

#[cfg(test)]
mod tests {
    use super::super::row::tests::row;
    use super::*;
    use terrane_shaderlib::relief::Method;

    #[test]
    fn values_keep_every_digit() {
        let third = 1.0 / 3.0;
        let rows = [row("rock", 20.0, Method::Linear(32, 6), third, 1e-7), row("rock", 20.0, Method::Walk, 41.0, 0.0)];
        let text = csv(&rows);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 3);
        assert!(lines[1].starts_with("rock,1024,0.05,20,\"linear_binary(32, 6)\",processor,0.3333333333333333,"));
        let names: Vec<&str> = lines[0].split(',').collect();
        // The budget has a comma, in quotes.
        let cells: Vec<&str> = lines[2].split(',').collect();
        assert_eq!(names.len(), cells.len());
        let cell = |name: &str| cells[names.iter().position(|one| *one == name).expect(name)];
        assert_eq!([cell("time_ns"), cell("method"), cell("error_facing_max")], ["41", "\"walk\"", "0"]);
        assert_eq!(cell("time_over_best_exact").parse(), Ok(41.0 / 40.0));
        assert!(lines[1].contains(&format!(",{},", 1e-7)), "{}", lines[1]);
    }

    #[test]
    fn a_table_has_a_block_for_each_view() {
        let rows = [45.0, 8.0].map(|elevation| row("rock", elevation, Method::Walk, 41.0, 1e-4));
        let text = table(&rows);
        assert!(text.starts_with("Time is processor time of all cores; "));
        assert_eq!(text.matches("\nrock, 1024, depth 0.05, ").count(), 2);
        assert_eq!(text.matches("  walk").count(), 2);
        assert!(text.contains("1.0e-4"), "{text}");
        assert_eq!(table(&[]), "");
    }
}
