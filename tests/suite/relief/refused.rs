//! What authors are told of relief that cannot be traced, and names that must not clash.

use std::fs;
use std::process::Output;

use crate::scratch::Scratch;

const TERRAIN: &str = r#"Terrain(
    version: 1,
    height: (file: "textures/yard_height.png", size: (48.0, 48.0), range: (0.0, 1.6)),
    layers: [(surface: "graphs/surfaces/NAME.ron")],
    relief: (method: walk, weights: entry, fade: (25.0, 40.0)),
    shadow: (terrain: off, relief: hard),
)
"#;

/// Bricks over coordinates of one's own.
fn surface(coordinates: &str) -> String {
    let outputs = r#"albedo: 0.5, normal: tilt, relief: (height: bricks, uv: uv, depth: 0.05)"#;
    let nodes = r#""tilt": normal_map(texel: (0.5, 0.5, 1.0, 1.0)),"#;
    let textures = r#""bricks": (file: "textures/bricks_height.png", color: linear, channel: r)"#;
    format!(
        "Surface(\n    version: 1,\n    textures: {{ {textures} }},\n    nodes: {{\n{coordinates}        {nodes}\n    }},\n    \
         outputs: ({outputs}),\n)\n"
    )
}

/// Builds a terrain with one surface of this name.
fn build(name: &str, coordinates: &str) -> (Scratch, Output) {
    build_in_light(name, coordinates, "hard")
}

/// The same with this shadow of the relief.
fn build_in_light(name: &str, coordinates: &str, shadow: &str) -> (Scratch, Output) {
    let scratch = Scratch::of(".");
    let write = |folder: &str, text: &str| {
        fs::write(scratch.path(&format!("graphs/{folder}/{name}.ron")), text).expect("a writable folder");
    };
    write("surfaces", &surface(coordinates));
    write("terrains", &TERRAIN.replace("NAME", name).replace("hard", shadow));
    let output = scratch.run(&["build", &format!("graphs/terrains/{name}.ron"), "-o", "out", "--no-textures"]);
    (scratch, output)
}

const STRAIGHT: &str = "        \"uv\": planar(position: position, tile: 2.0),\n";

#[test]
fn a_surface_may_have_a_name_that_the_generator_uses_itself() {
    for name in ["bottom", "deepest", "fade", "ray", "loop"] {
        let (scratch, output) = build(name, STRAIGHT);
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        let core = fs::read_to_string(scratch.path(&format!("out/{name}.core.wgsl"))).expect("it was written");
        assert!(core.contains(&format!("{name}_relief: ")), "{core}");
    }
}

#[test]
fn a_soft_shadow_has_as_many_planes_as_are_asked_for() {
    for (shadow, planes) in [("cone", 1), ("cone(planes: 7)", 7), ("cone(planes: 16)", 16)] {
        let (scratch, output) = build_in_light("lit", STRAIGHT, shadow);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let core = fs::read_to_string(scratch.path("out/lit.core.wgsl")).expect("it was written");
        assert!(core.contains(&format!("displaced_light_disc(relief.lit_relief, ray, radius, {planes}u,")), "{core}");
    }
    let refused = [
        ("cone(planes: 0)", "range is 1..16"),
        ("cone(planes: 17)", "range is 1..16"),
        ("cone(plane: 7)", "planes"),
        ("hard(planes: 7)", "`relief` has no"),
        ("cone(7)", "without a name"),
        ("soft", "`off`, `hard`"),
    ];
    for (shadow, why) in refused {
        let (_, output) = build_in_light("lit", STRAIGHT, shadow);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && said.contains("lit.ron:6:") && said.contains(why), "{shadow}: {said}");
    }
}

#[test]
fn coordinates_that_bend_rays_are_refused_where_they_are_made() {
    let bent = "        \"swirl\": value_noise(position: position, wavelength: 3.0),\n        \
                \"uv\": rotated(position: position, tile: 2.0, angle: swirl),\n";
    let (scratch, output) = build("bent", bent);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && !scratch.path("out/bent.wgsl").exists(), "{said}");
    for part in ["error[TG202 relief-coordinates]", "graphs/surfaces/bent.ron:9:", "swirl` bends them", "`planar`"] {
        assert!(said.contains(part), "{part}: {said}");
    }
}

#[test]
fn a_surface_is_not_asked_for_what_it_does_not_have() {
    let scratch = Scratch::of(".");
    let asked = [
        (["graphs/surfaces/scree.ron", "--relief", "walk"].as_slice(), "scree.ron has no relief"),
        (&["graphs/surfaces/brickwork.ron", "--search"], "--search is for scenes"),
    ];
    for (arguments, why) in asked {
        let output = scratch.run(&[&["render", "-o", "picture.png"], arguments].concat());
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(why) && !scratch.path("picture.png").exists(), "{said}");
    }
}
