//! The judge itself: it accepts what is right and refuses what naga lets through.

use serde_json::json;

use super::{Module, Report, Tint};

/// A vertex stage that feeds `fs`, and `count` textures.
fn drawing(count: u32, fragment: &str) -> String {
    let textures: String =
        (0..count).map(|i| format!("@group(0) @binding({i}) var t{i}: texture_2d<f32>;\n")).collect();
    let vertex = "struct V { @builtin(position) clip: vec4f, @location(0) uv: vec2f }
        @vertex fn vs(@location(0) at: vec3f) -> V { return V(vec4f(at, 1.0), at.xy); }";
    format!(
        "{textures}@group(1) @binding(0) var s: sampler;\n{vertex}\n@fragment fn fs(v: V) -> @location(0) vec4f {{ {fragment} }}"
    )
}

/// A fragment stage that samples that many textures.
fn sampling(count: u32) -> String {
    let samples: Vec<String> = (0..count).map(|i| format!("textureSampleLevel(t{i}, s, v.uv, 0.0)")).collect();
    drawing(count, &format!("return {};", samples.join(" + ")))
}

fn judge(modules: &[Module]) -> Option<Vec<Report>> {
    match Tint::start() {
        Ok(mut tint) => Some(tint.validate(modules)),
        Err(skip) => {
            skip.report();
            None
        }
    }
}

fn naga_accepts(wgsl: &str) -> bool {
    use naga::valid::{Capabilities, ValidationFlags, Validator};
    let module = naga::front::wgsl::parse_str(wgsl).unwrap();
    Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module).is_ok()
}

#[test]
fn accepts_a_module_and_creates_its_pipelines() {
    let compute = "@compute @workgroup_size(1) fn cs() {}";
    let modules = [Module::with_pipelines("drawing", sampling(16)), Module::with_pipelines("compute", compute)];
    let Some(reports) = judge(&modules) else { return };
    assert_eq!(reports.iter().map(Report::errors).collect::<String>(), "");
    let pipelines: Vec<&str> = reports.iter().flat_map(|report| &report.pipelines).map(|p| p.name.as_str()).collect();
    assert_eq!(pipelines, ["vs + fs", "cs"]);
}

#[test]
fn refuses_a_derivative_in_non_uniform_control_flow_which_naga_accepts() {
    let wgsl = drawing(1, "if (v.uv.x > 0.5) { return textureSample(t0, s, v.uv); } return vec4f(1.0);");
    assert!(naga_accepts(&wgsl));
    let Some(reports) = judge(&[Module::text_only("branch", &wgsl)]) else { return };
    let errors = reports[0].errors();
    assert!(errors.contains("'textureSample' must only be called from uniform control flow"), "{errors}");
    let line = 1 + wgsl[..wgsl.find("textureSample(").unwrap()].matches('\n').count();
    assert!(errors.starts_with(&format!("branch:{line}:")), "{errors}");
}

#[test]
fn refuses_seventeen_sampled_textures_which_naga_accepts() {
    let wgsl = sampling(17);
    assert!(naga_accepts(&wgsl));
    let Some(reports) = judge(&[Module::with_pipelines("seventeen", wgsl)]) else { return };
    assert!(reports[0].messages.is_empty(), "the limit belongs to the pipeline, not to the text");
    assert!(reports[0].errors().contains("(17)"), "{}", reports[0].errors());
}

#[test]
fn compares_an_explicit_layout_with_the_shader() {
    let texture = json!([{ "binding": 0, "visibility": 2, "texture": {} }]);
    let sampler = json!([{ "binding": 0, "visibility": 2, "sampler": {} }]);
    let module = Module::with_pipelines("layout", sampling(1));
    let right = module.clone().with_layouts(&json!([texture, sampler]));
    let missing = module.clone().with_layouts(&json!([texture, []]));
    let swapped = module.with_layouts(&json!([sampler, texture]));
    let Some(reports) = judge(&[right, missing, swapped]) else { return };
    assert_eq!(reports[0].errors(), "");
    assert_eq!(reports[0].pipelines.len(), 2);
    for report in &reports[1..] {
        assert_eq!(report.errors().lines().filter(|line| line.contains("explicit layout")).count(), 1, "{report:?}");
    }
}

#[test]
fn reports_syntax_errors_and_goes_on() {
    let modules = [Module::text_only("broken", "fn f( {"), Module::text_only("sound", "fn f() {}")];
    let Some(reports) = judge(&modules) else { return };
    assert!(reports[0].errors().starts_with("broken:1:"), "{}", reports[0].errors());
    assert_eq!(reports[1].errors(), "");
}
