//! Emitted WGSL and manifest of a small terrain, reviewed like code.

use std::fs;

use crate::accepted::{HOW, accepted, blessing};
use crate::scratch::Scratch;

#[test]
fn the_dunes_core_and_manifest() {
    let scratch = Scratch::of("examples/build_script");
    scratch.terrane(&["build", "graphs/terrains/dunes.ron", "-o", "out", "--no-textures"]);
    let mut manifest: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(scratch.path("out/dunes.json")).unwrap()).unwrap();
    // The host shader is the renderer's, and has tests of its own: its hash would change with every work on light.
    manifest["permutations"][0]["host"]["sha256"] = "…".into();
    let manifest = serde_json::to_string_pretty(&manifest).unwrap() + "\n";
    let core = fs::read_to_string(scratch.path("out/dunes.core.wgsl")).unwrap();
    let findings: Vec<String> = [compare("dunes.core.wgsl", &core), compare("dunes.json", &manifest)]
        .into_iter()
        .filter_map(Result::err)
        .collect();
    assert!(findings.is_empty(), "{}", findings.join("\n"));
}

fn compare(name: &str, found: &str) -> Result<(), String> {
    let path = accepted("snapshots").join(name);
    if blessing() {
        fs::write(&path, found).expect("the snapshot can be written");
        return Ok(());
    }
    let known = fs::read_to_string(&path).unwrap_or_default();
    match known.lines().zip(found.lines()).position(|(known, found)| known != found) {
        None if known == found => Ok(()),
        None => Err(format!("{name}: {} lines instead of {}; {HOW}", found.lines().count(), known.lines().count())),
        Some(line) => {
            let show = |text: &str| text.lines().skip(line).take(6).collect::<Vec<_>>().join("\n");
            Err(format!("{name}:{}: was\n{}\nis\n{}\n{HOW}", line + 1, show(&known), show(found)))
        }
    }
}
