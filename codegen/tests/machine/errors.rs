//! What cannot be evaluated is an error that says what and where.

use terrane_codegen::machine::{F32, MachineError, Value};

use crate::support::shader;

#[track_caller]
fn error(text: &str, arguments: &[Value<F32>]) -> String {
    shader(text).machine().call("f", arguments, 1).expect_err("it cannot be evaluated").to_string()
}

#[test]
fn derivatives_name_the_function() {
    let text = "fn slope(x: f32) -> f32 { return dpdx(x); } fn f(x: f32) -> f32 { return slope(x); }";
    let expected = "`slope` uses a screen-space derivative, which has no meaning on the CPU: not supported";
    assert_eq!(error(text, &[Value::f32(&[1.0])]), expected);
}

#[test]
fn implicit_samples_and_gathers_are_refused() {
    let head = "fn f(t: texture_2d<f32>, s: sampler, uv: vec2f) -> vec4f";
    let arguments = [Value::handle(0), Value::handle(0), Value::vector(&[[0.0, 0.0]])];
    let sample = error(&format!("{head} {{ return textureSample(t, s, uv); }}"), &arguments);
    assert_eq!(sample, "`f` uses a texture sample with implicit derivatives: not supported");
    let gather = error(&format!("{head} {{ return textureGather(0, t, s, uv); }}"), &arguments);
    assert_eq!(gather, "`f` uses a gathering, comparing or edge-clamping texture sample: not supported");
}

#[test]
fn other_widths_and_address_spaces_are_refused() {
    assert!(error("fn f(x: f64) -> f64 { return x; }", &[]).contains("a 64-bit Float"));
    let text = "var<private> state: f32; fn f() -> f32 { return state; }";
    assert!(error(text, &[]).contains("the global variable `state`"));
}

#[test]
fn loops_that_do_not_end_are_stopped() {
    let shader = shader("fn f(x: f32) -> f32 { var y = x; loop { y += 1.0; if (y < 0.0) { break; } } return y; }");
    let mut machine = shader.machine();
    machine.set_iteration_limit(500);
    let found = machine.call::<F32>("f", &[Value::f32(&[1.0])], 1);
    assert_eq!(found, Err(MachineError::Endless { function: "f".into(), iterations: 500 }));
}

#[test]
fn wrong_arguments_are_told_apart() {
    let text = "fn f(x: vec2f, n: i32) -> f32 { return x.x + f32(n); }";
    let vector = Value::vector(&[[1.0, 2.0]]);
    assert_eq!(error(text, std::slice::from_ref(&vector)), "`f` takes 2 arguments, not 1");
    assert_eq!(
        error(text, &[vector.clone(), Value::f32(&[1.0])]),
        "parameter 1 of `f` is (integer), the argument is (f32)"
    );
    assert_eq!(
        error(text, &[vector, Value::i32(&[1, 2])]),
        "parameter 1 of `f` is for 1 points, the argument is for 2"
    );
    assert_eq!(
        shader(text).machine().call::<F32>("g", &[], 1).expect_err("no g").to_string(),
        "there is no function `g`"
    );
}

#[test]
fn unknown_textures_are_errors() {
    let text = "fn f(t: texture_2d<f32>) -> vec4f { return textureLoad(t, vec2i(0), 0); }";
    assert_eq!(error(text, &[Value::handle(5)]), "`f` reads texture 5, which is unknown");
}
