//! What stands in a scene, as a renderer gets it.

mod support;

use support::base;
use terrane_codegen::diagnostic::render;
use terrane_codegen::graph::model::{HeightFrom, Object, Solid};

#[test]
fn objects_of_a_scene_are_read() {
    let scene = r#"Scene(version: 1, terrain: "graphs/terrains/alpine.ron", sun: (azimuth: 130.0, elevation: 28.0),
        camera: (eye: (410.0, 655.0, 380.0), target: (900.0, 520.0, 1200.0)),
        objects: [
            sphere(center: (1.0, 2.0, 3.0), radius: 0.5),
            box(center: (1.0, 2.0, 3.0), from: ground, size: (4.0, 5.0, 6.0), turn: -30.0, roughness: 0.25),
            column(center: (1.0, 2.0, 3.0), from: zero, radius: 0.5, height: 7.0, albedo: (0.1, 0.2, 0.3)),
        ])"#;
    let opened = support::project(base().with("graphs/scenes/tested.ron", scene));
    let mut project = opened.unwrap_or_else(|error| panic!("{}", render(&error.diagnostics, &error.sources, false)));
    let (_, scene, _) = project.scene("graphs/scenes/tested.ron").expect("it is valid");
    let center = [1.0, 2.0, 3.0];
    let sphere = Object {
        solid: Solid::Sphere { radius: 0.5 },
        center,
        from: HeightFrom::Zero,
        albedo: [0.2; 3],
        roughness: 0.6,
    };
    let box_like = Solid::Box { size: [4.0, 5.0, 6.0], turn: -30.0 };
    let column = Solid::Column { radius: 0.5, height: 7.0 };
    let expected = [
        sphere,
        Object { solid: box_like, from: HeightFrom::Ground, roughness: 0.25, ..sphere },
        Object { solid: column, albedo: [0.1, 0.2, 0.3], ..sphere },
    ];
    assert_eq!(scene.objects, expected);
}
