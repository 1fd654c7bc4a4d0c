//! How long a surface takes: `cargo test -p terrane-codegen --release --test machine -- --ignored --nocapture speed`.

use std::time::Instant;

use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_codegen::machine::{Domain, F32, F64, Machine, NoTextures, Value};

use crate::support::shader;

/// Twelve noises of five octaves and what a surface makes of them: about 1,000 calls a point.
const SURFACE: &str = "
fn speed_surface(position: Place) -> vec3f {
    var sum = vec3f(0.0);
    var weight = 1.0;
    for (var layer = 0u; layer < 4u; layer++) {
        let wavelength = 40.0 / f32(layer + 1u);
        let base = fbm(position, wavelength, 5u, 0.5, layer);
        let detail = fbm(position, wavelength * 0.25, 5u, 0.5, layer + 9u);
        let mask = fbm(position, wavelength * 3.0, 5u, 0.5, layer + 5u);
        if (mask > 0.5) {
            let tint = pow(vec3f(base, detail, mask), vec3f(2.4));
            sum += weight * mix(tint, vec3f(pow(base, 2.2)), smoothstep(0.2, 0.8, detail));
        } else {
            weight *= 0.5 + base;
        }
    }
    return sum;
}";

/// Side of the grid, in points.
const SIDE: usize = 256;

#[test]
#[ignore = "measures time"]
fn speed_of_a_surface() {
    let library = Library::load(&mut Sources::default(), &[]).expect("the shipped library is right");
    let shader = shader(&format!("{}{SURFACE}", library.text));
    let start = Instant::now();
    let mut machine = Machine::new(&shader.module, &shader.info, &NoTextures);
    if let Some(chunk) = std::env::var("CHUNK").ok().and_then(|text| text.parse().ok()) {
        machine.set_chunk(chunk);
    }
    println!("compile {:?}", start.elapsed());
    measure::<F32>(&machine, "f32");
    measure::<F64>(&machine, "f64");
}

fn measure<D: Domain>(machine: &Machine<'_>, name: &str) {
    let place = place::<D>();
    for round in 0..3 {
        let start = Instant::now();
        let (_, counts) = machine.call("speed_surface", std::slice::from_ref(&place), SIDE * SIDE).expect("it runs");
        let elapsed = start.elapsed();
        let operations = counts.arithmetic + counts.integer + counts.division + counts.transcendental;
        let rate = operations as f64 / elapsed.as_secs_f64() / 1.0e6;
        println!("{name} {round}: {elapsed:?}, {rate:.0} million operations a second, {counts:?}");
    }
}

fn place<D: Domain>() -> Value<D> {
    let local: Vec<[f32; 3]> =
        (0..SIDE * SIDE).map(|i| [(i % SIDE) as f32 * 0.25, 0.0, (i / SIDE) as f32 * 0.25]).collect();
    Value::join([
        Value::integers(&[[512, -1024]]),
        Value::vector(&local),
        Value::vector(&[[0.01, 0.0, 0.0]]),
        Value::vector(&[[0.0, 0.0, 0.01]]),
    ])
}
