//! Module-scope declarations, found lexically.
//!
//! naga folds constants away and keeps no trace of their use, so that a walk over its IR misses dependencies. The words
//! of a declaration that name other declarations are a superset of them, exact where nothing shadows.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::token::{Token, tokens};

/// One declaration of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// `fn`, `struct`, `const`, `alias`, or whatever else the text declares.
    pub keyword: String,
    /// What it declares.
    pub name: String,
    /// Where the name stands.
    pub name_range: Range<usize>,
    /// The declaration with the comments right above it.
    pub range: Range<usize>,
    /// What stands between the first brackets: parameters of a function, members of a struct.
    pub list: Range<usize>,
    /// The lines of documentation above it, without `///`, each with its place.
    pub doc: Vec<(String, Range<usize>)>,
    /// Every word in it.
    words: BTreeSet<String>,
}

impl Item {
    /// The declarations that this one may refer to.
    pub fn uses<'a>(&'a self, names: &'a BTreeMap<String, usize>) -> impl Iterator<Item = usize> + 'a {
        self.words.iter().filter(|word| **word != self.name).filter_map(|word| names.get(word).copied())
    }
}

/// The declarations of a text, in order.
pub(crate) fn items(text: &str) -> Vec<Item> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    let mut start = 0;
    while start < tokens.len() {
        let length = declaration_length(&tokens[start..]);
        if let Some(item) = item(text, &tokens[start..start + length]) {
            found.push(item);
        }
        start += length;
    }
    found
}

/// How many textures a text binds: those that are sampled, and storage textures.
pub(crate) fn texture_variables(text: &str) -> [usize; 2] {
    let variables: Vec<Item> = items(text).into_iter().filter(|item| item.keyword == "var").collect();
    let of = |start: &str| {
        let with = |item: &&Item| item.words.iter().any(|word| word.starts_with(start));
        variables.iter().filter(with).count()
    };
    let storage = of("texture_storage_");
    [of("texture_") - storage, storage]
}

/// A declaration ends with the `;` or the closing brace at depth 0.
fn declaration_length(tokens: &[(Token, Range<usize>)]) -> usize {
    let mut depth = 0;
    for (index, (token, _)) in tokens.iter().enumerate() {
        match token {
            Token::FileDoc if depth == 0 => return index + 1,
            Token::Mark(b'{' | b'(' | b'[') => depth += 1,
            Token::Mark(b'}') if depth == 1 => return index + 1,
            Token::Mark(b'}' | b')' | b']') => depth -= 1,
            Token::Mark(b';') if depth == 0 => return index + 1,
            _ => {}
        }
    }
    tokens.len()
}

const KEYWORDS: [&str; 9] = ["fn", "struct", "const", "alias", "override", "var", "const_assert", "enable", "requires"];

fn item(text: &str, tokens: &[(Token, Range<usize>)]) -> Option<Item> {
    let is_keyword =
        |(token, range): &(Token, Range<usize>)| *token == Token::Word && KEYWORDS.contains(&&text[range.clone()]);
    let keyword = tokens.iter().position(is_keyword)?;
    let name = keyword + 1 + name_offset(text, &tokens[keyword + 1..])?;
    let name_range = tokens[name].1.clone();
    let end = tokens.last()?.1.end;
    let words = tokens[keyword..].iter().filter(|(token, _)| *token == Token::Word);
    Some(Item {
        keyword: text[tokens[keyword].1.clone()].into(),
        name: text[name_range.clone()].into(),
        name_range,
        range: start_with_comments(text, tokens)..end,
        list: list(tokens, name),
        doc: docs(text, &tokens[..keyword]),
        words: words.map(|(_, range)| text[range.clone()].to_owned()).collect(),
    })
}

/// The name is the next word, behind the `<…>` of a `var<uniform>`.
fn name_offset(text: &str, tokens: &[(Token, Range<usize>)]) -> Option<usize> {
    let template = tokens.first().is_some_and(|(token, _)| *token == Token::Mark(b'<'));
    let skip = if template { tokens.iter().position(|(token, _)| *token == Token::Mark(b'>'))? + 1 } else { 0 };
    let offset = tokens[skip..].iter().position(|(token, _)| *token == Token::Word)?;
    (!text.is_empty()).then_some(skip + offset)
}

