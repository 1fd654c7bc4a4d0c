//! WGSL as tokens with byte ranges: as much lexing as slicing declarations needs, and no more.

use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Token {
    /// `//! …`
    FileDoc,
    /// `/// …`
    Doc,
    /// Any other comment.
    Comment,
    /// A name or keyword.
    Word,
    /// A number with its suffix.
    Number,
    /// One character of anything else.
    Mark(u8),
}

/// Every token of a text, comments included, in order.
pub(crate) fn tokens(text: &str) -> Vec<(Token, Range<usize>)> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        if bytes[at].is_ascii_whitespace() {
            at += 1;
            continue;
        }
        let (token, end) = token(bytes, at);
        found.push((token, at..end));
        at = end;
    }
    found
}

fn token(bytes: &[u8], at: usize) -> (Token, usize) {
    let rest = &bytes[at..];
    if rest.starts_with(b"//!") {
        (Token::FileDoc, line_end(bytes, at))
    } else if rest.starts_with(b"///") {
        (Token::Doc, line_end(bytes, at))
    } else if rest.starts_with(b"//") {
        (Token::Comment, line_end(bytes, at))
    } else if rest.starts_with(b"/*") {
        (Token::Comment, block_end(bytes, at))
    } else if is_word_start(bytes[at]) {
        (Token::Word, run(bytes, at, |byte, _| is_word_start(byte) || byte.is_ascii_digit()))
    } else if bytes[at].is_ascii_digit() || (bytes[at] == b'.' && rest.get(1).is_some_and(u8::is_ascii_digit)) {
        (Token::Number, run(bytes, at, is_number_part))
    } else {
        (Token::Mark(bytes[at]), at + 1)
    }
}

/// WGSL allows names beyond ASCII; every byte of them is ≥ 0x80.
fn is_word_start(byte: u8) -> bool {
    byte.is_ascii_alphabetic() || byte == b'_' || byte >= 0x80
}

fn is_number_part(byte: u8, before: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'.' || (matches!(byte, b'+' | b'-') && matches!(before, b'e' | b'E'))
}

fn run(bytes: &[u8], start: usize, belongs: impl Fn(u8, u8) -> bool) -> usize {
    let mut end = start + 1;
    while end < bytes.len() && belongs(bytes[end], bytes[end - 1]) {
        end += 1;
    }
    end
}

fn line_end(bytes: &[u8], at: usize) -> usize {
    bytes[at..].iter().position(|byte| *byte == b'\n').map_or(bytes.len(), |offset| at + offset)
}

/// Block comments nest. One that never ends runs to the end of the text, where naga complains.
fn block_end(bytes: &[u8], at: usize) -> usize {
    let mut depth = 0;
    let mut index = at;
    while index + 1 < bytes.len() {
        match &bytes[index..index + 2] {
            b"/*" => depth += 1,
            b"*/" => depth -= 1,
            _ => {
                index += 1;
                continue;
            }
        }
        index += 2;
        if depth == 0 {
            return index;
        }
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        tokens(text).into_iter().filter(|(token, _)| *token == Token::Word).map(|(_, range)| &text[range]).collect()
    }

    #[test]
    fn suffixes_and_exponents_are_no_words() {
        assert_eq!(words("let a1 = 1.0f + 0x1fu - 2e-5 * .5h;"), ["let", "a1"]);
    }

    #[test]
    fn comments_hide_words_and_nest() {
        assert_eq!(words("a /* b /* c */ d */ e // f\ng"), ["a", "e", "g"]);
    }
}
