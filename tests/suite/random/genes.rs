//! A list of numbers that decides everything about a random project, so that a shorter list is a simpler project.

/// Reads decisions; a list that has run out decides for the first choice.
pub(crate) struct Genes<'a> {
    rest: std::slice::Iter<'a, u16>,
}

impl<'a> Genes<'a> {
    pub(crate) fn new(genes: &'a [u16]) -> Self {
        Self { rest: genes.iter() }
    }

    fn next(&mut self) -> u16 {
        self.rest.next().copied().unwrap_or(0)
    }

    /// A number below `count`, 0 if there is nothing to choose from.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        usize::from(self.next()) % count.max(1)
    }

    /// One of a list.
    pub(crate) fn pick<'b, T>(&mut self, list: &'b [T]) -> Option<&'b T> {
        let index = self.below(list.len());
        list.get(index)
    }

    /// Somewhere in a range, both ends included.
    pub(crate) fn between(&mut self, low: f32, high: f32) -> f32 {
        let part = f32::from(self.next()) / 65535.0;
        (low + (high - low) * part).clamp(low, high)
    }

    pub(crate) fn is_spent(&self) -> bool {
        self.rest.len() == 0
    }
}
