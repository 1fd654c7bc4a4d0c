//! A valid project resolves to what it says.

mod support;

use support::{base, beside_relief, project};
use terrane_codegen::diagnostic::render;
use terrane_codegen::graph::model::*;
use terrane_codegen::graph::{ImageHeader, Memory, Project};
use terrane_codegen::value::{Literal, Type};

fn open(files: Memory) -> Project {
    project(files).unwrap_or_else(|error| panic!("{}", render(&error.diagnostics, &error.sources, false)))
}

/// A surface that must have no finding at all.
fn surface(text: &str) -> Graph {
    let mut project = open(base().with("graphs/surfaces/tested.ron", text));
    match project.surface("graphs/surfaces/tested.ron") {
        Ok((graphs, id, warnings)) => {
            assert!(warnings.is_empty(), "{}", render(&warnings, &project.sources, false));
            graphs.graphs[id.0].clone()
        }
        Err(findings) => panic!("{}", render(&findings, &project.sources, false)),
    }
}

fn node<'a>(graph: &'a Graph, name: &str) -> &'a Node {
    graph.nodes.iter().find(|node| node.name == name).expect("the node is in the file")
}

#[test]
fn the_valid_project_has_no_findings() {
    let mut project = open(base());
    let findings = beside_relief(project.check_all());
    assert!(findings.is_empty(), "{}", render(&findings, &project.sources, false));
    assert_eq!(project.graph_files().len(), 6);
}

#[test]
fn nodes_come_in_dependency_order_ties_by_name() {
    let mut project = open(base());
    let (graphs, id, _) = project.surface("graphs/surfaces/granite.ron").expect("it is valid");
    let names: Vec<&str> = graphs.graphs[id.0].nodes.iter().map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["ledge", "uv", "crack", "edge", "stone", "color"]);
    let names: Vec<&str> = graphs.graphs.iter().map(|graph| graph.name.as_str()).collect();
    assert_eq!(names, ["broken_edge", "granite"], "instances come before their users");
}

#[test]
fn a_surface_is_resolved_completely() {
    let mut project = open(base());
    let (graphs, id, _) = project.surface("graphs/surfaces/granite.ron").expect("it is valid");
    let granite = &graphs.graphs[id.0];
    assert_eq!((granite.role, granite.path.as_str()), (Role::Surface, "graphs/surfaces/granite.ron"));

    let crack = node(granite, "crack");
    assert_eq!(
        (crack.channel, &crack.ty),
        (Some(0), &Some(Type::F32)),
        "a texture's channel makes a number of the texel"
    );
    assert_eq!(node(granite, "stone").ty, Some(Type::Vec4));

    let color = node(granite, "color");
    assert_eq!(color.callee, Callee::Function { kind: "mul".into(), overload: 1 });
    assert_eq!(color.inputs[0].access, [Access::Swizzle("xyz".into())], "rgb is xyz");
    assert_eq!(color.inputs[1].value, InputValue::Parameter(2), "parameters are sorted by name");

    let edge = node(granite, "edge");
    assert_eq!(edge.callee, Callee::Instance(GraphId(0)));
    assert_eq!(edge.inputs.len(), 3, "one for each input of the instance, in their order");
    assert_eq!(edge.inputs[2].value, InputValue::Literal(Literal::f32(2.0)));
    let mask = &granite.outputs["mask"].input;
    assert_eq!(mask.value, InputValue::NodeOutput { node: 3, output: "mask".into() });

    let relief = granite.relief.as_ref().expect("it has one");
    assert_eq!((relief.texture, relief.depth), (0, 0.35));
    assert_eq!(relief.uv.ty, Type::Struct("Coord".into()));
    assert_eq!(
        (granite.textures[0].name.as_str(), granite.textures[0].size, granite.textures[0].depth),
        ("cracks", (128, 128), 16)
    );
}

