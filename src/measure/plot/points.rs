//! Rows of one map as points: each method over all of its views.

use terrane_shaderlib::relief::Method;

use super::Cost;
use crate::measure::row::Row;

/// A method on a map.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Point {
    pub(super) method: Method,
    /// The geometric mean over the views: each counts alike, however long its rays.
    pub(super) cost: f64,
    /// The largest error of any view.
    pub(super) max: f64,
    /// What one ray in a hundred exceeds, in the view where that is largest.
    pub(super) p99: f64,
    /// Whether every ray was decided, and rightly.
    pub(super) decided: bool,
    /// The view of the largest error.
    pub(super) worst: String,
}

/// A map with its methods.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chart {
    pub(super) map: String,
    pub(super) points: Vec<Point>,
}

/// A chart for each map, in the order of the rows.
pub(super) fn charts(rows: &[Row], cost: Cost) -> Vec<Chart> {
    let mut charts: Vec<Chart> = Vec::new();
    for row in rows {
        if !charts.iter().any(|chart| chart.map == row.map) {
            let of_map: Vec<&Row> = rows.iter().filter(|other| other.map == row.map).collect();
            charts.push(Chart { map: row.map.clone(), points: points(&of_map, cost) });
        }
    }
    charts
}

fn points(rows: &[&Row], cost: Cost) -> Vec<Point> {
    let mut methods: Vec<Method> = Vec::new();
    for row in rows {
        if !methods.contains(&row.method) {
            methods.push(row.method);
        }
    }
    let of = |method| rows.iter().copied().filter(move |row| row.method == method);
    methods.into_iter().filter_map(|method| point(&of(method).collect::<Vec<_>>(), cost)).collect()
}

fn point(rows: &[&Row], cost: Cost) -> Option<Point> {
    let value = |row: &&Row| match cost {
        Cost::Time => row.time,
        Cost::Loads => row.loads(),
    };
    // A map that no ray has to be sent over costs nothing, which no logarithm has.
    let logarithms = rows.iter().map(|row| value(row).max(1e-3).ln());
    let worst = rows.iter().max_by(|a, b| a.errors.facing.max.total_cmp(&b.errors.facing.max))?;
    Some(Point {
        method: worst.method,
        cost: (logarithms.sum::<f64>() / rows.len() as f64).exp(),
        max: worst.errors.facing.max,
        p99: rows.iter().map(|row| row.errors.facing.p99).fold(0.0, f64::max),
        decided: rows.iter().all(|row| row.errors.is_decided()),
        worst: format!("{}, {}°, depth {}", worst.side, worst.elevation, worst.depth),
    })
}

impl Chart {
    /// The points that no other beats in both, by what they cost.
    pub(super) fn front(&self) -> Vec<&Point> {
        let mut sorted: Vec<&Point> = self.points.iter().filter(|point| point.decided).collect();
        sorted.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.max.total_cmp(&b.max)));
        let mut least = f64::INFINITY;
        sorted.retain(|point| {
            point.max < least && {
                least = point.max;
                true
            }
        });
        sorted
    }

    /// The point of the largest error, of exact methods or of the others.
    pub(super) fn worst(&self, exact: bool) -> Option<&Point> {
        let kind = self.points.iter().filter(|point| point.method.is_exact() == exact);
        kind.max_by(|a, b| a.max.total_cmp(&b.max))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::row::tests::row;

    #[test]
    fn a_point_is_all_views_of_a_method() {
        let rows = [row("rock", 45.0, Method::Walk, 10.0, 0.1), row("rock", 8.0, Method::Walk, 40.0, 0.4)];
        let [chart] = &charts(&rows, Cost::Time)[..] else { panic!("one map") };
        let [point] = &chart.points[..] else { panic!("one method") };
        assert!((point.cost - 20.0).abs() < 1e-12, "{point:?}");
        assert_eq!((point.max, point.p99, &point.worst[..]), (0.4, 0.2, "1024, 8°, depth 0.05"));
        // A fifth of the time are steps, and there are 1.25 leaves.
        let loads = charts(&rows, Cost::Loads)[0].points[0].cost;
        assert!((loads - (3.25_f64 * 9.25).sqrt()).abs() < 1e-12, "{loads}");
    }

    #[test]
    fn the_front_has_what_nothing_beats() {
        let of = |steps, time, max| row("rock", 45.0, Method::Linear(steps, 0), time, max);
        let mut rows = vec![of(1, 1.0, 9.0), of(2, 2.0, 3.0), of(3, 3.0, 4.0), of(4, 4.0, 1.0), of(5, 1.5, 2.0)];
        rows[4].errors.missed = 1.0;
        let chart = &charts(&rows, Cost::Time)[0];
        let front: Vec<Method> = chart.front().iter().map(|point| point.method).collect();
        assert_eq!(front, [1, 2, 4].map(|steps| Method::Linear(steps, 0)));
        assert_eq!(chart.worst(false).map(|point| point.max), Some(9.0));
        assert_eq!(chart.worst(true), None);
    }
}
