//! Which method to take.

use std::fmt;

use terrane_shaderlib::relief::Method;

use super::row::Row;

/// A method over all views of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// The method.
    pub method: Method,
    /// Nanoseconds a ray, the mean over the views.
    pub time: f64,
    /// The largest error of any view, in texels, where rays do not graze.
    pub max: f64,
    /// The error that one ray in a hundred exceeds, of the view where it is largest.
    pub p99: f64,
    /// Whether every ray of every view was decided, and rightly.
    pub is_decided: bool,
}

/// What to take on one map.
#[derive(Clone, Debug, PartialEq)]
pub struct Recommendation {
    /// The map.
    pub map: String,
    /// Texels that no hit may be off.
    pub max_error: f64,
    /// What meets that in the least time.
    pub choice: Option<Candidate>,
    /// The exact method that takes the least time.
    pub exact: Option<Candidate>,
    /// Where nothing meets it: what comes nearest.
    pub nearest: Option<Candidate>,
}

/// For each map of the rows, in their order.
#[must_use]
pub fn recommend(rows: &[Row], max_error: f64) -> Vec<Recommendation> {
    let mut maps: Vec<&str> = Vec::new();
    for row in rows {
        if !maps.contains(&&row.map[..]) {
            maps.push(&row.map);
        }
    }
    maps.into_iter().map(|map| of_map(map, rows, max_error)).collect()
}

fn of_map(map: &str, rows: &[Row], max_error: f64) -> Recommendation {
    let all = candidates(rows.iter().filter(|row| row.map == map));
    let meets = |one: &&Candidate| one.is_decided && one.max <= max_error;
    let fastest = |of: &mut dyn Iterator<Item = &Candidate>| of.min_by(|a, b| a.time.total_cmp(&b.time)).copied();
    let nearest = || {
        let decided = all.iter().filter(|one| one.is_decided);
        decided.min_by(|a, b| a.max.total_cmp(&b.max).then(a.time.total_cmp(&b.time))).copied()
    };
    let choice = fastest(&mut all.iter().filter(meets));
    Recommendation {
        map: map.into(),
        max_error,
        choice,
        exact: fastest(&mut all.iter().filter(|one| one.method.is_exact())),
        nearest: if choice.is_none() { nearest() } else { None },
    }
}

/// Every method of a map's rows. Each was traced over the same views.
fn candidates<'a>(rows: impl Iterator<Item = &'a Row>) -> Vec<Candidate> {
    let mut all: Vec<(Candidate, f64)> = Vec::new();
    for row in rows {
        let (max, p99) = (row.errors.facing.max, row.errors.facing.p99);
        let is_decided = row.errors.is_decided();
        match all.iter_mut().find(|(one, _)| one.method == row.method) {
            None => all.push((Candidate { method: row.method, time: row.time, max, p99, is_decided }, 1.0)),
            Some((one, views)) => {
                one.time = (one.time * *views + row.time) / (*views + 1.0);
                *views += 1.0;
                (one.max, one.p99) = (one.max.max(max), one.p99.max(p99));
                one.is_decided &= is_decided;
            }
        }
    }
    all.into_iter().map(|(one, _)| one).collect()
}

impl fmt::Display for Candidate {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { method, time, max, p99, .. } = self;
        write!(to, "`{method}`: {time:.1} ns a ray, at most {} texels off, p99 {}", digits(*max), digits(*p99))
    }
}

impl fmt::Display for Recommendation {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{}, at most {} texels off: ", self.map, self.max_error)?;
        match (&self.choice, &self.exact, &self.nearest) {
            (Some(choice), _, _) if choice.method.is_exact() => {
                write!(to, "take {choice}. It is exact, and nothing that meets this is faster.")
            }
            (Some(choice), Some(exact), _) => {
                write!(to, "take {choice}. Exact costs {:.2} times that: {exact}.", exact.time / choice.time)
            }
            (Some(choice), None, _) => write!(to, "take {choice}. No exact method was measured."),
            (None, _, Some(nearest)) => write!(to, "nothing measured meets this. The nearest is {nearest}."),
            (None, _, None) => {
                to.write_str("nothing measured meets this: every method leaves rays undecided or wrong.")
            }
        }
    }
}

/// Three digits that count.
fn digits(value: f64) -> String {
    let decimals = if value > 0.0 { (2 - value.log10().floor() as i32).clamp(0, 9) as usize } else { 0 };
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::super::row::tests::row;
    use super::*;

    const FAST: Method = Method::Linear(32, 0);
    const FINE: Method = Method::Linear(128, 0);

    fn rows() -> Vec<Row> {
        let view = |elevation, far: f64| {
            [
                row("rock", elevation, Method::MaximumMipmaps, 80.0, 0.002),
                row("rock", elevation, Method::Walk, 40.0, 0.002),
                row("rock", elevation, FAST, 8.0, far),
                row("rock", elevation, FINE, 30.0, 0.1 * far),
            ]
        };
        [view(45.0, 0.5), view(8.0, 4.0)].concat()
    }

    fn said(rows: &[Row], max_error: f64) -> String {
        recommend(rows, max_error)[0].to_string()
    }

    #[test]
    fn the_fastest_that_meets_the_error_on_every_view_is_named() {
        assert_eq!(
            said(&rows(), 4.0),
            "rock, at most 4 texels off: take `linear_secant(32)`: 8.0 ns a ray, at most 4.00 texels off, p99 2.00. \
             Exact costs 5.00 times that: `walk`: 40.0 ns a ray, at most 0.00200 texels off, p99 0.00100."
        );
        // 0.5 at 45° but 4 at 8°.
        assert!(said(&rows(), 1.0).contains("take `linear_secant(128)`: 30.0 ns a ray, at most 0.400 texels off"));
    }

    #[test]
    fn exact_is_named_where_it_wins() {
        assert_eq!(
            said(&rows(), 0.1),
            "rock, at most 0.1 texels off: take `walk`: 40.0 ns a ray, at most 0.00200 texels off, p99 0.00100. It is \
             exact, and nothing that meets this is faster."
        );
    }

    #[test]
    fn what_cannot_be_met_is_said() {
        assert!(said(&rows(), 1e-6).contains("nothing measured meets this. The nearest is `walk`: 40.0 ns"));
        let mut wrong = rows();
        wrong.iter_mut().for_each(|row| row.errors.missed = 1.0);
        assert!(said(&wrong, 10.0).ends_with("every method leaves rays undecided or wrong."));
    }

    #[test]
    fn a_method_that_misses_meets_no_error() {
        let mut rows = rows();
        rows[6].errors.missed = 3.0;
        assert_eq!(recommend(&rows, 4.0)[0].choice.map(|one| one.method), Some(FINE));
    }

    #[test]
    fn each_map_has_its_own() {
        let mut rows = rows();
        rows.push(row("hills", 45.0, FAST, 8.0, 0.01));
        let [rock, hills] = &recommend(&rows, 0.1)[..] else { panic!("two maps") };
        assert_eq!((&rock.map[..], &hills.map[..]), ("rock", "hills"));
        assert_eq!(hills.choice.map(|one| one.method), Some(FAST));
        assert!(hills.to_string().ends_with("No exact method was measured."));
        assert_eq!(recommend(&[], 1.0), []);
    }
}
