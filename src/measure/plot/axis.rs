//! A logarithmic axis. Zero, which it cannot have, stands before a break.

/// Where numbers stand, from 0 at its beginning to 1 at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    /// Powers of ten at its ends.
    low: f64,
    high: f64,
    /// Whether there is a place for zero.
    zero: bool,
}

/// A line across a panel.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    /// Where it is.
    pub(super) at: f64,
    /// What stands beside it; nothing for one between others.
    pub(super) label: Option<String>,
}

/// The part of an axis before its break, and where in it zero is.
const BREAK: f64 = 0.1;
const ZERO: f64 = 0.04;

impl Axis {
    /// One that has all of some numbers, none of them below 0.
    pub(super) fn new(numbers: impl Iterator<Item = f64> + Clone) -> Self {
        let positive = numbers.clone().filter(|number| *number > 0.0);
        let (low, high) = positive.fold((f64::MAX, 0.0_f64), |(low, high), one| (low.min(one), high.max(one)));
        let (low, high) = if high > 0.0 { (low, high) } else { (1.0, 1.0) };
        // A little room at both ends, more where a budget stands over a mark, and never less than a decade.
        let (low, high) = (low.log10() - 0.12, high.log10() + 0.25);
        let middle = 0.5 * (low + high);
        let zero = numbers.into_iter().any(|number| number == 0.0);
        Self { low: low.min(middle - 0.5), high: high.max(middle + 0.5), zero }
    }

    /// Where a number stands.
    pub(super) fn at(self, number: f64) -> f64 {
        let first = if self.zero { BREAK } else { 0.0 };
        if number > 0.0 {
            let along = (number.log10() - self.low) / (self.high - self.low);
            return first + (1.0 - first) * along.clamp(0.0, 1.0);
        }
        if self.zero { ZERO } else { 0.0 }
    }

    /// Where it is broken.
    pub(super) fn broken(self) -> Option<f64> {
        self.zero.then_some(0.5 * (BREAK + ZERO))
    }

    /// Its lines: powers of ten, where there are few of them also 2 and 5 times those, and faint ones between.
    pub(super) fn ticks(self) -> Vec<Tick> {
        let span = self.high - self.low;
        let every = (span / 7.0).ceil().max(1.0) as i32;
        let inside = |number: f64| (self.low..=self.high).contains(&number.log10());
        let decades = (self.low.floor() as i32..=self.high.ceil() as i32).flat_map(|decade| {
            (1..10).map(move |digit| {
                let named = match digit {
                    1 => decade.rem_euclid(every) == 0,
                    2 | 5 => span < 2.2,
                    _ => false,
                };
                (digit, decade, named)
            })
        });
        let value = |digit: i32, decade: i32| f64::from(digit) * 10.0_f64.powi(decade);
        let lines = decades.filter(|(digit, decade, _)| inside(value(*digit, *decade)) && (*digit == 1 || span < 4.5));
        let ticks = lines.map(|(digit, decade, named)| Tick {
            at: self.at(value(digit, decade)),
            label: named.then(|| label(digit, decade)),
        });
        let zero = self.zero.then(|| Tick { at: ZERO, label: Some("0".into()) });
        zero.into_iter().chain(ticks).collect()
    }
}

/// 0.05, 20, and 10⁻⁵ where there would be many zeros.
fn label(digit: i32, decade: i32) -> String {
    if (-3..=4).contains(&decade) {
        let decimals = usize::try_from(-decade).unwrap_or(0);
        return format!("{:.decimals$}", f64::from(digit) * 10.0_f64.powi(decade));
    }
    let power = decade.to_string().chars().map(raised).collect::<String>();
    if digit == 1 { format!("10{power}") } else { format!("{digit}·10{power}") }
}

fn raised(letter: char) -> char {
    match letter {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        other => char::from_u32(other as u32 - '4' as u32 + '⁴' as u32).unwrap_or(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_are_as_long_as_each_other() {
        let axis = Axis::new([0.001, 10.0].into_iter());
        let steps = [0.001, 0.01, 0.1, 1.0, 10.0].map(|number| axis.at(number));
        let first = steps[1] - steps[0];
        assert!(steps.windows(2).all(|pair| (pair[1] - pair[0] - first).abs() < 1e-12));
        assert!(steps[0] > 0.0 && steps[4] < 1.0 && axis.broken().is_none());
    }

    #[test]
    fn zero_stands_before_a_break() {
        let axis = Axis::new([0.0, 1e-5, 1.0].into_iter());
        let gap = axis.broken().unwrap();
        assert!(axis.at(0.0) < gap && gap < axis.at(1e-5));
        let labels: Vec<String> = axis.ticks().into_iter().filter_map(|tick| tick.label).collect();
        assert_eq!(
            labels,
            ["0", "10⁻⁵", "10⁻⁴", "0.001", "0.010", "0.100", "1"].map(|label| match label {
                "0.010" => "0.01",
                "0.100" => "0.1",
                other => other,
            })
        );
    }

    #[test]
    fn a_short_axis_has_numbers_between_powers() {
        let labels = |low: f64, high: f64| -> Vec<String> {
            Axis::new([low, high].into_iter()).ticks().into_iter().filter_map(|tick| tick.label).collect()
        };
        assert_eq!(labels(12.0, 150.0), ["10", "20", "50", "100", "200"]);
        assert_eq!(labels(7.0, 7.0), ["5", "10", "20"]);
        assert_eq!(label(5, -12), "5·10⁻¹²");
        // Nothing but zeros is no reason to fail.
        assert!(Axis::new([0.0].into_iter()).at(0.0) > 0.0);
    }
}
