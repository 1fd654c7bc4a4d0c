//! Bind group layouts: the host's from its shader, the material's from the manifest.

use naga::{AddressSpace, GlobalVariable, ImageClass, ImageDimension, TypeInner};
use serde_json::{Value, json};
use terrane_codegen::manifest::Manifest;

/// Vertex and fragment stage.
const DRAWING: u32 = 1 | 2;

/// Arrays of `GPUBindGroupLayoutEntry`: group 0 belongs to the host, group 1 to the material.
pub(crate) fn groups(module: &naga::Module, manifest: &Manifest) -> Value {
    json!([host(module), material(manifest)])
}

/// What the manifest tells an engine to bind.
fn material(manifest: &Manifest) -> Vec<Value> {
    let uniform = manifest.parameters.iter().map(
        |block| json!({ "binding": block.binding, "visibility": DRAWING, "buffer": { "minBindingSize": block.size } }),
    );
    let textures = manifest.textures.iter().map(|texture| {
        let kind = json!({ "viewDimension": texture.dimension, "sampleType": texture.sample_type });
        json!({ "binding": texture.binding, "visibility": DRAWING, "texture": kind })
    });
    let samplers = manifest
        .samplers
        .iter()
        .map(|sampler| json!({ "binding": sampler.binding, "visibility": DRAWING, "sampler": {} }));
    let reliefs = manifest.relief.iter().flat_map(|relief| &relief.arrays);
    let reliefs = reliefs.flat_map(|array| &array.textures).map(|texture| match &texture.access {
        Some(access) => {
            let kind = json!({ "viewDimension": texture.dimension, "access": access, "format": texture.format });
            json!({ "binding": texture.binding, "visibility": DRAWING, "storageTexture": kind })
        }
        None => {
            let kind = json!({ "viewDimension": texture.dimension, "sampleType": texture.sample_type });
            json!({ "binding": texture.binding, "visibility": DRAWING, "texture": kind })
        }
    });
    uniform.chain(textures).chain(samplers).chain(reliefs).collect()
}

fn host(module: &naga::Module) -> Vec<Value> {
    let globals = module.global_variables.iter().map(|(_, variable)| variable);
    let bound = globals.filter_map(|variable| Some((variable.binding?, variable)));
    bound.filter(|(binding, _)| binding.group == 0).map(|(at, variable)| entry(module, at.binding, variable)).collect()
}

fn entry(module: &naga::Module, binding: u32, variable: &GlobalVariable) -> Value {
    let (kind, description) = match (variable.space, &module.types[variable.ty].inner) {
        (AddressSpace::Uniform, _) => ("buffer", json!({})),
        (_, TypeInner::Sampler { .. }) => ("sampler", json!({})),
        (_, TypeInner::Image { dim, arrayed, class: ImageClass::Sampled { .. } }) => {
            let dimension = match (dim, arrayed) {
                (ImageDimension::D2, false) => "2d",
                (ImageDimension::D2, true) => "2d-array",
                (ImageDimension::D3, _) => "3d",
                other => panic!("the host binds no {other:?}"),
            };
            ("texture", json!({ "viewDimension": dimension }))
        }
        (_, other) => panic!("the host binds no {other:?}"),
    };
    json!({ "binding": binding, "visibility": DRAWING, kind: description })
}