#[test]
fn exceptions_from_lint_rules_are_kept() {
    let mut project = open(base());
    let (graphs, id, _) = project.surface("graphs/surfaces/granite.ron").expect("it is valid");
    let allow = &graphs.graphs[id.0].allow;
    assert_eq!(allow.keys().collect::<Vec<_>>(), ["edge"]);
    let edge = &allow["edge"];
    assert_eq!((edge.rule.as_str(), edge.reason.as_str()), ("duplicated-subgraph", "kept apart for tweaking"));
    assert_eq!(project.sources.slice(edge.span), "edge");
}

#[test]
fn spans_mean_the_words_in_the_file() {
    let mut project = open(base());
    let (graphs, id, _) = project.surface("graphs/surfaces/granite.ron").expect("it is valid");
    let granite = &graphs.graphs[id.0];
    let slice = |span| project.sources.slice(span);
    let color = node(granite, "color");
    assert_eq!(slice(color.span), r#""color":  mul(a: "stone.rgb", b: tint)"#);
    assert_eq!(slice(color.name_span), "color");
    assert_eq!(slice(color.inputs[0].span), "\"stone.rgb\"");
    assert_eq!(slice(color.inputs[1].span), "tint");
    assert_eq!(slice(granite.outputs["roughness"].input.span), "0.85");
    assert_eq!(
        slice(granite.relief.as_ref().expect("it has one").span),
        "relief: (height: cracks, uv: uv, depth: 0.35)"
    );
}

#[test]
fn numbers_spread_over_vectors() {
    let graph = surface(
        r#"Surface(version: 1,
            parameters: { "level": (default: 0.5) },
            nodes: { "a": mul(a: normal, b: 2.0), "b": mul(a: normal, b: slope), "c": mul(a: slope, b: 2) },
            outputs: ( albedo: level, emissive: a, normal: b, mask: c ))"#,
    );
    let literal = &node(&graph, "a").inputs[1];
    assert_eq!(literal.value, InputValue::Literal(Literal::floats(&[2.0; 3])));
    let wire = &node(&graph, "b").inputs[1];
    assert_eq!((&wire.value, wire.widen, &wire.ty), (&InputValue::Frame(FrameField::Slope), Some(3), &Type::Vec3));
    assert_eq!(node(&graph, "c").callee, Callee::Function { kind: "mul".into(), overload: 0 }, "exact types win");
    assert_eq!(graph.outputs["albedo"].input.widen, Some(3));
}

#[test]
fn exact_types_win_whatever_the_order_of_overloads() {
    let graph = surface(
        r#"Surface(version: 1,
            nodes: { "a": tone(x: slope), "b": tone(x: 0.5), "c": tone(x: normal) },
            outputs: ( mask: a, roughness: b, albedo: c ))"#,
    );
    let overload = |name| match node(&graph, name).callee {
        Callee::Function { overload, .. } => overload,
        Callee::Instance(_) => panic!("a kind of the library"),
    };
    assert_eq!((overload("a"), overload("b"), overload("c")), (1, 1, 0));
}

#[test]
fn literals_take_the_type_of_their_port() {
    let graph = surface(
        r#"Surface(version: 1,
            nodes: { "a": fbm(position: position, wavelength: 8, octaves: 3.0, seed: 4294967295) },
            outputs: ( albedo: (0.25, 1, -0.0), mask: a ))"#,
    );
    let inputs = &node(&graph, "a").inputs;
    let literal = |literal| InputValue::Literal(literal);
    assert_eq!(inputs[1].value, literal(Literal::f32(8.0)));
    assert_eq!(inputs[2].value, literal(Literal::I32(3)));
    assert_eq!(inputs[3].value, literal(Literal::U32(u32::MAX)));
    assert_eq!(graph.outputs["albedo"].input.value, literal(Literal::floats(&[0.25, 1.0, 0.0])), "zero has no sign");
}

