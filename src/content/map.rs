//! What a recipe gives: images in memory.

use super::color::{Paint, encode};
use super::field::Field;
use super::recipe::Arguments;

/// A square image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map {
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
    Srgb8(Vec<u8>),
    /// Three numbers, 8 bit, linear.
    Rgb8(Vec<u8>),
}

impl Map {
    /// 0..1 over all of 16 bits.
    pub fn grey16(field: &Field) -> Self {
        let texels = field.data.iter().map(|&x| (x.clamp(0.0, 1.0) * 65_535.0).round() as u16).collect();
        Self { size: field.size, texels: Texels::Grey16(texels) }
    }

    /// 0..1 over 8 bits.
    pub fn grey8(field: &Field) -> Self {
        Self { size: field.size, texels: Texels::Grey8(field.data.iter().map(|&x| byte(x)).collect()) }
    }

    /// Linear colours, encoded.
    pub fn srgb(paint: &Paint) -> Self {
        let texels = paint.data.iter().flat_map(|&color| color.map(|x| byte(encode(x.clamp(0.0, 1.0))))).collect();
        Self { size: paint.size, texels: Texels::Srgb8(texels) }
    }

    /// The normals of heights 0..1 that stand for `depth` sides of the tile: red along u, green along v, blue out.
    pub fn normals(height: &Field, depth: f32) -> Self {
        let scale = depth * height.size as f32;
        let normals = Paint::build(height.size, |x, y, _, _| {
            let (du, dv) = height.gradient(x, y);
            let normal = [-du * scale, -dv * scale, 1.0];
            let length = (normal[0] * normal[0] + normal[1] * normal[1] + 1.0).sqrt();
            normal.map(|x| 0.5 + 0.5 * x / length)
        });
        let texels = normals.data.iter().flat_map(|&normal| normal.map(byte)).collect();
        Self { size: height.size, texels: Texels::Rgb8(texels) }
    }
}

fn byte(x: f32) -> u8 {
    (x.clamp(0.0, 1.0) * 255.0).round() as u8
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
    /// As images: height, albedo, normals.
    pub fn maps(&self, arguments: &Arguments) -> Vec<Map> {
        let normals = Map::normals(&self.height, arguments.get("depth"));
        vec![Map::grey16(&self.height), Map::srgb(&self.albedo), normals]
    }
}
