//! Arguments and results: the scalars of a WGSL value, each for many points.

use super::domain::{Cell, Domain};

/// A value of any WGSL type, flattened: a vector's components, a matrix's columns, a struct's members, an array's
/// elements, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Value<D: Domain> {
    /// The scalars.
    pub components: Vec<Component<D>>,
}

/// One scalar for each point; a list of length 1 is the same for all.
#[derive(Clone, Debug, PartialEq)]
pub enum Component<D: Domain> {
    /// `f32`.
    Float(Vec<D::Float>),
    /// `i32` or `u32`, by its bits.
    Int(Vec<D::Int>),
    /// `bool`.
    Truth(Vec<D::Truth>),
    /// A texture or sampler, by the host's id; always the same for all points.
    Handle(u32),
}

impl<D: Domain> Component<D> {
    /// How many points it has; `None` if it is the same for any number.
    pub fn lanes(&self) -> Option<usize> {
        let length = match self {
            Self::Float(values) => values.len(),
            Self::Int(values) => values.len(),
            Self::Truth(values) => values.len(),
            Self::Handle(_) => 1,
        };
        (length != 1).then_some(length)
    }

    /// The type family, for messages.
    pub(crate) fn family(&self) -> &'static str {
        match self {
            Self::Float(_) => "f32",
            Self::Int(_) => "integer",
            Self::Truth(_) => "bool",
            Self::Handle(_) => "texture or sampler",
        }
    }
}

impl<D: Domain> Value<D> {
    /// An `f32`, one for each point.
    pub fn f32(values: &[f32]) -> Self {
        Self::single(Component::Float(values.iter().map(|value| D::float(*value)).collect()))
    }

    /// An `i32`, one for each point.
    pub fn i32(values: &[i32]) -> Self {
        Self::single(Component::Int(values.iter().map(|value| D::int(*value as u32)).collect()))
    }

    /// A `u32`, one for each point.
    pub fn u32(values: &[u32]) -> Self {
        Self::single(Component::Int(values.iter().map(|value| D::int(*value)).collect()))
    }

    /// A `bool`, one for each point.
    pub fn bool(values: &[bool]) -> Self {
        Self::single(Component::Truth(values.iter().map(|value| D::truth(*value)).collect()))
    }

    /// A vector of `f32`, one for each point.
    pub fn vector<const N: usize>(values: &[[f32; N]]) -> Self {
        Self::join((0..N).map(|i| Self::f32(&values.iter().map(|value| value[i]).collect::<Vec<_>>())))
    }

    /// A vector of `i32`, one for each point.
    pub fn integers<const N: usize>(values: &[[i32; N]]) -> Self {
        Self::join((0..N).map(|i| Self::i32(&values.iter().map(|value| value[i]).collect::<Vec<_>>())))
    }

    /// A texture or sampler, by the host's id.
    pub fn handle(id: u32) -> Self {
        Self::single(Component::Handle(id))
    }

    /// A struct of members, an array of elements, a matrix of columns.
    pub fn join(parts: impl IntoIterator<Item = Self>) -> Self {
        Self { components: parts.into_iter().flat_map(|part| part.components).collect() }
    }

    fn single(component: Component<D>) -> Self {
        Self { components: vec![component] }
    }

    /// The floats of a component at a point; `None` if it is of another type.
    pub fn float_at(&self, component: usize, point: usize) -> Option<D::Float> {
        match self.components.get(component)? {
            Component::Float(values) => at(values, point),
            _ => None,
        }
    }

    /// The integer of a component at a point; `None` if it is of another type.
    pub fn int_at(&self, component: usize, point: usize) -> Option<D::Int> {
        match self.components.get(component)? {
            Component::Int(values) => at(values, point),
            _ => None,
        }
    }

    /// The condition of a component at a point; `None` if it is of another type.
    pub fn truth_at(&self, component: usize, point: usize) -> Option<D::Truth> {
        match self.components.get(component)? {
            Component::Truth(values) => at(values, point),
            _ => None,
        }
    }
}

fn at<T: Cell>(values: &[T], point: usize) -> Option<T> {
    if values.len() == 1 { values.first().copied() } else { values.get(point).copied() }
}
