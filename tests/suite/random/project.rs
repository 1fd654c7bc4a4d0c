//! Random projects that are right: every node, instance and surface is one that an author could write.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use terrane_codegen::graph::model::FrameField;
use terrane_codegen::library::{Library, Overload, Port};
use terrane_codegen::value::Type;

use super::genes::Genes;

/// The files of a project by path.
pub(crate) type Project = BTreeMap<String, String>;

/// Something that an input may be wired to.
#[derive(Clone)]
struct Wire {
    text: String,
    ty: Type,
    unit: Option<String>,
}

impl Wire {
    fn new(text: impl Into<String>, ty: Type, unit: Option<&str>) -> Self {
        Self { text: text.into(), ty, unit: unit.map(str::to_owned) }
    }
}

/// The project that the genes describe.
pub(crate) fn project(library: &Library, genes: &[u16]) -> Project {
    let mut genes = Genes::new(genes);
    let mut files = Project::new();
    files.insert("terrane.ron".into(), ROOT.into());
    files.insert("graphs/instances/random_edge.ron".into(), instance(library, &mut genes));
    files.insert("graphs/masks/random_mask.ron".into(), mask(library, &mut genes));
    let surfaces = 1 + genes.below(4);
    for index in 0..surfaces {
        files.insert(format!("graphs/surfaces/s{index}.ron"), surface(library, &mut genes, index));
    }
    files.insert("graphs/terrains/random.ron".into(), terrain(&mut genes, surfaces));
    files
}

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

/// Nodes so far, and what can be read.
struct Scene<'a, 'g> {
    library: &'a Library,
    genes: &'a mut Genes<'g>,
    wires: Vec<Wire>,
    textures: &'static [&'static str],
    instance: bool,
    text: String,
}

impl Scene<'_, '_> {
    fn nodes(&mut self, most: usize) {
        let count = self.genes.below(most);
        for index in 0..count {
            if self.genes.is_spent() {
                break;
            }
            self.node(&format!("n{index}"));
        }
    }

    fn node(&mut self, name: &str) {
        if self.instance && self.genes.below(5) == 4 {
            let base = self.argument_of(&Type::F32, None, (0.0, 1.0));
            let detail = self.argument_of(&Type::F32, None, (0.0, 1.0));
            let _ = writeln!(self.text, "        \"{name}\": random_edge(base: {base}, detail: {detail}),");
            self.wires.push(Wire::new(format!("\"{name}.edge\""), Type::F32, None));
            return;
        }
        let kinds: Vec<_> = self.library.kinds.values().collect();
        let Some(kind) = self.genes.pick(&kinds) else { return };
        let Some(overload) = self.genes.pick(&kind.overloads) else { return };
        let Some(arguments) = self.arguments(overload) else { return };
        let _ = writeln!(self.text, "        \"{name}\": {}({}),", kind.name, arguments.join(", "));
        // A texture with a channel gives one number, whatever the function returns.
        let is_texture = overload.inputs.iter().any(|port| port.ty == Type::Texture);
        let has_channel = is_texture && !arguments.iter().any(|argument| argument.ends_with(": rock"));
        let ty = if has_channel && overload.output.ty == Type::Vec4 { Type::F32 } else { overload.output.ty.clone() };
        self.result(name, ty, overload);
    }

    fn result(&mut self, name: &str, ty: Type, overload: &Overload) {
        let unit = overload.output.unit.as_deref();
        for (letter, _) in "xyzw".chars().zip(0..ty.components().filter(|count| *count > 1).unwrap_or(0)) {
            self.wires.push(Wire::new(format!("\"{name}.{letter}\""), Type::F32, unit));
        }
        for member in &overload.members {
            self.wires.push(Wire::new(
                format!("\"{name}.{}\"", member.name),
                member.ty.clone(),
                member.unit.as_deref(),
            ));
        }
        self.wires.push(Wire::new(name, ty, unit));
    }

    fn arguments(&mut self, overload: &Overload) -> Option<Vec<String>> {
        overload.inputs.iter().map(|port| Some(format!("{}: {}", port.name, self.argument(port)?))).collect()
    }

