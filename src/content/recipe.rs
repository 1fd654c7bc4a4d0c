//! The recipes: names, arguments, files, and the functions that make them.

use std::collections::BTreeMap;

use super::error::Error;
use super::map::Map;
use super::{material, terrain};

/// What a project asks for: a recipe's name and arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// `cracked_rock`
    pub name: String,
    /// Only those that differ from their defaults need be there.
    pub args: BTreeMap<String, f64>,
}

/// A recipe's number.
#[derive(Clone, Copy, Debug)]
pub struct Argument {
    /// Its name.
    pub name: &'static str,
    /// What it means.
    pub doc: &'static str,
    /// Inclusive.
    pub range: (f64, f64),
    /// Where nothing is said.
    pub default: f64,
}

/// A recipe that can be asked for.
pub struct Maker {
    /// Its name.
    pub name: &'static str,
    /// Counts changes of what it makes: files of older revisions are made again.
    pub revision: u32,
    /// All its arguments.
    pub arguments: &'static [Argument],
    /// Ends of the file names.
    pub suffixes: &'static [&'static str],
    /// The work itself.
    pub make: fn(&Arguments) -> Vec<Map>,
}

/// The arguments of a recipe, complete and in range.
#[derive(Clone, Debug, PartialEq)]
pub struct Arguments(BTreeMap<&'static str, f64>);

impl Arguments {
    /// Defaults filled in, names and ranges checked.
    ///
    /// # Errors
    /// If an argument is unknown or outside its range.
    pub fn complete(key: &str, maker: &'static Maker, given: &BTreeMap<String, f64>) -> Result<Self, Error> {
        if let Some(name) = given.keys().find(|name| maker.arguments.iter().all(|a| a.name != name.as_str())) {
            return Err(Error::UnknownArgument { key: key.into(), recipe: maker.name, argument: name.clone() });
        }
        let value = |argument: &'static Argument| {
            let value = given.get(argument.name).copied().unwrap_or(argument.default);
            let (low, high) = argument.range;
            if (low..=high).contains(&value) {
                return Ok((argument.name, value));
            }
            Err(Error::OutOfRange { key: key.into(), argument: argument.name, value, range: argument.range })
        };
        Ok(Self(maker.arguments.iter().map(value).collect::<Result<_, _>>()?))
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

/// The recipe of a name.
pub fn find(name: &str) -> Option<&'static Maker> {
    MAKERS.iter().find(|maker| maker.name == name)
}

const fn size(default: f64) -> Argument {
    Argument { name: "size", doc: "Texels along a side.", range: (16.0, 8192.0), default }
}

const SEED: Argument =
    Argument { name: "seed", doc: "Another seed, another image.", range: (0.0, 65_535.0), default: 1.0 };

const fn argument(name: &'static str, doc: &'static str, range: (f64, f64), default: f64) -> Argument {
    Argument { name, doc, range, default }
}

const MATERIAL: &[&str] = &["_height", "_albedo"];

/// Every recipe.
pub const MAKERS: &[Maker] = &[
    Maker {
        name: "cracked_rock",
        revision: 1,
        arguments: &[
            size(1024.0),
            SEED,
            argument("cracks", "How many of the joints are open.", (0.0, 1.0), 0.6),
            argument("lichen", "How much of the surface is overgrown.", (0.0, 1.0), 0.35),
        ],
        suffixes: MATERIAL,
        make: |arguments| material::cracked_rock::make(arguments).maps(),
    },
    Maker {
        name: "scree",
        revision: 1,
        arguments: &[
            size(1024.0),
            SEED,
            argument("largest", "Radius of the largest fragment, in sides of the tile.", (0.01, 0.2), 0.075),
        ],
        suffixes: MATERIAL,
        make: |arguments| material::scree::make(arguments).maps(),
    },
    Maker {
        name: "pebbles",
        revision: 1,
        arguments: &[
            size(1024.0),
            SEED,
            argument("largest", "Radius of the largest stone, in sides of the tile.", (0.01, 0.2), 0.06),
            argument("sand", "How high the sand lies between the stones.", (0.0, 1.0), 0.3),
        ],
        suffixes: MATERIAL,
        make: |arguments| material::pebbles::make(arguments).maps(),
    },
    Maker {
        name: "ripples",
        revision: 1,
        arguments: &[size(1024.0), SEED, argument("count", "Ripples across the tile.", (4.0, 64.0), 18.0)],
        suffixes: MATERIAL,
        make: |arguments| material::ripples::make(arguments).maps(),
    },
    Maker {
        name: "snow",
        revision: 1,
        arguments: &[size(1024.0), SEED, argument("wind", "How deep the wind has cut.", (0.0, 1.0), 0.6)],
        suffixes: MATERIAL,
        make: |arguments| material::snow::make(arguments).maps(),
    },
    Maker {
        name: "mud",
        revision: 1,
        arguments: &[
            size(1024.0),
            SEED,
            argument("cracks", "How much of the ground has cracked.", (0.0, 1.0), 0.5),
            argument("wet", "0 is dry, 1 is soaked.", (0.0, 1.0), 0.5),
        ],
        suffixes: MATERIAL,
        make: |arguments| material::mud::make(arguments).maps(),
    },
    Maker {
        name: "grass",
        revision: 1,
        arguments: &[
            size(1024.0),
            SEED,
            argument("dry", "Part of the blades that is dead.", (0.0, 1.0), 0.2),
            argument("length", "Longest blade, in sides of the tile.", (0.01, 0.2), 0.07),
            argument("cover", "How densely tufts stand.", (0.1, 1.5), 1.0),
        ],
        suffixes: MATERIAL,
        make: |arguments| material::grass::make(arguments).maps(),
    },
    Maker {
        name: "moss",
        revision: 1,
        arguments: &[size(1024.0), SEED, argument("dry", "How much of it has browned.", (0.0, 1.0), 0.25)],
        suffixes: MATERIAL,
        make: |arguments| material::moss::make(arguments).maps(),
    },
    Maker {
        name: "forest_floor",
        revision: 1,
        arguments: &[size(1024.0), SEED, argument("leaves", "How many leaves lie among the needles.", (0.0, 4.0), 1.0)],
        suffixes: MATERIAL,
        make: |arguments| material::forest_floor::make(arguments).maps(),
    },
    Maker {
        name: "soil",
        revision: 1,
        arguments: &[size(1024.0), SEED, argument("stones", "How stony it is.", (0.0, 2.0), 0.6)],
        suffixes: MATERIAL,
        make: |arguments| material::soil::make(arguments).maps(),
    },
    Maker {
        name: "sandstone",
        revision: 1,
        arguments: &[
            size(1024.0),
            SEED,
            argument("beds", "Beds from the foot of the tile to its top.", (3.0, 40.0), 12.0),
        ],
        suffixes: MATERIAL,
        make: |arguments| material::sandstone::make(arguments).maps(),
    },
    Maker {
        name: "mountains",
        revision: 1,
        arguments: &[
            size(2048.0),
            SEED,
            argument("extent", "Side of the land, metres.", (256.0, 65_536.0), 4096.0),
            argument("relief", "Metres from black to white; peaks above it are cut.", (50.0, 9000.0), 1000.0),
        ],
        suffixes: &["_height", "_flow", "_deposit"],
        make: terrain::mountains::make,
    },
    Maker {
        name: "mesas",
        revision: 1,
        arguments: &[
            size(2048.0),
            SEED,
            argument("extent", "Side of the land, metres.", (256.0, 65_536.0), 4096.0),
            argument("relief", "Metres from black to white.", (50.0, 9000.0), 500.0),
            argument("dunes", "Height of the highest dunes, metres.", (0.0, 60.0), 11.0),
        ],
        suffixes: &["_height", "_flow", "_deposit"],
        make: terrain::mesas::make,
    },
];
