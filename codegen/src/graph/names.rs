//! What may be a name.

/// Words that RON reads as values: a bare reference to one of these names would not be read as a name.
const RON_WORDS: [&str; 5] = ["true", "false", "inf", "inff32", "inff64"];

/// Whether a name may be given to something: `[a-z][a-z0-9_]*`, no `__` (WGSL reserves it), no word of RON's.
pub(crate) fn is_name(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| matches!(c, 'a'..='z' | '0'..='9' | '_'))
        && !name.contains("__")
        && !RON_WORDS.contains(&name)
}

/// Whether a text can be a part of a reference; what it refers to is another matter.
pub(crate) fn is_word(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// `granite` of `graphs/surfaces/granite.ron`.
pub(crate) fn stem(path: &str) -> &str {
    let file = path.rsplit('/').next().unwrap_or(path);
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}

#[cfg(test)]
mod tests {
    use super::{is_name, stem};

    #[test]
    fn names_are_lower_case_words() {
        assert!(["a", "rock_2", "x1"].into_iter().all(is_name));
        assert!(
            ["", "Rock", "2x", "_a", "a b", "a.b", "ä", "true", "a__b", "inf"].into_iter().all(|name| !is_name(name))
        );
    }

    #[test]
    fn stem_drops_folder_and_extension() {
        assert_eq!(stem("graphs/surfaces/granite.ron"), "granite");
        assert_eq!(stem("granite"), "granite");
    }
}