/// Comments belong to the declaration when no blank line parts them from it.
fn start_with_comments(text: &str, tokens: &[(Token, Range<usize>)]) -> usize {
    let is_comment = |token: Token| matches!(token, Token::Doc | Token::Comment);
    let Some(first) = tokens.iter().position(|(token, _)| !is_comment(*token)) else { return tokens[0].1.start };
    let mut start = tokens[first].1.start;
    for (_, range) in tokens[..first].iter().rev() {
        if text[range.end..start].matches('\n').count() > 1 {
            break;
        }
        start = range.start;
    }
    start
}

fn list(tokens: &[(Token, Range<usize>)], name: usize) -> Range<usize> {
    let open = |token: &Token| matches!(token, Token::Mark(b'(' | b'{'));
    let Some(first) = tokens[name..].iter().position(|(token, _)| open(token)) else { return 0..0 };
    let mut depth = 0;
    for (token, range) in &tokens[name + first..] {
        match token {
            Token::Mark(b'(' | b'{' | b'[') => depth += 1,
            Token::Mark(b')' | b'}' | b']') => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return tokens[name + first].1.end..range.start;
        }
    }
    0..0
}

fn docs(text: &str, tokens: &[(Token, Range<usize>)]) -> Vec<(String, Range<usize>)> {
    let docs = tokens.iter().filter(|(token, _)| *token == Token::Doc);
    docs.map(|(_, range)| (text[range.start + 3..range.end].trim().to_owned(), range.clone())).collect()
}

/// A name and a type in a parameter or member list, and the documentation above.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    pub(crate) name: String,
    pub(crate) name_range: Range<usize>,
    /// The `///` lines joined by spaces.
    pub(crate) doc: String,
}

/// The entries of an item's list, with ranges in the whole text.
pub(crate) fn entries(text: &str, list: Range<usize>) -> Vec<Entry> {
    let mut found = Vec::new();
    let mut doc: Vec<&str> = Vec::new();
    let mut fresh = true;
    let mut depth = 0;
    for (token, range) in tokens(&text[list.clone()]) {
        let place = list.start + range.start..list.start + range.end;
        match token {
            Token::Doc => doc.push(text[place.start + 3..place.end].trim()),
            Token::Mark(b'(' | b'<' | b'[') => depth += 1,
            Token::Mark(b')' | b'>' | b']') => depth -= 1,
            Token::Mark(b',') if depth == 0 => fresh = true,
            Token::Word if fresh && depth == 0 => {
                fresh = false;
                let name = text[place.clone()].to_owned();
                found.push(Entry { name, name_range: place, doc: std::mem::take(&mut doc).join(" ") });
            }
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "//! File.\n\n// far\n\n// near\n/// Doc.\nconst K = 1.0 / 3.0;\nfn a(\n    /// X.\n    x: f32, y: vec2<f32>) -> f32 { return x * K; }\nstruct S { /// M.\n m: f32 }\n";

    #[test]
    fn declarations_keep_their_comments() {
        let items = items(TEXT);
        let names: Vec<_> = items.iter().map(|item| (item.keyword.as_str(), item.name.as_str())).collect();
        assert_eq!(names, [("const", "K"), ("fn", "a"), ("struct", "S")]);
        assert_eq!(&TEXT[items[0].range.clone()], "// near\n/// Doc.\nconst K = 1.0 / 3.0;");
        assert_eq!(items[0].doc[0].0, "Doc.");
    }

    #[test]
    fn a_folded_constant_is_still_a_dependency() {
        let items = items(TEXT);
        let names = items.iter().enumerate().map(|(index, item)| (item.name.clone(), index)).collect();
        assert_eq!(items[1].uses(&names).collect::<Vec<_>>(), [0]);
    }

    #[test]
    fn lists_give_names_and_docs() {
        let items = items(TEXT);
        let entries = entries(TEXT, items[1].list.clone());
        assert_eq!(
            entries.iter().map(|entry| (entry.name.as_str(), entry.doc.as_str())).collect::<Vec<_>>(),
            [("x", "X."), ("y", "")]
        );
        assert_eq!(super::entries(TEXT, items[2].list.clone())[0].doc, "M.");
    }
}
