//! Random projects that are right: every node, instance and surface is one that an author could write.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use terrane_codegen::graph::model::FrameField;
use terrane_codegen::library::Library;
use terrane_codegen::value::Type;

use super::genes::Genes;
use super::scene::{Scene, Wire};

/// The files of a project by path.
pub(crate) type Project = BTreeMap<String, String>;

/// The project that the genes describe.
pub(crate) fn project(library: &Library, genes: &[u16]) -> Project {
    let mut genes = Genes::new(genes);
    let mut files = Project::new();
    files.insert("terrane.ron".into(), ROOT.into());
    for (index, name) in INSTANCES.iter().enumerate() {
        files.insert(format!("graphs/instances/{name}.ron"), instance(library, &mut genes, &INSTANCES[..index]));
    }
    files.insert("graphs/masks/random_mask.ron".into(), mask(library, &mut genes));
    let surfaces = 1 + genes.below(6);
    for index in 0..surfaces {
        files.insert(format!("graphs/surfaces/s{index}.ron"), surface(library, &mut genes, index));
    }
    files.insert("graphs/terrains/random.ron".into(), terrain(&mut genes, surfaces));
    files
}

/// Every instance calls those before it.
const INSTANCES: [&str; 3] = ["random_grain", "random_crumb", "random_edge"];

const ROOT: &str = r#"Project(
    version: 1,
    made: {
        "textures/random_ground.png": mountains(size: 64, seed: 1),
        "textures/rock": cracked_rock(size: 64, seed: 1),
        "textures/sand": ripples(size: 32, seed: 2),
    },
)
"#;

const TEXTURES: &str = r#"    textures: {
        "rock": (file: "textures/rock_albedo.png", color: srgb),
        "rock_height": (file: "textures/rock_height.png", color: linear, channel: r),
        "sand": (file: "textures/sand_height.png", color: linear, channel: r, wrap: mirror),
    },
"#;

fn frame() -> Vec<Wire> {
    FrameField::ALL.iter().map(|(field, name, unit)| Wire::new(*name, field.ty(), *unit)).collect()
}

fn instance(library: &Library, genes: &mut Genes<'_>, instances: &'static [&'static str]) -> String {
    let mut wires = frame();
    wires.extend(["base", "detail"].map(|name| Wire::new(name, Type::F32, None)));
    let mut scene = Scene::new(library, genes, wires).calling(instances);
    scene.nodes(8);
    // An output of an instance has the unit of what it is wired to; one that nothing has keeps it plain.
    let edge = scene.argument_of(&Type::F32, Some("none"), (0.0, 1.0));
    format!(
        "Instance(\n    version: 1,\n    doc: \"Random.\",\n    inputs: {{ \"base\": (range: (0.0, 1.0)), \"detail\": (default: 0.5) }},\n    nodes: {{\n{}    }},\n    outputs: (edge: {edge}),\n)\n",
        scene.text
    )
}

fn mask(library: &Library, genes: &mut Genes<'_>) -> String {
    let mut scene = Scene::new(library, genes, frame()).calling(&INSTANCES);
    scene.nodes(8);
    let output = scene.argument_of(&Type::F32, None, (0.0, 1.0));
    format!(
        "Mask(\n    version: 1,\n    doc: \"Random.\",\n    nodes: {{\n{}    }},\n    output: {output},\n)\n",
        scene.text
    )
}

/// Outputs of a surface beside its albedo.
const OUTPUTS: [(&str, Type); 7] = [
    ("mask", Type::F32),
    ("roughness", Type::F32),
    ("metallic", Type::F32),
    ("occlusion", Type::F32),
    ("height", Type::F32),
    ("normal", Type::Vec3),
    ("emissive", Type::Vec3),
];

fn surface(library: &Library, genes: &mut Genes<'_>, index: usize) -> String {
    let mut wires = frame();
    wires.push(Wire::new("tint", Type::Vec3, None));
    wires.push(Wire::new("amount", Type::F32, None));
    let scene = Scene::new(library, genes, wires).calling(&INSTANCES);
    let mut scene = scene.reading(&["rock", "rock_height", "sand"]);
    scene.nodes(20);
    let mut outputs = format!("albedo: {}", scene.output(&Type::Vec3));
    for (name, ty) in &OUTPUTS {
        if scene.genes.below(3) > 0 {
            let _ = write!(outputs, ", {name}: {}", scene.output(ty));
        }
    }
    format!(
        "Surface(\n    version: 1,\n    doc: \"Random {index}.\",\n    parameters: {{ \"tint\": (kind: color, default: (0.5, 0.4, 0.3)), \"amount\": (range: (0.0, 1.0), default: 0.25) }},\n{TEXTURES}    nodes: {{\n{}    }},\n    outputs: ({outputs}),\n)\n",
        scene.text
    )
}

fn terrain(genes: &mut Genes<'_>, surfaces: usize) -> String {
    let blend = ["over", "height_max", "height_soft(band: 0.2)"][genes.below(3)];
    let mut layers = String::new();
    for index in 0..surfaces {
        let mask =
            ["", ", mask: graph(\"graphs/masks/random_mask.ron\")", ", mask: painted(\"textures/sand_height.png\")"];
        let parameters = ["", ", parameters: { \"amount\": 0.75 }"];
        let (mask, parameters) = (mask[genes.below(3)], parameters[genes.below(2)]);
        let _ = writeln!(layers, "        (surface: \"graphs/surfaces/s{index}.ron\"{parameters}{mask}),");
    }
    format!(
        "Terrain(\n    version: 1,\n    height: (file: \"textures/random_ground.png\", size: (512.0, 512.0), range: (0.0, 90.0)),\n    patch: 64.0,\n    layers: [\n{layers}    ],\n    blend: {blend},\n)\n"
    )
}
