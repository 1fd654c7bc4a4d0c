//! One scalar of many points, and the loops over them.

use super::active::Active;

/// One scalar for each lane, or the same for all: then only the first element counts.
#[derive(Clone, Debug, Default)]
pub(super) struct Lane<T> {
    data: Vec<T>,
    varying: bool,
}

/// What an operand looks like to a loop.
#[derive(Clone, Copy)]
pub(super) enum View<'a, T> {
    /// The same for all lanes.
    One(T),
    /// One for each lane.
    Many(&'a [T]),
}

impl<T: Copy> View<'_, T> {
    #[inline(always)]
    pub(super) fn at(&self, lane: usize) -> T {
        match self {
            Self::One(value) => *value,
            Self::Many(values) => values[lane],
        }
    }
}

impl<T: Copy + Default> Lane<T> {
    /// The same value for all lanes.
    pub(super) fn set(&mut self, value: T) {
        self.varying = false;
        match self.data.first_mut() {
            Some(first) => *first = value,
            None => self.data.push(value),
        }
    }

    /// The first `count` lanes.
    pub(super) fn view(&self, count: usize) -> View<'_, T> {
        if self.varying {
            View::Many(&self.data[..count])
        } else {
            View::One(self.data.first().copied().unwrap_or_default())
        }
    }

    /// A slot for each lane, to be overwritten: what it holds is left from earlier.
    pub(super) fn overwrite(&mut self, count: usize) -> &mut [T] {
        self.varying = true;
        if self.data.len() < count {
            self.data.resize(count, T::default());
        }
        &mut self.data[..count]
    }

    /// A slot for each lane, holding the value it had. A call with fewer lanes may have left fewer slots; then the new
    /// ones hold nothing that anybody reads.
    pub(super) fn spread(&mut self, count: usize) -> &mut [T] {
        if !self.varying {
            let value = self.data.first().copied().unwrap_or_default();
            self.overwrite(count).fill(value);
        }
        self.overwrite(count)
    }

    /// Takes the value of another in all lanes.
    pub(super) fn copy(&mut self, from: View<'_, T>) {
        match from {
            View::One(value) => self.set(value),
            View::Many(values) => self.overwrite(values.len()).copy_from_slice(values),
        }
    }
}

/// `out = f(a)` where active. Lanes that are not may be computed as well; nobody reads them.
#[inline(always)]
pub(super) fn map1<A: Copy, R: Copy + Default>(active: &Active, a: View<'_, A>, out: &mut Lane<R>, f: impl Fn(A) -> R) {
    match a {
        View::One(a) => out.set(f(a)),
        View::Many(a) => {
            let out = out.overwrite(active.lanes());
            match active.sparse() {
                None => out.iter_mut().zip(a).for_each(|(out, a)| *out = f(*a)),
                Some(list) => list.iter().for_each(|lane| out[*lane as usize] = f(a[*lane as usize])),
            }
        }
    }
}

/// `out = f(a, b)` where active.
#[inline(always)]
pub(super) fn map2<A: Copy, B: Copy, R: Copy + Default>(
    active: &Active,
    a: View<'_, A>,
    b: View<'_, B>,
    out: &mut Lane<R>,
    f: impl Fn(A, B) -> R,
) {
    if let (View::One(a), View::One(b)) = (a, b) {
        return out.set(f(a, b));
    }
    let out = out.overwrite(active.lanes());
    if let Some(list) = active.sparse() {
        return list.iter().for_each(|lane| out[*lane as usize] = f(a.at(*lane as usize), b.at(*lane as usize)));
    }
    match (a, b) {
        (View::Many(a), View::Many(b)) => {
            out.iter_mut().zip(a).zip(b).for_each(|((out, a), b)| *out = f(*a, *b));
        }
        (View::Many(a), View::One(b)) => out.iter_mut().zip(a).for_each(|(out, a)| *out = f(*a, b)),
        (View::One(a), View::Many(b)) => out.iter_mut().zip(b).for_each(|(out, b)| *out = f(a, *b)),
        (View::One(a), View::One(b)) => out.fill(f(a, b)),
    }
}

/// `out = f(a, b, c)` where active.
#[inline(always)]
pub(super) fn map3<A: Copy, B: Copy, C: Copy, R: Copy + Default>(
    active: &Active,
    (a, b, c): (View<'_, A>, View<'_, B>, View<'_, C>),
    out: &mut Lane<R>,
    f: impl Fn(A, B, C) -> R,
) {
    if let (View::One(a), View::One(b), View::One(c)) = (a, b, c) {
        return out.set(f(a, b, c));
    }
    let out = out.overwrite(active.lanes());
    if let (View::Many(a), View::Many(b), View::Many(c), None) = (a, b, c, active.sparse()) {
        return out.iter_mut().zip(a).zip(b).zip(c).for_each(|(((out, a), b), c)| *out = f(*a, *b, *c));
    }
    active.each(|lane| out[lane] = f(a.at(lane), b.at(lane), c.at(lane)));
}