#[test]
fn what_is_not_connected_gets_its_default() {
    let graph = surface(
        r#"Surface(version: 1, nodes: { "a": fbm(position: position, wavelength: 8.0) }, outputs: ( albedo: a ))"#,
    );
    assert_eq!(node(&graph, "a").inputs[2].value, InputValue::Default(Literal::I32(4)));
}

#[test]
fn members_and_swizzles_follow_each_other() {
    let graph = surface(
        r#"Surface(version: 1,
            nodes: { "c": cells(position: position, wavelength: 8.0), "t": turn(direction: "c.center.yx", angle: "terrain_uv.uv.g") },
            outputs: ( albedo: "c.f2", mask: "t.x" ))"#,
    );
    let access = |input: &Input| input.access.clone();
    let turn = node(&graph, "t");
    assert_eq!(access(&turn.inputs[0]), [Access::Member("center".into()), Access::Swizzle("yx".into())]);
    assert_eq!(access(&turn.inputs[1]), [Access::Member("uv".into()), Access::Swizzle("y".into())]);
    assert_eq!(access(&graph.outputs["albedo"].input), [Access::Member("f2".into())]);
}

#[test]
fn a_set_becomes_textures_by_role() {
    let graph = surface(
        r#"Surface(version: 1,
            textures: { "rock": (set: "textures/granite", wrap: mirror, filter: nearest, anisotropy: 4) },
            nodes: { "a": texture(of: rock_albedo, uv: terrain_uv), "h": texture(of: rock_height, uv: terrain_uv) },
            outputs: ( albedo: "a.rgb", height: h ))"#,
    );
    let [albedo, height] = &graph.textures[..] else { panic!("{:?}", graph.textures) };
    assert_eq!((albedo.name.as_str(), albedo.color, albedo.channel), ("rock_albedo", ColorSpace::Srgb, None));
    assert_eq!((height.name.as_str(), height.color, height.channel), ("rock_height", ColorSpace::Linear, Some(0)));
    assert_eq!((height.file.as_str(), height.depth), ("textures/granite_height.png", 16));
    assert_eq!((albedo.wrap, albedo.filter, albedo.anisotropy), (Wrap::Mirror, Filter::Nearest, 4));
}

#[test]
fn instances_take_textures_and_places() {
    let instance = r#"Instance(version: 1,
        inputs: { "where": (kind: place), "tile": (unit: "m", default: 4.0), "picture": (kind: texture) },
        nodes: { "uv": planar(position: where, tile: tile), "texel": texture(of: picture, uv: uv) },
        outputs: ( color: "texel.rgb", alpha: "texel.a" ))"#;
    let user = r#"Surface(version: 1,
        textures: { "stone": (file: "textures/granite_albedo.png", color: srgb) },
        nodes: { "p": picked(where: position, picture: stone) },
        outputs: ( albedo: "p.color", mask: "p.alpha" ))"#;
    let files = base().with("graphs/instances/picked.ron", instance).with("graphs/surfaces/tested.ron", user);
    let mut project = open(files);
    let (graphs, id, _) = project
        .surface("graphs/surfaces/tested.ron")
        .unwrap_or_else(|findings| panic!("{}", render(&findings, &project.sources, false)));
    let names: Vec<&str> = graphs.graphs[0].inputs.iter().map(|input| input.name.as_str()).collect();
    assert_eq!(names, ["picture", "tile", "where"]);
    let graph = &graphs.graphs[id.0];
    assert_eq!(graph.nodes[0].inputs[0].value, InputValue::Texture(0));
    assert_eq!(graph.nodes[0].ty, None, "which of two outputs is a matter of the wire");
    assert_eq!(graph.outputs["albedo"].input.value, InputValue::NodeOutput { node: 0, output: "color".into() });
    let texel = node(&graphs.graphs[0], "texel");
    assert_eq!(texel.inputs[0].value, InputValue::InstanceInput(0));
}

