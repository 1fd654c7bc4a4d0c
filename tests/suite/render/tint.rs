//! The renderer's own shaders under Tint.

use terrane_shaderlib::hosts;

use super::world::{ALPINE, OUT, shader, shader_in};
use crate::skip::Skip;
use crate::tint::{Module, Tint};

#[test]
fn tint_accepts_every_shader_of_the_renderer() {
    let Ok(mut tint) = Tint::start().map_err(Skip::report) else { return };
    let core = format!("{OUT}{ALPINE}");
    let modules = [
        Module::with_pipelines("terrain", shader(&core)),
        Module::with_pipelines("terrain with objects", shader_in(hosts::WGPU_TERRAIN_FURNISHED, &core)),
        Module::with_pipelines("preview", shader_in(hosts::WGPU_PREVIEW, &core)),
        Module::with_pipelines("sky", hosts::join(hosts::WGPU_SKY)),
        Module::with_pipelines("resolve", hosts::join(hosts::WGPU_RESOLVE)),
    ];
    for report in tint.validate(&modules) {
        assert!(report.errors().is_empty(), "{}: {}", report.name, report.errors());
        assert!(!report.pipelines.is_empty(), "{}: no pipeline was tried", report.name);
    }
}
