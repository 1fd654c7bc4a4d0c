//! What a recipe gives: images with the ends of their file names.

use super::color::{Paint, encode};
use super::field::Field;

/// One image of a recipe.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map {
    /// What follows the recipe's key in the file name, before `.png`: `_height`.
    pub suffix: &'static str,
    /// Texels along a side.
    pub size: usize,
    /// The texels.
    pub texels: Texels,
}

/// Texels by rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Texels {
    /// Grey, 16 bit, linear.
    Grey16(Vec<u16>),
    /// Grey, 8 bit, linear.
    Grey8(Vec<u8>),
    /// Red, green, blue, 8 bit, sRGB.
    Rgb8(Vec<u8>),
}

impl Map {
    /// 0..1 over all of 16 bits.
    pub fn grey16(suffix: &'static str, field: &Field) -> Self {
        let texels = field.data.iter().map(|&x| (x.clamp(0.0, 1.0) * 65_535.0).round() as u16).collect();
        Self { suffix, size: field.size, texels: Texels::Grey16(texels) }
    }

    /// 0..1 over 8 bits.
    pub fn grey8(suffix: &'static str, field: &Field) -> Self {
        let texels = field.data.iter().map(|&x| (x.clamp(0.0, 1.0) * 255.0).round() as u8).collect();
        Self { suffix, size: field.size, texels: Texels::Grey8(texels) }
    }

    /// Linear colours, encoded.
    pub fn srgb(suffix: &'static str, paint: &Paint) -> Self {
        let byte = |x: f32| (encode(x.clamp(0.0, 1.0)) * 255.0).round() as u8;
        let texels = paint.data.iter().flat_map(|&color| color.map(byte)).collect();
        Self { suffix, size: paint.size, texels: Texels::Rgb8(texels) }
    }
}

/// A material: how high, and of what colour.
#[derive(Clone, Debug)]
pub struct Material {
    /// 0..1
    pub height: Field,
    /// Linear.
    pub albedo: Paint,
}

impl Material {
    /// As images: `_height` and `_albedo`.
    pub fn maps(&self) -> Vec<Map> {
        vec![Map::grey16("_height", &self.height), Map::srgb("_albedo", &self.albedo)]
    }
}
