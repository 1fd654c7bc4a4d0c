//! Which declarations a piece of text needs.

use std::collections::BTreeSet;

use super::Library;
use super::token::{Token, tokens};

impl Library {
    /// The declarations that a text may refer to, directly or through others: positions in [`Library::items`], in order.
    pub fn closure(&self, text: &str) -> BTreeSet<usize> {
        let words = tokens(text).into_iter().filter(|(token, _)| *token == Token::Word);
        let mut open: Vec<usize> = words.filter_map(|(_, range)| self.names.get(&text[range]).copied()).collect();
        let mut found = BTreeSet::new();
        while let Some(index) = open.pop() {
            if found.insert(index) {
                open.extend(self.items[index].uses(&self.names));
            }
        }
        found
    }

    /// A declaration as its author wrote it, comments included.
    pub fn slice(&self, item: usize) -> &str {
        &self.text[self.items[item].range.clone()]
    }
}
