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
    /// The height map of a terrain, a 16-bit grey PNG at the path itself; beside it, `_height` at the end of its name
    /// replaced, 8-bit grey masks: `_flow.png` where water gathers and `_deposit.png` where loose ground lies.
    HeightMap,
    /// A material that tiles: `<path>_height.png` (16-bit grey), `<path>_albedo.png` (8-bit sRGB) and
    /// `<path>_normal.png` (8 bit; red east, green south, blue out of the ground).
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

const fn depth(default: f64) -> Argument {
    let doc = "Height of white over black, in sides of the tile: how steep the normals are.";
    argument("depth", doc, (0.0, 0.5), default)
}

const EXTENT: Argument = argument("extent", "Side of the land, metres.", (256.0, 65_536.0), 4096.0);

impl Makes {
    /// The files at a path of `terrane.ron`, for a `size` argument.
    pub fn files(self, path: &str, size: u32) -> Vec<(String, ImageHeader)> {
        let image = |channels, depth| ImageHeader { size: (size, size), channels, depth };
        match self {
            Self::HeightMap => {
                let stem = path.trim_end_matches(".png").trim_end_matches("_height");
                let mask = |role| (format!("{stem}_{role}.png"), image(1, 8));
                vec![(path.to_owned(), image(1, 16)), mask("flow"), mask("deposit")]
            }
            Self::Material => {
                let file = |role, header| (format!("{path}_{role}.png"), header);
                vec![file("height", image(1, 16)), file("albedo", image(3, 8)), file("normal", image(3, 8))]
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
        "bricks",
        "A wall of bricks with vertical sides and mortar between them; 2 m a tile.",
        &[
            size(1024.0),
            SEED,
            depth(0.01),
            argument("mortar", "How deep the joints are, of the depth.", (0.4, 0.9), 0.75),
        ],
    ),
    material(
        "cracked_rock",
        "Bedrock split by joints into blocks, grained and overgrown; 4 m a tile.",
        &[
            size(1024.0),
            SEED,
            depth(0.07),
            argument("cracks", "How many of the joints are open.", (0.0, 1.0), 0.5),
            argument("lichen", "How much of the surface is overgrown.", (0.0, 1.0), 0.35),
        ],
    ),
    height_map(
        "dunes",
        "A sea of sand: crescent ridges with steep lee sides, on swells of older dunes.",
        &[
            size(2048.0),
            SEED,
            EXTENT,
            argument("relief", "Metres from black to white.", (10.0, 9000.0), 120.0),
            argument("height", "Height of the highest dunes, metres.", (1.0, 200.0), 34.0),
        ],
    ),
    material(
        "forest_floor",
        "Litter of a conifer wood: needles, twigs, leaves, humus; 1.5 m a tile.",
        &[
            size(1024.0),
            SEED,
            depth(0.03),
            argument("leaves", "How many leaves lie among the needles.", (0.0, 4.0), 1.0),
        ],
    ),
    material(
        "grass",
        "Tufts of grass from above; 1.5 m a tile.",
        &[
            size(1024.0),
            SEED,
            depth(0.04),
            argument("cover", "How densely tufts stand.", (0.1, 1.5), 1.0),
            argument("dry", "Part of the blades that is dead.", (0.0, 1.0), 0.2),
            argument("length", "Longest blade, in sides of the tile.", (0.01, 0.2), 0.07),
        ],
    ),
    height_map(
        "mesas",
        "Flat-lying beds cut back to tables and towers, scree at their feet, dunes on the plain between.",
        &[
            size(2048.0),
            SEED,
            EXTENT,
            argument("relief", "Metres from black to white.", (50.0, 9000.0), 500.0),
            argument("dunes", "Height of the highest dunes, metres.", (0.0, 60.0), 11.0),
        ],
    ),
    material(
        "moss",
        "Cushions of moss; 1 m a tile.",
        &[size(1024.0), SEED, depth(0.035), argument("dry", "How much of it has browned.", (0.0, 1.0), 0.25)],
    ),
    height_map(
        "mountains",
        "An alpine range: ridges, cirques, scree, valleys with floors; rivers leave in the south and east.",
        &[
            size(2048.0),
            SEED,
            EXTENT,
            argument("relief", "Metres from black to white; summits above it are cut off.", (50.0, 9000.0), 1000.0),
        ],
    ),
    material(
        "mud",
        "Mud that dries and cracks; 2 m a tile.",
        &[
            size(1024.0),
            SEED,
            depth(0.02),
            argument("cracks", "How much of the ground has cracked.", (0.0, 1.0), 0.5),
            argument("wet", "0 is dry, 1 is soaked.", (0.0, 1.0), 0.5),
        ],
    ),
    material(
        "pebbles",
        "River stones, rounded, in sand; 2 m a tile.",
        &[
            size(1024.0),
            SEED,
            depth(0.035),
            argument("largest", "Radius of the largest stone, in sides of the tile.", (0.01, 0.2), 0.06),
            argument("sand", "How high the sand lies between the stones.", (0.0, 1.0), 0.3),
        ],
    ),
    material(
        "ripples",
        "Wind-blown sand in ripples that follow each other along u; 2 m a tile.",
        &[size(1024.0), SEED, depth(0.012), argument("count", "Ripples across the tile.", (4.0, 64.0), 18.0)],
    ),
    material(
        "sandstone",
        "Beds of sandstone with laminae, joints and hollows; u runs along the beds; 4 m a tile.",
        &[
            size(1024.0),
            SEED,
            depth(0.06),
            argument("beds", "Beds from the foot of the tile to its top.", (3.0, 40.0), 12.0),
        ],
    ),
    material(
        "scree",
        "Angular fragments of all sizes; 3 m a tile.",
        &[
            size(1024.0),
            SEED,
            depth(0.05),
            argument("largest", "Radius of the largest fragment, in sides of the tile.", (0.01, 0.2), 0.075),
        ],
    ),
    material(
        "snow",
        "Wind-packed snow with sastrugi along u; 6 m a tile.",
        &[size(1024.0), SEED, depth(0.025), argument("wind", "How deep the wind has cut.", (0.0, 1.0), 0.6)],
    ),
    material(
        "soil",
        "Bare soil: crumbs, clods, a few stones; 2 m a tile.",
        &[size(1024.0), SEED, depth(0.03), argument("stones", "How stony it is.", (0.0, 2.0), 0.6)],
    ),
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
