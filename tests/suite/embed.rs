//! The engine of `examples/embed` draws what `terrane build` writes, and knows nothing else.

#[path = "../../examples/embed/main.rs"]
#[expect(dead_code, reason = "an example has a `main` of its own")]
mod engine;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::skip::Skip;
use crate::tint::{Module, Report, Tint};

/// What `terrane build` makes of the project of `examples/build_script`.
struct Built {
    folder: TempDir,
}

impl Built {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let project = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/build_script");
        copy(&project.join("terrane.ron"), &folder.path().join("terrane.ron"));
        copy(&project.join("graphs"), &folder.path().join("graphs"));
        let mut terrane = Command::new(env!("CARGO_BIN_EXE_terrane"));
        let terrane = terrane.args(["build", "graphs/terrains/dunes.ron", "-o", "out"]).current_dir(folder.path());
        let output = terrane.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        Self { folder }
    }

    fn manifest(&self) -> PathBuf {
        self.folder.path().join("out/dunes.json")
    }

    /// Changes the manifest, as an engine's own tool might.
    fn edit(&self, edit: impl FnOnce(&mut Value)) {
        let mut manifest = serde_json::from_str(&fs::read_to_string(self.manifest()).unwrap()).unwrap();
        edit(&mut manifest);
        fs::write(self.manifest(), manifest.to_string()).unwrap();
    }

    /// Red, green, blue of every pixel that the engine draws; `None` where nothing can draw.
    fn draw(&self) -> Option<Vec<[u8; 3]>> {
        let picture = self.folder.path().join("picture.png");
        match engine::run(&self.manifest(), &picture) {
            Ok(()) => Some(pixels(&picture)),
            Err(reason) if reason.starts_with("no graphics adapter") => {
                Skip(reason).report();
                None
            }
            Err(reason) => panic!("{reason}"),
        }
    }
}

fn copy(from: &Path, to: &Path) {
    if from.is_file() {
        fs::copy(from, to).unwrap();
        return;
    }
    fs::create_dir(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let name = entry.unwrap().file_name();
        copy(&from.join(&name), &to.join(&name));
    }
}

fn pixels(path: &Path) -> Vec<[u8; 3]> {
    let file = std::io::BufReader::new(fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    bytes.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
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
