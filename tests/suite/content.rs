//! The content that Terrane makes itself: the same bytes everywhere, without seams, of believable colours, and made
//! again only when it must be.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use terrane::content::map::{Map, Texels};
use terrane::content::recipe::{Arguments, MAKERS, Maker, Recipe};
use terrane::content::{Error, Job, color, make};

/// Small enough to be quick, large enough for statistics.
const SIZE: usize = 128;

fn maps(maker: &'static Maker, size: usize, seed: u32) -> Vec<Map> {
    let given = BTreeMap::from([("size".to_owned(), size as f64), ("seed".to_owned(), f64::from(seed))]);
    (maker.make)(&Arguments::complete("test", maker, &given).expect("size and seed are arguments of every recipe"))
}

fn materials() -> impl Iterator<Item = &'static Maker> {
    MAKERS.iter().filter(|maker| maker.suffixes.contains(&"_albedo"))
}

fn height(maps: &[Map]) -> Vec<f32> {
    match &maps[0].texels {
        Texels::Grey16(texels) => texels.iter().map(|&texel| f32::from(texel) / 65_535.0).collect(),
        Texels::Grey8(_) | Texels::Rgb8(_) => panic!("heights have 16 bits"),
    }
}

/// Linear red, green and blue.
fn albedo(maps: &[Map]) -> Vec<[f32; 3]> {
    match &maps[1].texels {
        Texels::Rgb8(bytes) => {
            bytes.as_chunks::<3>().0.iter().map(|&texel| texel.map(|x| color::decode(f32::from(x) / 255.0))).collect()
        }
        Texels::Grey8(_) | Texels::Grey16(_) => panic!("albedo has colours"),
    }
}

fn job(key: &str, name: &str, size: usize, seed: u32) -> Job {
    let args = BTreeMap::from([("size".to_owned(), size as f64), ("seed".to_owned(), f64::from(seed))]);
    Job { key: key.into(), recipe: Recipe { name: name.into(), args } }
}

/// FNV-1a over the texels.
fn digest(maps: &[Map]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut take = |byte: u8| hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    for map in maps {
        match &map.texels {
            Texels::Grey16(texels) => texels.iter().flat_map(|texel| texel.to_be_bytes()).for_each(&mut take),
            Texels::Grey8(bytes) | Texels::Rgb8(bytes) => bytes.iter().copied().for_each(&mut take),
        }
    }
    hash
}

#[test]
fn bytes_do_not_depend_on_the_number_of_threads() {
    let digests = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads");
        pool.install(|| MAKERS.iter().map(|maker| digest(&maps(maker, 64, 5))).collect::<Vec<_>>())
    };
    assert_eq!(digests(1), digests(3));
}

