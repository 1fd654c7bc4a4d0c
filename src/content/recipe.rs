//! What makes each recipe of [`terrane_codegen::graph::recipe`].

use std::collections::BTreeMap;

use terrane_codegen::graph::Made;
use terrane_codegen::graph::recipe::Recipe;

use super::map::Map;
use super::{material, terrain};

/// The arguments of a recipe, complete and in range.
#[derive(Clone, Debug, PartialEq)]
pub struct Arguments(BTreeMap<&'static str, f64>);

impl Arguments {
    /// Those of an entry of `terrane.ron`, which resolution has checked.
    pub fn of(made: &Made) -> Self {
        Self(made.arguments.clone())
    }

    /// The defaults of a recipe, in a size and for a seed.
    pub fn defaults(recipe: &Recipe, size: u32, seed: u32) -> Self {
        let defaults = recipe.arguments.iter().map(|argument| (argument.name, argument.default));
        Self(defaults.chain([("size", f64::from(size)), ("seed", f64::from(seed))]).collect())
    }

    /// A number.
    ///
    /// # Panics
    /// If the recipe declares no such argument: a mistake in its maker.
    pub fn get(&self, name: &str) -> f32 {
        self.0[name] as f32
    }

    /// Texels along a side.
    pub fn size(&self) -> usize {
        self.0["size"] as usize
    }

    /// Another seed, another image.
    pub fn seed(&self) -> u32 {
        self.0["seed"] as u32
    }

    /// As text, the same for equal arguments.
    pub fn text(&self) -> String {
        let each: Vec<String> = self.0.iter().map(|(name, value)| format!("{name}: {value}")).collect();
        each.join(", ")
    }
}

/// The work behind a recipe.
#[derive(Clone, Copy, Debug)]
pub struct Maker {
    /// The recipe's name.
    pub name: &'static str,
    /// Counts changes of what it makes: files of older revisions are made again.
    pub revision: u32,
    /// One map for each file of the recipe, in the recipe's order.
    pub make: fn(&Arguments) -> Vec<Map>,
}

/// The maker of a recipe.
///
/// # Panics
/// If the recipe has none: a test compares both tables.
pub fn maker(name: &str) -> &'static Maker {
    MAKERS.iter().find(|maker| maker.name == name).unwrap_or_else(|| panic!("recipe `{name}` has no maker"))
}

const fn maker_of(name: &'static str, revision: u32, make: fn(&Arguments) -> Vec<Map>) -> Maker {
    Maker { name, revision, make }
}

/// One for each recipe.
pub const MAKERS: &[Maker] = &[
    maker_of("bricks", 1, |arguments| material::bricks::make(arguments).maps(arguments)),
    maker_of("cracked_rock", 1, |arguments| material::cracked_rock::make(arguments).maps(arguments)),
    maker_of("dunes", 1, terrain::dunes::make),
    maker_of("forest_floor", 1, |arguments| material::forest_floor::make(arguments).maps(arguments)),
    maker_of("grass", 1, |arguments| material::grass::make(arguments).maps(arguments)),
    maker_of("mesas", 1, terrain::mesas::make),
    maker_of("moss", 1, |arguments| material::moss::make(arguments).maps(arguments)),
    maker_of("mountains", 3, terrain::mountains::make),
    maker_of("mud", 1, |arguments| material::mud::make(arguments).maps(arguments)),
    maker_of("pebbles", 1, |arguments| material::pebbles::make(arguments).maps(arguments)),
    maker_of("ripples", 1, |arguments| material::ripples::make(arguments).maps(arguments)),
    maker_of("sandstone", 1, |arguments| material::sandstone::make(arguments).maps(arguments)),
    maker_of("scree", 1, |arguments| material::scree::make(arguments).maps(arguments)),
    maker_of("snow", 1, |arguments| material::snow::make(arguments).maps(arguments)),
    maker_of("soil", 1, |arguments| material::soil::make(arguments).maps(arguments)),
];
