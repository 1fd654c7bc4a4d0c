//! Small pictures of whole scenes and of surfaces.

use std::fs;
use std::path::{Path, PathBuf};

use terrane::render::Gpu;

use super::flip::Difference;
use super::{HOW, accepted, blessing};
use crate::picture::Picture;
use crate::scratch::Scratch;
use crate::skip::Skip;

/// They are part of the repository for ever.
const BYTES: u64 = 16 * 1024;

/// Over the dunes of the example, late in the day.
const SCENE: &str = r#"Scene(
    version: 1,
    terrain: "graphs/terrains/dunes.ron",
    image: (128, 72),
    camera: (eye: (200.0, 95.0, 900.0), target: (600.0, 30.0, 400.0), fov: 50.0),
    sun: (azimuth: 250.0, elevation: 20.0),
    sky: clear(turbidity: 3.0),
    exposure: 0.0,
)
"#;

#[test]
fn dunes() {
    let scratch = Scratch::of("examples/build_script");
    fs::create_dir(scratch.path("graphs/scenes")).unwrap();
    fs::write(scratch.path("graphs/scenes/late.ron"), SCENE).unwrap();
    compare(&scratch, "dunes", "graphs/scenes/late.ron");
}

#[test]
fn sand() {
    compare(&Scratch::of("examples/build_script"), "sand", "graphs/surfaces/sand.ron");
}

#[test]
fn rock() {
    compare(&Scratch::of("src/commands/starter"), "rock", "graphs/surfaces/rock.ron");
}

/// Draws a graph and compares the picture with the accepted one.
#[track_caller]
fn compare(scratch: &Scratch, name: &str, graph: &str) {
    if Gpu::list().is_empty() {
        return Skip("no adapter".into()).report();
    }
    scratch.terrane(&["render", graph, "-o", "found.png", "--size", "128x72"]);
    let found = Picture::read(&scratch.path("found.png")).expect("what terrane wrote can be read");
    let path = accepted("golden").join(format!("{name}.png"));
    if blessing() {
        found.write(&path).expect("the picture can be written");
        let bytes = fs::metadata(&path).expect("written above").len();
        assert!(bytes <= BYTES, "{name}.png has {bytes} bytes, {BYTES} are the limit");
        return;
    }
    let known = Picture::read(&path).unwrap_or_else(|error| panic!("{error}; {HOW}"));
    assert_eq!((known.width, known.height), (found.width, found.height), "{name}: another size");
    let difference = Difference::of(&known, &found);
    if !difference.is_small() {
        let folder = keep(name, &found, &difference.map);
        let (mean, p99) = (difference.mean, difference.p99);
        panic!("{name} looks different: FLIP {mean:.4} in the mean, {p99:.4} at p99; see {}; {HOW}", folder.display());
    }
}

/// Leaves the picture and the difference where a person can look at them.
fn keep(name: &str, found: &Picture, map: &Picture) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden");
    fs::create_dir_all(&folder).expect("cargo's folder for tests is writable");
    found.write(&folder.join(format!("{name}.found.png"))).expect("a writable folder");
    map.write(&folder.join(format!("{name}.difference.png"))).expect("a writable folder");
    folder
}
