//! The maps that Terrane brings: a few materials, a terrain, and what is easy or hard about relief by itself.

use std::fmt;

use terrane_codegen::graph::nearest;
use terrane_codegen::graph::recipe::recipe;
use terrane_shaderlib::heightfield::adversary::{Depth, Land, map};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};

use super::subject::Subject;
use crate::content;
use crate::content::field::Field;
use crate::content::map::Map;
use crate::content::noise::Noise;
use crate::content::recipe::{Arguments, maker};

/// A map that any machine makes in any size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltIn {
    name: &'static str,
    source: Source,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    /// A recipe of the content.
    Material,
    /// [`terrain`].
    Terrain,
    /// A land of the adversary.
    Land(Land),
}

/// All of them.
pub const MAPS: [BuiltIn; 9] = [
    BuiltIn { name: "hills", source: Source::Land(Land::Hills) },
    BuiltIn { name: "cracked_rock", source: Source::Material },
    BuiltIn { name: "pebbles", source: Source::Material },
    BuiltIn { name: "bricks", source: Source::Material },
    BuiltIn { name: "terrain", source: Source::Terrain },
    BuiltIn { name: "cracks", source: Source::Land(Land::Cracks) },
    BuiltIn { name: "walls", source: Source::Land(Land::Walls) },
    BuiltIn { name: "needles", source: Source::Land(Land::Needles) },
    BuiltIn { name: "noise", source: Source::Land(Land::Noise) },
];

/// A name that no map has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMap(String);

impl fmt::Display for UnknownMap {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "there is no map `{}`; ", self.0)?;
        let names = MAPS.map(|map| map.name);
        match nearest(&self.0, names) {
            Some(near) => write!(to, "did you mean `{near}`?"),
            None => write!(to, "there is `{}`", names.join("`, `")),
        }
    }
}

impl std::error::Error for UnknownMap {}

impl BuiltIn {
    /// The map of a name.
    ///
    /// # Errors
    /// [`UnknownMap`], which says what there is.
    pub fn named(name: &str) -> Result<Self, UnknownMap> {
        MAPS.into_iter().find(|map| map.name == name).ok_or_else(|| UnknownMap(name.into()))
    }

    /// Makes it, so many texels a side.
    ///
    /// # Panics
    /// If the side is not in 16..8192.
    #[must_use]
    pub fn make(self, side: u32) -> Subject {
        let heights = match self.source {
            Source::Material => material(self.name, side),
            Source::Terrain => texels(Map::grey16(&terrain(side))),
            Source::Land(land) => map(land, [side; 2], Border::Wrap, Depth::Sixteen, 1).expect("the side is in range"),
        };
        Subject { name: self.name.into(), heights, full: 65535.0 }
    }
}

/// A longer side of a material is twice as many texels between the same ones: their makers work at twice the size, for which
/// memory has an end.
const LONGEST: u32 = 4096;

fn material(name: &str, side: u32) -> Heights {
    let recipe = recipe(name).expect("the table names recipes, which its test shows");
    let arguments = Arguments::defaults(recipe, side.min(LONGEST), 1);
    let map = (maker(name).make)(&arguments).swap_remove(0);
    if side <= LONGEST { texels(map) } else { texels(doubled(map)) }
}

fn doubled(map: Map) -> Map {
    let content::map::Texels::Grey16(values) = map.texels else { return map };
    let coarse = Field { size: map.size, data: values.iter().map(|value| f32::from(*value) / 65535.0).collect() };
    Map::grey16(&Field::build(2 * map.size, |u, v| coarse.sample(u, v)))
}

fn texels(map: Map) -> Heights {
    let content::map::Texels::Grey16(texels) = map.texels else { unreachable!("height maps are grey of 16 bits") };
    Heights::new([map.size as u32; 2], Border::Wrap, Texels::U16(texels)).expect("the side is in range")
}

/// Ranges with sharp crests, detailed down to the texel. No water has run over it, as over the recipe `mountains`, which
/// takes minutes to make.
fn terrain(side: u32) -> Field {
    let octaves = side.ilog2().saturating_sub(2);
    let [ranges, swell] = [Noise::new(7, 3, octaves), Noise::new(8, 2, 3)];
    Field::build(side as usize, |u, v| ranges.ridged(u, v) + 0.35 * swell.fbm(u, v)).stretched()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_map_is_made_and_uses_its_range() {
        for map in MAPS {
            assert_eq!(BuiltIn::named(map.name), Ok(map));
            let subject = map.make(64);
            assert_eq!((subject.heights.size(), &subject.name[..]), ([64, 64], map.name));
            let Texels::U16(texels) = subject.heights.texels() else { panic!("16 bits") };
            let (low, high) = (texels.iter().min().unwrap(), texels.iter().max().unwrap());
            assert!(high - low > 16_384, "{}: {low}..{high}", map.name);
            assert_eq!(subject, map.make(64), "{} is another map each time", map.name);
        }
    }

    #[test]
    fn a_wrong_name_is_said() {
        let said = |name: &str| BuiltIn::named(name).unwrap_err().to_string();
        assert_eq!(said("brick"), "there is no map `brick`; did you mean `bricks`?");
        assert!(said("xyz").starts_with("there is no map `xyz`; there is `hills`, `cracked_rock`, "));
    }

    #[test]
    fn longer_materials_keep_their_shape() {
        let small = Map::grey16(&terrain(32));
        let large = doubled(small.clone());
        assert_eq!(large.size, 64);
        let (small, large) = (texels(small), texels(large));
        // The centre of a coarse texel lies between four fine ones.
        for (x, y) in [(3, 4), (0, 31), (31, 0)] {
            let mean = large.corners(2 * x, 2 * y).iter().sum::<f64>() / 4.0;
            assert!((mean - small.height(x, y)).abs() < 0.35 * 65535.0, "{x} {y}");
        }
    }
}
