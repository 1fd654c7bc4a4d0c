//! The content that Terrane makes itself: the same bytes everywhere, without seams, of believable colours, and made
//! again only when it must be.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use terrane::content::map::{Map, Texels};
use terrane::content::recipe::{Arguments, MAKERS, maker};
use terrane::content::{color, make_under};
use terrane_codegen::diagnostic::{SourceId, Span};
use terrane_codegen::graph::Made;
use terrane_codegen::graph::recipe::{Makes, RECIPES, Recipe, recipe};

/// Small enough to be quick, large enough for statistics.
const SIZE: usize = 128;

fn made(path: &str, recipe: &'static Recipe, size: usize, seed: u32) -> Made {
    let mut arguments: BTreeMap<_, _> = recipe.arguments.iter().map(|a| (a.name, a.default)).collect();
    arguments.extend([("size", size as f64), ("seed", f64::from(seed))]);
    let files = recipe.makes.files(path, size as u32);
    let span = Span { source: SourceId(0), start: 0, end: 0 };
    Made { path: path.into(), recipe, arguments, files, span }
}

fn maps(recipe: &'static Recipe, size: usize, seed: u32) -> Vec<Map> {
    (maker(recipe.name).make)(&Arguments::defaults(recipe, size as u32, seed))
}

fn materials() -> impl Iterator<Item = &'static Recipe> {
    RECIPES.iter().filter(|recipe| recipe.makes == Makes::Material)
}

fn lands() -> impl Iterator<Item = &'static Recipe> {
    RECIPES.iter().filter(|recipe| recipe.makes == Makes::HeightMap)
}

fn height(maps: &[Map]) -> Vec<f32> {
    let Texels::Grey16(texels) = &maps[0].texels else { panic!("heights have 16 bits") };
    texels.iter().map(|&texel| f32::from(texel) / 65_535.0).collect()
}

/// Linear red, green and blue.
fn albedo(maps: &[Map]) -> Vec<[f32; 3]> {
    let Texels::Srgb8(bytes) = &maps[1].texels else { panic!("albedo has colours") };
    bytes.as_chunks::<3>().0.iter().map(|&texel| texel.map(|x| color::decode(f32::from(x) / 255.0))).collect()
}

/// FNV-1a over the texels.
fn digest(maps: &[Map]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut take = |byte: u8| hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    for map in maps {
        match &map.texels {
            Texels::Grey16(texels) => texels.iter().flat_map(|texel| texel.to_be_bytes()).for_each(&mut take),
            Texels::Grey8(bytes) | Texels::Srgb8(bytes) | Texels::Rgb8(bytes) => {
                bytes.iter().copied().for_each(&mut take)
            }
        }
    }
    hash
}

#[test]
fn bytes_do_not_depend_on_the_number_of_threads() {
    let digests = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads");
        pool.install(|| RECIPES.iter().map(|recipe| digest(&maps(recipe, 64, 5))).collect::<Vec<_>>())
    };
    assert_eq!(digests(1), digests(3));
}

/// A change of a recipe's bytes needs a new revision, or caches would keep what the older one made. The digests also
/// hold other machines to the same bytes.
#[test]
fn a_recipe_changes_only_with_its_revision() {
    let mut table = String::new();
    for recipe in RECIPES {
        let digest = digest(&maps(recipe, 64, 1));
        writeln!(table, "{} {} {digest:016x}", recipe.name, maker(recipe.name).revision)
            .expect("strings take all text");
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/content.digests");
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&path, &table).expect("the digests can be written");
    }
    let expected = std::fs::read_to_string(&path).expect("the digests can be read");
    assert_eq!(table, expected, "raise the revision of what changed, then bless with `BLESS=1 cargo test content`");
}

#[test]
fn seeds_give_different_images() {
    for recipe in RECIPES {
        assert_ne!(digest(&maps(recipe, 64, 1)), digest(&maps(recipe, 64, 2)), "{}", recipe.name);
    }
}

