//! What `terrane.ron` can ask for: files that terrane makes itself. Signatures only; the makers know how.

use super::image::ImageHeader;

/// One kind of thing that can be made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    /// Name in `terrane.ron`.
    pub name: &'static str,
    /// One sentence.
    pub doc: &'static str,
    /// What it makes.
    pub makes: Makes,
    /// Every argument; `size` and `seed` are among them.
    pub arguments: &'static [Argument],
}

/// The files of a recipe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Makes {
    /// The height map of a terrain: one 16-bit grey PNG at the path itself.
    HeightMap,
    /// A material that tiles: `<path>_height.png` (16-bit grey) and `<path>_albedo.png` (8-bit sRGB).
    Material,
}

/// A number that a recipe takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Argument {
    /// Its name.
    pub name: &'static str,
    /// One sentence.
    pub doc: &'static str,
    /// Inclusive.
    pub range: (f64, f64),
    /// Without one.
    pub default: f64,
    /// Whether it must have no fraction.
    pub whole: bool,
}

const SEED: Argument = Argument {
    name: "seed",
    doc: "Another seed, another image of the same character.",
    range: (0.0, 65_535.0),
    default: 1.0,
    whole: true,
};

const fn size(default: f64) -> Argument {
    Argument { name: "size", doc: "Texels along a side.", range: (16.0, 8192.0), default, whole: true }
}

const fn argument(name: &'static str, doc: &'static str, range: (f64, f64), default: f64) -> Argument {
    Argument { name, doc, range, default, whole: false }
}

impl Makes {
    /// The files at a path of `terrane.ron`, for a `size` argument.
    pub fn files(self, path: &str, size: u32) -> Vec<(String, ImageHeader)> {
        let image = |channels, depth| ImageHeader { size: (size, size), channels, depth };
        match self {
            Self::HeightMap => vec![(path.to_owned(), image(1, 16))],
            Self::Material => {
                vec![(format!("{path}_height.png"), image(1, 16)), (format!("{path}_albedo.png"), image(3, 8))]
            }
        }
    }
}

const fn height_map(name: &'static str, doc: &'static str, arguments: &'static [Argument]) -> Recipe {
    Recipe { name, doc, makes: Makes::HeightMap, arguments }
}

const fn material(name: &'static str, doc: &'static str, arguments: &'static [Argument]) -> Recipe {
    Recipe { name, doc, makes: Makes::Material, arguments }
}

/// Every recipe, sorted by name.
pub const RECIPES: &[Recipe] = &[
    material(
        "cracked_rock",
        "Bedrock split by joints.",
        &[
            size(1024.0),
            SEED,
            argument("cracks", "How many of the joints are open.", (0.0, 1.0), 0.6),
            argument("lichen", "How much of the surface is overgrown.", (0.0, 1.0), 0.35),
        ],
    ),
    height_map("dunes", "Wind-blown sand.", &[size(1024.0), SEED]),
    material("forest_floor", "Litter of leaves and needles.", &[size(1024.0), SEED]),
    material("grass", "Blades of grass from above.", &[size(1024.0), SEED]),
    material("moss", "Cushions of moss.", &[size(1024.0), SEED]),
    height_map("mountains", "Eroded ridges and valleys.", &[size(1024.0), SEED]),
    material("mud", "Drying mud.", &[size(1024.0), SEED]),
    material(
        "pebbles",
        "Round stones, close together.",
        &[
            size(1024.0),
            SEED,
            argument("largest", "Radius of the largest stone, in sides of the tile.", (0.01, 0.2), 0.06),
            argument("sand", "How high the sand lies between the stones.", (0.0, 1.0), 0.3),
        ],
    ),
    material("ripples", "Sand ripples.", &[size(1024.0), SEED]),
    material("sand", "Fine sand.", &[size(1024.0), SEED]),
    material(
        "scree",
        "Angular stones of mixed size.",
        &[
            size(1024.0),
            SEED,
            argument("largest", "Radius of the largest fragment, in sides of the tile.", (0.01, 0.2), 0.075),
        ],
    ),
    material("snow", "Wind-packed snow.", &[size(1024.0), SEED]),
];

/// A recipe by name.
pub fn recipe(name: &str) -> Option<&'static Recipe> {
    RECIPES.iter().find(|recipe| recipe.name == name)
}

#[cfg(test)]
mod tests {
    use super::RECIPES;

    #[test]
    fn names_are_sorted_and_defaults_are_in_range() {
        assert!(RECIPES.windows(2).all(|pair| pair[0].name < pair[1].name));
        for recipe in RECIPES {
            assert!(recipe.arguments.iter().any(|argument| argument.name == "size"), "{}", recipe.name);
            for argument in recipe.arguments {
                let (low, high) = argument.range;
                assert!((low..=high).contains(&argument.default), "{}: {}", recipe.name, argument.name);
                assert!(!argument.whole || argument.default.fract() == 0.0, "{}: {}", recipe.name, argument.name);
            }
        }
    }
}
