//! Emitted WGSL and manifests of a small terrain and of a large one, reviewed like code.

use std::fs;
use std::path::Path;

use crate::accepted::{HOW, accepted, blessing};
use crate::scratch::Scratch;

#[test]
fn the_dunes_core_and_manifest() {
    core_and_manifest("examples/build_script", "dunes");
}

#[test]
fn the_alpine_core_and_manifest() {
    core_and_manifest(".", "alpine");
}

#[track_caller]
fn core_and_manifest(project: &str, terrain: &str) {
    let scratch = Scratch::of(project);
    scratch.terrane(&["build", &format!("graphs/terrains/{terrain}.ron"), "-o", "out", "--no-textures"]);
    let path = |ending: &str| scratch.path(&format!("out/{terrain}{ending}"));
    let read = |ending: &str| fs::read_to_string(path(ending)).expect("terrane wrote it");
    let mut manifest: serde_json::Value = serde_json::from_str(&read(".json")).expect("a manifest is JSON");
    // The host shader is the renderer's, and has tests of its own: its hash would change with every work on light.
    manifest["permutations"][0]["host"]["sha256"] = "…".into();
    let manifest = serde_json::to_string_pretty(&manifest).expect("JSON") + "\n";
    let texts = [(".core.wgsl", read(".core.wgsl")), (".json", manifest)];
    let found =
        texts.iter().map(|(ending, text)| compare(&accepted("snapshots").join(format!("{terrain}{ending}")), text));
    let findings: Vec<String> = found.filter_map(Result::err).collect();
    assert!(findings.is_empty(), "{}", findings.join("\n"));
}

/// Compares with an accepted file, or accepts.
pub(super) fn compare(path: &Path, found: &str) -> Result<(), String> {
    let name = path.file_name().expect("a file").to_string_lossy();
    if blessing() {
        fs::write(path, found).expect("the snapshot can be written");
        return Ok(());
    }
    let known = fs::read_to_string(path).unwrap_or_default();
    match known.lines().zip(found.lines()).position(|(known, found)| known != found) {
        None if known == found => Ok(()),
        None => Err(format!("{name}: {} lines instead of {}; {HOW}", found.lines().count(), known.lines().count())),
        Some(line) => {
            let show = |text: &str| text.lines().skip(line).take(6).collect::<Vec<_>>().join("\n");
            Err(format!("{name}:{}: was\n{}\nis\n{}\n{HOW}", line + 1, show(&known), show(found)))
        }
    }
}
