//! "Did you mean": the nearest known name to an unknown one.

/// Bytes of a name that somebody can have meant.
const LONGEST: usize = 64;

/// The nearest of some names, if it is near enough to be meant.
pub fn nearest<'a>(unknown: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if unknown.len() > LONGEST {
        return None;
    }
    let limit = unknown.chars().count().div_ceil(3).min(4);
    let ranked = known.into_iter().map(|name| (distance(unknown, name), name));
    // A name of which no letter is right was not meant.
    let near = |(distance, name): &(usize, &str)| *distance <= limit && *distance < unknown.len().max(name.len());
    ranked.filter(|found| near(found) || is_part(unknown, found.1)).min().map(|(_, name)| name)
}

/// A help text: the nearest name, or what there is.
pub(crate) fn help<'a>(unknown: &str, known: impl IntoIterator<Item = &'a str> + Clone) -> Option<String> {
    nearest(unknown, known.clone()).map(|name| format!("did you mean `{name}`?")).or_else(|| {
        let mut names: Vec<&str> = known.into_iter().collect();
        names.sort_unstable();
        (!names.is_empty()).then(|| format!("there is {}", list(&names)))
    })
}

/// Names in backticks, not more than a reader takes in.
pub(crate) fn list<S: AsRef<str>>(names: &[S]) -> String {
    const SHOWN: usize = 12;
    let mut shown: Vec<String> = names.iter().take(SHOWN).map(|name| format!("`{}`", name.as_ref())).collect();
    if names.len() > SHOWN {
        shown.push(format!("{} more", names.len() - SHOWN));
    }
    shown.join(", ")
}

/// `noise` for `noise_perlin`, but not `a` for everything.
fn is_part(unknown: &str, name: &str) -> bool {
    unknown.len() >= 4 && name.split('_').any(|part| part == unknown)
}

/// Edits between two names (optimal string alignment: insert, delete, replace, swap neighbours), case and `-` aside.
fn distance(a: &str, b: &str) -> usize {
    let fold = |text: &str| text.to_lowercase().replace(['-', ' '], "_").chars().collect::<Vec<char>>();
    let (a, b) = (fold(a), fold(b));
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replace = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replace.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::{distance, nearest};

    #[test]
    fn counts_edits() {
        assert_eq!(distance("slope", "slope"), 0);
        assert_eq!(distance("slpoe", "slope"), 1);
        assert_eq!(distance("rmp", "ramp"), 1);
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("sRGB", "srgb"), 0);
    }

    #[test]
    fn suggests_only_what_is_near() {
        assert_eq!(nearest("overlya", ["overlay", "over"]), Some("overlay"));
        assert_eq!(nearest("perlin", ["noise_perlin", "noise_value"]), Some("noise_perlin"));
        assert_eq!(nearest("q", ["overlay", "ramp"]), None);
        assert_eq!(nearest("x", ["r", "g"]), None);
        assert_eq!(nearest("X", ["x", "g"]), Some("x"));
    }
}