    fn argument(&mut self, port: &Port) -> Option<String> {
        match &port.ty {
            Type::Texture => self.genes.pick(self.textures).map(|name| (*name).to_owned()),
            Type::Struct(_) => self.wire(&port.ty, None),
            Type::I32 | Type::U32 => {
                let (low, high) = port.range.unwrap_or((0.0, 8.0));
                Some(format!("{}", self.genes.between(low, high.min(8.0).max(low)).round() as i64))
            }
            ty if port.constant => Some(self.literal(ty, port.range.unwrap_or((-2.0, 2.0)))),
            ty => Some(self.argument_of(ty, port.unit.as_deref(), port.range.unwrap_or((-2.0, 2.0)))),
        }
    }

    fn argument_of(&mut self, ty: &Type, unit: Option<&str>, range: (f32, f32)) -> String {
        let wired = if self.genes.below(4) == 0 { None } else { self.wire(ty, unit) };
        wired.unwrap_or_else(|| self.literal(ty, range))
    }

    fn wire(&mut self, ty: &Type, unit: Option<&str>) -> Option<String> {
        let fits =
            |wire: &&Wire| wire.ty == *ty && (unit.is_none() || wire.unit.is_none() || wire.unit.as_deref() == unit);
        let found: Vec<String> = self.wires.iter().filter(fits).map(|wire| wire.text.clone()).collect();
        self.genes.pick(&found).cloned()
    }

    fn literal(&mut self, ty: &Type, (low, high): (f32, f32)) -> String {
        let count = ty.components().unwrap_or(1);
        let values: Vec<String> = (0..count).map(|_| format!("{:?}", self.genes.between(low, high))).collect();
        if count == 1 { values.join("") } else { format!("({})", values.join(", ")) }
    }
}

fn frame() -> Vec<Wire> {
    FrameField::ALL.iter().map(|(field, name, unit)| Wire::new(*name, field.ty(), *unit)).collect()
}

fn instance(library: &Library, genes: &mut Genes<'_>) -> String {
    let mut wires = frame();
    wires.extend(["base", "detail"].map(|name| Wire::new(name, Type::F32, None)));
    let mut scene = Scene { library, genes, wires, textures: &[], instance: false, text: String::new() };
    scene.nodes(6);
    // An output of an instance has the unit of what it is wired to; one that nothing has keeps it plain.
    let edge = scene.argument_of(&Type::F32, Some("none"), (0.0, 1.0));
    format!(
        "Instance(\n    version: 1,\n    doc: \"Random.\",\n    inputs: {{ \"base\": (range: (0.0, 1.0)), \"detail\": (default: 0.5) }},\n    nodes: {{\n{}    }},\n    outputs: (edge: {edge}),\n)\n",
        scene.text
    )
}

fn mask(library: &Library, genes: &mut Genes<'_>) -> String {
    let mut scene = Scene { library, genes, wires: frame(), textures: &[], instance: true, text: String::new() };
    scene.nodes(5);
    let output = scene.argument_of(&Type::F32, None, (0.0, 1.0));
    format!(
        "Mask(\n    version: 1,\n    doc: \"Random.\",\n    nodes: {{\n{}    }},\n    output: {output},\n)\n",
        scene.text
    )
}

fn surface(library: &Library, genes: &mut Genes<'_>, index: usize) -> String {
    let mut wires = frame();
    wires.push(Wire::new("tint", Type::Vec3, None));
    wires.push(Wire::new("amount", Type::F32, None));
    let textures = &["rock", "rock_height", "sand"];
    let mut scene = Scene { library, genes, wires, textures, instance: true, text: String::new() };
    scene.nodes(14);
    let number = (0.0, 1.0);
    let mut outputs = format!("albedo: {}", scene.argument_of(&Type::Vec3, None, number));
    for (name, ty) in [("mask", Type::F32), ("roughness", Type::F32), ("height", Type::F32), ("normal", Type::Vec3)] {
        if scene.genes.below(3) > 0 {
            let _ = write!(outputs, ", {name}: {}", scene.argument_of(&ty, None, number));
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
