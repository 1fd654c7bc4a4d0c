//! The engine of `examples/embed` draws what `terrane build` writes, and knows nothing else.

#[path = "../../examples/embed/main.rs"]
#[expect(dead_code, reason = "an example has a `main` of its own")]
mod engine;

use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};

use crate::picture::Picture;
use crate::scratch::Scratch;
use crate::skip::Skip;
use crate::tint::{Module, Report, Tint};

/// What `terrane build` makes of the project of `examples/build_script`.
struct Built(Scratch);

impl Built {
    fn new() -> Self {
        let scratch = Scratch::of("examples/build_script");
        scratch.terrane(&["build", "graphs/terrains/dunes.ron", "-o", "out"]);
        Self(scratch)
    }

    fn manifest(&self) -> PathBuf {
        self.0.path("out/dunes.json")
    }

    /// Changes the manifest, as an engine's own tool might.
    fn edit(&self, edit: impl FnOnce(&mut Value)) {
        let mut manifest = serde_json::from_str(&fs::read_to_string(self.manifest()).expect("built")).expect("JSON");
        edit(&mut manifest);
        fs::write(self.manifest(), manifest.to_string()).expect("a writable folder");
    }

    /// Red, green, blue of every pixel that the engine draws; `None` where nothing can draw.
    fn draw(&self) -> Option<Vec<[u8; 3]>> {
        let picture = self.0.path("picture.png");
        match engine::run(&self.manifest(), &picture) {
            Ok(()) => Some(Picture::read(&picture).expect("the engine wrote it").pixels),
            Err(reason) if reason.starts_with("no graphics adapter") => {
                Skip(reason).report();
                None
            }
            Err(reason) => panic!("{reason}"),
        }
    }
}

fn mean(pixels: &[[u8; 3]], channel: usize) -> f64 {
    pixels.iter().map(|pixel| f64::from(pixel[channel])).sum::<f64>() / pixels.len() as f64
}

#[test]
fn tint_accepts_the_engines_shader() {
    let built = Built::new();
    let (_, shader) = engine::load(&built.manifest()).unwrap();
    let mut tint = match Tint::start() {
        Ok(tint) => tint,
        Err(skip) => return skip.report(),
    };
    let reports = tint.validate(&[Module::with_pipelines("embed", shader)]);
    assert_eq!(reports.iter().map(Report::errors).collect::<String>(), "");
}

#[test]
fn the_engine_draws_land_under_a_sky() {
    let Some(pixels) = Built::new().draw() else { return };
    let sky = pixels[0];
    let land: Vec<[u8; 3]> = pixels.iter().copied().filter(|pixel| *pixel != sky).collect();
    let share = land.len() as f64 / pixels.len() as f64;
    assert!((0.4..0.95).contains(&share), "{share} of the picture is land");
    // Sand: red over green over blue, unlike the sky.
    assert!(mean(&land, 0) > mean(&land, 1) && mean(&land, 1) > mean(&land, 2), "{:?}", land[land.len() / 2]);
    let shades: std::collections::BTreeSet<[u8; 3]> = land.into_iter().collect();
    assert!(shades.len() > 1000, "{} shades", shades.len());
}

#[test]
fn a_parameter_changes_the_picture() {
    let built = Built::new();
    let Some(before) = built.draw() else { return };
    built.edit(|manifest| {
        let members = manifest["parameters"]["members"].as_array_mut().unwrap();
        let tint = members.iter_mut().find(|member| member["name"] == "sand_tint").unwrap();
        tint["default"] = json!([0.2, 0.8, 0.6]);
    });
    let after = built.draw().unwrap();
    assert!(mean(&after, 0) < mean(&before, 0) - 20.0, "red from {} to {}", mean(&before, 0), mean(&after, 0));
}

#[test]
fn an_unknown_version_is_refused() {
    let built = Built::new();
    built.edit(|manifest| manifest["version"] = json!(2));
    assert!(engine::load(&built.manifest()).unwrap_err().contains("version 2"));
}
