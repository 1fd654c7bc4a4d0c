//! The types that flow along wires, and literals.

use std::fmt;

/// The type of a value in a graph.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Type {
    /// A number.
    F32,
    /// A whole number.
    I32,
    /// A whole number, not negative.
    U32,
    /// Two numbers.
    Vec2,
    /// Three numbers; a colour is linear Rec. 709.
    Vec3,
    /// Four numbers.
    Vec4,
    /// A struct of the library, by name: `Place`, `Coord`, or what a node returns.
    Struct(String),
    /// A layer of a texture array, with its sampler. Only texture ports have this type.
    Texture,
}

impl Type {
    /// How many numbers a scalar or vector has.
    pub fn components(&self) -> Option<usize> {
        match self {
            Self::F32 | Self::I32 | Self::U32 => Some(1),
            Self::Vec2 => Some(2),
            Self::Vec3 => Some(3),
            Self::Vec4 => Some(4),
            Self::Struct(_) | Self::Texture => None,
        }
    }

    /// The vector of so many `f32`, 1 to 4.
    pub fn floats(count: usize) -> Option<Self> {
        [Self::F32, Self::Vec2, Self::Vec3, Self::Vec4].into_iter().nth(count.checked_sub(1)?)
    }

    /// As WGSL spells it.
    pub fn wgsl(&self) -> &str {
        match self {
            Self::F32 => "f32",
            Self::I32 => "i32",
            Self::U32 => "u32",
            Self::Vec2 => "vec2f",
            Self::Vec3 => "vec3f",
            Self::Vec4 => "vec4f",
            Self::Struct(name) => name,
            Self::Texture => "texture_2d_array<f32>",
        }
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Texture => f.write_str("texture"),
            other => f.write_str(other.wgsl()),
        }
    }
}

/// A constant. Floats are finite; equality and order are those of the bits, so that equal literals are one value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Literal {
    /// A whole number.
    I32(i32),
    /// A whole number, not negative.
    U32(u32),
    /// One to four floats, by their bits; the rest is zero.
    Floats {
        /// How many, 1 to 4.
        count: u8,
        /// `f32::to_bits` of each.
        bits: [u32; 4],
    },
}

impl Literal {
    /// A number.
    pub fn f32(value: f32) -> Self {
        Self::floats(&[value])
    }

    /// One to four numbers.
    ///
    /// # Panics
    /// If there are none or more than four.
    pub fn floats(values: &[f32]) -> Self {
        assert!((1..=4).contains(&values.len()), "a literal has one to four components");
        let mut bits = [0; 4];
        for (bit, value) in bits.iter_mut().zip(values) {
            *bit = value.to_bits();
        }
        Self::Floats { count: values.len() as u8, bits }
    }

    /// The floats of a float literal; empty for whole numbers.
    pub fn values(&self) -> Vec<f32> {
        match self {
            Self::Floats { count, bits } => {
                bits[..usize::from(*count)].iter().map(|bit| f32::from_bits(*bit)).collect()
            }
            Self::I32(_) | Self::U32(_) => Vec::new(),
        }
    }

    /// Its type.
    pub fn ty(&self) -> Type {
        match self {
            Self::I32(_) => Type::I32,
            Self::U32(_) => Type::U32,
            Self::Floats { count: 1, .. } => Type::F32,
            Self::Floats { count: 2, .. } => Type::Vec2,
            Self::Floats { count: 3, .. } => Type::Vec3,
            Self::Floats { .. } => Type::Vec4,
        }
    }

    /// As WGSL text, always with its type: abstract constants round differently.
    pub fn wgsl(&self) -> String {
        match self {
            Self::I32(value) if *value == i32::MIN => "i32(-2147483648)".into(),
            Self::I32(value) => format!("{value}i"),
            Self::U32(value) => format!("{value}u"),
            Self::Floats { count: 1, bits } => float(bits[0]),
            Self::Floats { .. } => {
                let values: Vec<String> = self.values().iter().map(|value| float(value.to_bits())).collect();
                format!("{}({})", self.ty().wgsl(), values.join(", "))
            }
        }
    }
}

/// The shortest decimal that reads back as the same float, with a type suffix.
fn float(bits: u32) -> String {
    format!("{:?}f", f32::from_bits(bits))
}