#[test]
fn every_recipe_has_a_maker_that_keeps_its_promise() {
    assert!(RECIPES.iter().map(|recipe| recipe.name).eq(MAKERS.iter().map(|maker| maker.name)));
    for recipe in RECIPES {
        let promised = recipe.makes.files("test", 64);
        let maps = maps(recipe, 64, 3);
        assert_eq!(maps.len(), promised.len(), "{}", recipe.name);
        for ((file, header), map) in promised.iter().zip(&maps) {
            let (channels, depth, texels) = match &map.texels {
                Texels::Grey16(texels) => (1, 16, texels.len()),
                Texels::Grey8(bytes) => (1, 8, bytes.len()),
                Texels::Srgb8(bytes) | Texels::Rgb8(bytes) => (3, 8, bytes.len() / 3),
            };
            assert_eq!((header.channels, header.depth), (channels, depth), "{}: {file}", recipe.name);
            assert_eq!((map.size, texels), (64, 64 * 64), "{}: {file}", recipe.name);
        }
    }
}

/// Mean difference across each line between columns; the last is the seam.
fn steps(values: &[f32], transposed: bool) -> Vec<f32> {
    let at = |x: usize, y: usize| if transposed { values[x * SIZE + y] } else { values[y * SIZE + x] };
    let step = |x: usize| (0..SIZE).map(|y| (at((x + 1) % SIZE, y) - at(x, y)).abs()).sum::<f32>() / SIZE as f32;
    (0..SIZE).map(step).collect()
}

/// A line between beds is as much a step as a seam: the seam may not be steeper than the steepest line inside.
fn seamless(values: &[f32], what: &str) {
    for transposed in [false, true] {
        let steps = steps(values, transposed);
        let (seam, inside) = (steps[SIZE - 1], &steps[..SIZE - 1]);
        let mean = inside.iter().sum::<f32>() / inside.len() as f32;
        let most = inside.iter().copied().fold(0.0, f32::max);
        assert!(seam <= most.max(1.3 * mean), "{what}: the seam steps by {seam}, inside by {mean} and at most {most}");
    }
}

#[test]
fn materials_tile() {
    for recipe in materials() {
        let maps = maps(recipe, SIZE, 1);
        seamless(&height(&maps), recipe.name);
        let light: Vec<f32> = albedo(&maps).into_iter().map(color::luminance).collect();
        seamless(&light, recipe.name);
    }
}

#[test]
fn a_seam_is_found() {
    let ramp: Vec<f32> = (0..SIZE * SIZE).map(|index| (index % SIZE) as f32 / SIZE as f32).collect();
    assert!(std::panic::catch_unwind(|| seamless(&ramp, "ramp")).is_err());
}

#[test]
fn heights_use_their_range() {
    for recipe in materials() {
        let mut height = height(&maps(recipe, SIZE, 1));
        height.sort_by(f32::total_cmp);
        let at = |part: f32| height[((height.len() - 1) as f32 * part) as usize];
        assert!(at(0.0) < 0.001 && at(1.0) > 0.999, "{}", recipe.name);
        assert!(at(0.95) - at(0.05) > 0.25, "{}: most heights lie within {}..{}", recipe.name, at(0.05), at(0.95));
        height.dedup();
        assert!(height.len() > SIZE * SIZE / 4, "{}: only {} different heights", recipe.name, height.len());
    }
}

/// Measured reflectances of such grounds, linear luminance.
#[test]
fn albedo_is_believable() {
    let ranges = BTreeMap::from([
        ("bricks", (0.1, 0.25)),
        ("cracked_rock", (0.2, 0.35)),
        ("forest_floor", (0.06, 0.15)),
        ("grass", (0.05, 0.15)),
        ("moss", (0.04, 0.12)),
        ("mud", (0.05, 0.2)),
        ("pebbles", (0.12, 0.3)),
        ("ripples", (0.3, 0.42)),
        ("sandstone", (0.2, 0.35)),
        ("scree", (0.15, 0.3)),
        ("snow", (0.78, 0.92)),
        ("soil", (0.08, 0.2)),
    ]);
    assert!(materials().all(|recipe| ranges.contains_key(recipe.name)));
    for recipe in materials() {
        let (low, high) = ranges[recipe.name];
        let light: Vec<f32> = albedo(&maps(recipe, SIZE, 1)).into_iter().map(color::luminance).collect();
        let mean = light.iter().sum::<f32>() / light.len() as f32;
        assert!((low..=high).contains(&mean), "{}: {mean} is not within {low}..{high}", recipe.name);
        let most = light.iter().copied().fold(0.0, f32::max);
        assert!(most < 0.95, "{}: {most} is brighter than fresh snow", recipe.name);
    }
}