#[test]
fn a_terrain_and_its_scene_are_resolved() {
    let mut project = open(base());
    let (graphs, scene, _) = project.scene("graphs/scenes/alpine.ron").expect("it is valid");
    let terrain = &scene.terrain;
    assert_eq!((scene.image, scene.sun.azimuth, scene.camera.fov, scene.turbidity), ((1280, 720), 130.0, 55.0, 3.0));
    assert_eq!(
        (terrain.height.texels, terrain.height.size, terrain.height.range),
        ((256, 256), (4096.0, 4096.0), (0.0, 1200.0))
    );
    assert_eq!((terrain.patch, terrain.blend, terrain.occlusion), (64.0, Blend::HeightSoft { band: 0.15 }, 8));
    let relief = terrain.relief.expect("it has one");
    assert_eq!((terrain.shadow, relief.shadow), (Shadow::Horizon, ReliefShadow::Cone { planes: 1 }));

    assert_eq!(
        (relief.method, relief.weights, relief.fade),
        (ReliefMethod::Auto { max_error: 0.5 }, ReliefWeights::Entry, (40.0, 60.0))
    );
    let names: Vec<&str> = graphs.graphs.iter().map(|graph| graph.name.as_str()).collect();
    assert_eq!(names, ["scree", "broken_edge", "granite", "snow_line"], "each file once");
    assert_eq!(terrain.layers[1].parameters["tile"], Literal::f32(6.0));
    assert!(matches!(&terrain.layers[2].mask, LayerMask::Painted(texture) if texture.wrap == Wrap::Clamp));
    assert!(matches!(terrain.layers[3].mask, LayerMask::Graph(GraphId(3))));
}

#[test]
fn recipes_come_complete() {
    let text = r#"Project(version: 1, made: {
        "textures/rock": cracked_rock(size: 128, seed: 3),
        "textures/hills.png": mountains(size: 64),
    })"#;
    let user = r#"Surface(version: 1,
        textures: { "rock": (file: "textures/rock_albedo.png", color: srgb) },
        nodes: { "a": texture(of: rock, uv: terrain_uv) },
        outputs: ( albedo: "a.rgb" ))"#;
    let mut project = open(base().with("terrane.ron", text).with("graphs/surfaces/tested.ron", user));
    let [hills, rock] = &project.made[..] else { panic!("{:?}", project.made) };
    assert_eq!((rock.recipe.name, rock.arguments["size"], rock.arguments["seed"]), ("cracked_rock", 128.0, 3.0));
    let cracks = rock.recipe.arguments.iter().find(|argument| argument.name == "cracks").expect("it has one");
    assert_eq!(rock.arguments["cracks"], cracks.default, "defaults are filled in");
    let made = |path: &str| rock.files.iter().find(|(file, _)| file == path).map(|(_, header)| *header);
    let header = |channels, depth| Some(ImageHeader { size: (128, 128), channels, depth });
    assert_eq!((made("textures/rock_height.png"), made("textures/rock_albedo.png")), (header(1, 16), header(3, 8)));
    let map = ("textures/hills.png".to_owned(), ImageHeader { size: (64, 64), channels: 1, depth: 16 });
    assert!(hills.files.contains(&map), "{:?}", hills.files);
    let (graphs, id, _) = project.surface("graphs/surfaces/tested.ron").expect("what will be made is not missing");
    assert_eq!(graphs.graphs[id.0].textures[0].size, (128, 128));
}

#[test]
fn comments_and_line_ends_do_not_matter() {
    let plain = r#"Surface(version: 1, nodes: { "a": contrast(x: slope) }, outputs: ( albedo: a ))"#;
    let noisy = "// one\r\n/* two */ Surface(version: 1,\r\n  nodes: { /* w */ \"a\" /* x */ : /* y */ contrast /* z */ (x: slope // end\r\n) },\r\n  outputs: ( albedo: /* v */ a /* u */ ) /* t */ ) // last";
    let (plain, noisy) = (surface(plain), surface(noisy));
    assert_eq!(support::without_spans(&plain), support::without_spans(&noisy));
}
