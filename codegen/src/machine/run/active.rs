//! Which lanes execute.

/// A set of lanes.
#[derive(Clone, Debug)]
pub(super) struct Active {
    lanes: usize,
    /// Ascending; `None` for all.
    list: Option<Vec<u32>>,
}

impl Active {
    /// All of so many lanes.
    pub(super) fn all(lanes: usize) -> Self {
        Self { lanes, list: None }
    }

    /// Those in the list, which is ascending and has none twice.
    pub(super) fn some(lanes: usize, list: Vec<u32>) -> Self {
        Self { lanes, list: (list.len() < lanes).then_some(list) }
    }

    /// None of them.
    pub(super) fn none(lanes: usize) -> Self {
        Self { lanes, list: Some(Vec::new()) }
    }

    /// How many lanes there are, active or not.
    pub(super) fn lanes(&self) -> usize {
        self.lanes
    }

    /// How many are active.
    pub(super) fn count(&self) -> usize {
        self.list.as_ref().map_or(self.lanes, Vec::len)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.count() == 0
    }

    pub(super) fn is_all(&self) -> bool {
        self.list.is_none()
    }

    /// The list, where it is so short that computing all lanes would cost more.
    #[inline(always)]
    pub(super) fn sparse(&self) -> Option<&[u32]> {
        self.list.as_deref().filter(|list| list.len() * SPARSE < self.lanes)
    }

    /// The list, unless all are active.
    pub(super) fn list(&self) -> Option<&[u32]> {
        self.list.as_deref()
    }

    #[inline(always)]
    pub(super) fn each(&self, mut visit: impl FnMut(usize)) {
        match &self.list {
            None => (0..self.lanes).for_each(visit),
            Some(list) => list.iter().for_each(|lane| visit(*lane as usize)),
        }
    }

    /// The active lanes, as a list that may grow.
    pub(super) fn into_list(self) -> Vec<u32> {
        self.list.unwrap_or_else(|| (0..self.lanes as u32).collect())
    }

    /// The lanes of both.
    pub(super) fn union(self, other: Self) -> Self {
        if self.is_all() || other.is_empty() {
            return self;
        }
        if other.is_all() || self.is_empty() {
            return other;
        }
        let lanes = self.lanes;
        let mut list = self.into_list();
        list.extend(other.into_list());
        list.sort_unstable();
        list.dedup();
        Self::some(lanes, list)
    }
}

/// A vectorised loop over all lanes is about so many times as fast as a gathering one over a list.
const SPARSE: usize = 4;
