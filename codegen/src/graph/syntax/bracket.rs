//! Which bracket is still open where a text breaks off: a hint beside `ron`'s verdict, never a verdict.

/// The innermost bracket that a text opens and does not close.
pub(super) fn open_bracket(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut open = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        match bytes[at] {
            b'(' | b'[' | b'{' => open.push(at),
            b')' | b']' | b'}' => {
                open.pop();
            }
            b'"' => at += string(&bytes[at..]),
            b'/' => at += comment(&text[at..]),
            _ => {}
        }
        at += 1;
    }
    open.pop()
}

/// Bytes of a string before its last quote. Raw strings are rare enough to be read like others.
fn string(bytes: &[u8]) -> usize {
    let mut at = 1;
    while at < bytes.len() && bytes[at] != b'"' {
        at += if bytes[at] == b'\\' { 2 } else { 1 };
    }
    at
}

/// Bytes of a comment before its last one; 0 if it is none.
fn comment(text: &str) -> usize {
    let end = if text.starts_with("//") {
        text.find('\n')
    } else if text.starts_with("/*") {
        text.find("*/").map(|end| end + 1)
    } else {
        return 0;
    };
    end.unwrap_or(text.len())
}

#[cfg(test)]
mod tests {
    use super::open_bracket;

    #[test]
    fn finds_the_innermost_open_bracket() {
        assert_eq!(open_bracket("a(b[1], {2: 3"), Some(8));
        assert_eq!(open_bracket("a(b[1], {2: 3}"), Some(1));
        assert_eq!(open_bracket("a()"), None);
        assert_eq!(open_bracket("a(\"(\\\"[\" // {\n /* ( */"), Some(1));
        assert_eq!(open_bracket(")\"unclosed"), None);
    }
}