/// A change of a recipe's bytes needs a new revision, or caches would keep what the older one made. The digests also
/// hold other machines to the same bytes.
#[test]
fn a_recipe_changes_only_with_its_revision() {
    let mut table = String::new();
    for maker in MAKERS {
        let digest = digest(&maps(maker, 64, 1));
        writeln!(table, "{} {} {digest:016x}", maker.name, maker.revision).expect("strings take all text");
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
    for maker in MAKERS {
        assert_ne!(digest(&maps(maker, 64, 1)), digest(&maps(maker, 64, 2)), "{}", maker.name);
    }
}

#[test]
fn every_recipe_gives_the_maps_that_it_names() {
    for maker in MAKERS {
        let maps = maps(maker, 64, 3);
        let suffixes: Vec<_> = maps.iter().map(|map| map.suffix).collect();
        assert_eq!(suffixes, maker.suffixes, "{}", maker.name);
        assert!(maps.iter().all(|map| map.size == 64), "{}", maker.name);
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
    for maker in materials() {
        let maps = maps(maker, SIZE, 1);
        seamless(&height(&maps), maker.name);
        let light: Vec<f32> = albedo(&maps).into_iter().map(color::luminance).collect();
        seamless(&light, maker.name);
    }
}

#[test]
fn a_seam_is_found() {
    let ramp: Vec<f32> = (0..SIZE * SIZE).map(|index| (index % SIZE) as f32 / SIZE as f32).collect();
    assert!(std::panic::catch_unwind(|| seamless(&ramp, "ramp")).is_err());
}

#[test]
fn heights_use_their_range() {
    for maker in materials() {
        let mut height = height(&maps(maker, SIZE, 1));
        height.sort_by(f32::total_cmp);
        let at = |part: f32| height[((height.len() - 1) as f32 * part) as usize];
        assert!(at(0.0) < 0.001 && at(1.0) > 0.999, "{}", maker.name);
        assert!(at(0.95) - at(0.05) > 0.25, "{}: most heights lie within {}..{}", maker.name, at(0.05), at(0.95));
        height.dedup();
        assert!(height.len() > SIZE * SIZE / 4, "{}: only {} different heights", maker.name, height.len());
    }
}

/// Measured reflectances of such grounds, linear luminance.
#[test]
fn albedo_is_believable() {
    let ranges = BTreeMap::from([
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
    assert!(materials().all(|maker| ranges.contains_key(maker.name)));
    for maker in materials() {
        let (low, high) = ranges[maker.name];
        let light: Vec<f32> = albedo(&maps(maker, SIZE, 1)).into_iter().map(color::luminance).collect();
        let mean = light.iter().sum::<f32>() / light.len() as f32;
        assert!((low..=high).contains(&mean), "{}: {mean} is not within {low}..{high}", maker.name);
        let most = light.iter().copied().fold(0.0, f32::max);
        assert!(most < 0.95, "{}: {most} is brighter than fresh snow", maker.name);
    }
}

#[test]
fn land_uses_its_range_and_has_rivers() {
    for maker in MAKERS.iter().filter(|maker| maker.suffixes.contains(&"_flow")) {
        let maps = maps(maker, SIZE, 1);
        let height = height(&maps);
        let cut = height.iter().filter(|&&height| height >= 1.0).count();
        assert!(cut * 1000 < height.len(), "{}: {cut} summits are cut off", maker.name);
        assert!(height.iter().any(|&height| height > 0.5), "{}", maker.name);
        let Texels::Grey8(flow) = &maps[1].texels else { panic!("flow has 8 bits") };
        let rivers = flow.iter().filter(|&&flow| flow > 180).count() as f32 / flow.len() as f32;
        assert!((0.001..0.2).contains(&rivers), "{}: rivers cover {rivers}", maker.name);
    }
}

#[test]
fn files_are_made_once_and_again_when_the_recipe_changes() {
    let root = tempfile::tempdir().expect("a temporary folder");
    let jobs = [job("textures/sand", "ripples", 32, 1), job("textures/snow", "snow", 32, 1)];
    let first = make(&jobs, root.path()).expect("all can be made");
    assert_eq!(first.len(), 4);
    assert!(first.iter().all(|path| path.is_file()));
    assert!(make(&jobs, root.path()).expect("nothing is left to do").is_empty());

    let changed = [job("textures/sand", "ripples", 32, 2), jobs[1].clone()];
    let names = |paths: Vec<std::path::PathBuf>| {
        paths.iter().map(|path| path.file_name().unwrap_or_default().to_string_lossy().into_owned()).collect::<Vec<_>>()
    };
    let second = names(make(&changed, root.path()).expect("one can be made again"));
    assert_eq!(second, ["sand_height.png", "sand_albedo.png"]);

    std::fs::remove_file(root.path().join("textures/snow_albedo.png")).expect("it is there");
    assert_eq!(names(make(&changed, root.path()).expect("the rest is made")), ["snow_height.png", "snow_albedo.png"]);
}

#[test]
fn a_damaged_file_is_made_again() {
    let root = tempfile::tempdir().expect("a temporary folder");
    let jobs = [job("snow", "snow", 32, 1)];
    make(&jobs, root.path()).expect("it can be made");
    let path = root.path().join("snow_height.png");
    let good = std::fs::read(&path).expect("it is there");
    std::fs::write(&path, &good[..20]).expect("it can be cut off");
    assert_eq!(make(&jobs, root.path()).expect("it can be made again").len(), 2);
    assert_eq!(std::fs::read(&path).expect("it is there"), good);
}

#[test]
fn a_failed_write_leaves_what_was_there() {
    let root = tempfile::tempdir().expect("a temporary folder");
    // A folder stands where the second file belongs: the rename fails.
    std::fs::create_dir_all(root.path().join("snow_albedo.png/occupied")).expect("a folder can be made");
    let error = make(&[job("snow", "snow", 32, 1)], root.path()).expect_err("a folder cannot be replaced");
    assert!(matches!(&error, Error::Write { path, .. } if path.ends_with("snow_albedo.png")), "{error}");
    assert!(root.path().join("snow_albedo.png/occupied").is_dir());
    let left: Vec<_> =
        std::fs::read_dir(root.path()).expect("a folder").flatten().map(|entry| entry.file_name()).collect();
    assert!(left.iter().all(|name| !name.to_string_lossy().ends_with(".new")), "{left:?}");
}

#[test]
fn wrong_recipes_are_refused_before_anything_is_made() {
    let root = tempfile::tempdir().expect("a temporary folder");
    let mut out_of_range = job("b", "snow", 32, 1);
    out_of_range.recipe.args.insert("wind".into(), 2.0);
    let mut unknown = job("b", "snow", 32, 1);
    unknown.recipe.args.insert("wimd".into(), 0.5);
    for (wrong, message) in [
        (job("b", "snwo", 32, 1), "no recipe `snwo` to make `b` with"),
        (out_of_range, "argument `wind` of `b` is 2, its range is 0..1"),
        (unknown, "recipe `snow` of `b` has no argument `wimd`"),
    ] {
        let error = make(&[job("a", "snow", 32, 1), wrong], root.path()).expect_err("the second job is wrong");
        assert_eq!(error.to_string(), message);
    }
    assert_eq!(std::fs::read_dir(root.path()).expect("a folder").count(), 0);
}