#[test]
fn land_uses_its_range_and_has_rivers() {
    for recipe in lands() {
        let maps = maps(recipe, SIZE, 1);
        let height = height(&maps);
        let cut = height.iter().filter(|&&height| height >= 1.0).count();
        assert!(cut * 1000 < height.len(), "{}: {cut} summits are cut off", recipe.name);
        assert!(height.iter().any(|&height| height > 0.5), "{}", recipe.name);
        let Texels::Grey8(flow) = &maps[1].texels else { panic!("flow has 8 bits") };
        let rivers = flow.iter().filter(|&&flow| flow > 180).count() as f32 / flow.len() as f32;
        assert!((0.001..0.2).contains(&rivers), "{}: rivers cover {rivers}", recipe.name);
    }
}

#[test]
fn normals_are_those_of_the_heights() {
    for recipe in materials() {
        let maps = maps(recipe, SIZE, 1);
        let Texels::Rgb8(bytes) = &maps[2].texels else { panic!("normals have three numbers") };
        let height = height(&maps);
        let at = |x: usize, y: usize| height[y % SIZE * SIZE + x % SIZE];
        let depth = Arguments::defaults(recipe, SIZE as u32, 1).get("depth") * SIZE as f32;
        for (index, normal) in bytes.as_chunks::<3>().0.iter().enumerate() {
            let (x, y) = (index % SIZE + SIZE, index / SIZE + SIZE);
            let (du, dv) = (0.5 * depth * (at(x + 1, y) - at(x - 1, y)), 0.5 * depth * (at(x, y + 1) - at(x, y - 1)));
            let [east, south, up] = normal.map(|x| f32::from(x) / 127.5 - 1.0);
            assert!((east * east + south * south + up * up - 1.0).abs() < 0.03, "{}", recipe.name);
            let off = (east + du * up).abs().max((south + dv * up).abs());
            assert!(off < 0.02, "{} at {index}: {normal:?}, the slopes are {du} and {dv}", recipe.name);
        }
    }
}

fn sand_and_snow(seed: u32) -> [Made; 2] {
    let of = |name| recipe(name).expect("a recipe of the table");
    [made("textures/sand", of("ripples"), 32, seed), made("textures/snow", of("snow"), 32, 1)]
}

fn names(paths: &[PathBuf]) -> Vec<String> {
    paths.iter().map(|path| path.file_name().unwrap_or_default().to_string_lossy().into_owned()).collect()
}

#[test]
fn files_are_made_once_and_again_when_the_recipe_changes() {
    let root = tempfile::tempdir().expect("a temporary folder");
    let make = |all: &[Made; 2]| make_under(root.path(), &[&all[0], &all[1]]).expect("all can be made");
    let first = make(&sand_and_snow(1));
    assert_eq!(first.len(), 6);
    assert!(first.iter().all(|path| path.is_file()));
    assert_eq!(make(&sand_and_snow(1)), Vec::<PathBuf>::new());
    assert_eq!(names(&make(&sand_and_snow(2))), ["sand_height.png", "sand_albedo.png", "sand_normal.png"]);
    std::fs::remove_file(root.path().join("textures/snow_albedo.png")).expect("it is there");
    assert_eq!(names(&make(&sand_and_snow(2))), ["snow_height.png", "snow_albedo.png", "snow_normal.png"]);
}

#[test]
fn a_damaged_file_is_made_again() {
    let root = tempfile::tempdir().expect("a temporary folder");
    let [_, snow] = sand_and_snow(1);
    make_under(root.path(), &[&snow]).expect("it can be made");
    let path = root.path().join("textures/snow_height.png");
    let good = std::fs::read(&path).expect("it is there");
    std::fs::write(&path, &good[..20]).expect("it can be cut off");
    assert_eq!(make_under(root.path(), &[&snow]).expect("it can be made again").len(), 3);
    assert_eq!(std::fs::read(&path).expect("it is there"), good);
}

#[test]
fn a_failed_write_leaves_what_was_there() {
    let root = tempfile::tempdir().expect("a temporary folder");
    let folder = root.path().join("textures");
    // A folder stands where the second file belongs: the rename fails.
    std::fs::create_dir_all(folder.join("snow_albedo.png/occupied")).expect("a folder can be made");
    let error = make_under(root.path(), &[&sand_and_snow(1)[1]]).expect_err("a folder cannot be replaced");
    assert!(error.path.ends_with("snow_albedo.png"), "{error}");
    assert!(folder.join("snow_albedo.png/occupied").is_dir());
    let left: Vec<_> = std::fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.file_name()).collect();
    assert!(left.iter().all(|name| !name.to_string_lossy().ends_with(".new")), "{left:?}");
}
