//! Objects of a scene, as they are written: `sphere(…)`, `box(…)`, `column(…)`.

use super::call::{Call, call};
use crate::diagnostic::Diagnostic;
use crate::graph::model::{HeightFrom, Object, Solid};
use crate::graph::syntax::{Field, Shape};
use crate::graph::{codes, limits};

/// Metres: the least and the largest extent of a solid.
const EXTENT: (f32, f32) = (0.001, 10_000.0);
/// A middle grey that reflects a fifth of the light.
const ALBEDO: [f32; 3] = [0.2; 3];
/// Rough, but not chalk.
const ROUGHNESS: f32 = 0.6;

/// `objects: […]`
pub(super) fn objects(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Vec<Object> {
    let items = match field.shape(findings) {
        Some(Shape::List(items)) => items,
        Some(other) => {
            field.wrong(&other, "a list: [sphere(center: …, radius: …), …]", findings);
            return Vec::new();
        }
        None => return Vec::new(),
    };
    if items.len() > limits::OBJECTS {
        let message = format!("a scene has at most {} objects, this one has {}", limits::OBJECTS, items.len());
        findings.push(Diagnostic::error(codes::LIMIT, field.name_span, message));
        return Vec::new();
    }
    items.into_iter().filter_map(|raw| object(Field { raw, ..field }, findings)).collect()
}

fn object(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<Object> {
    let mut call = call(field, "an object", findings)?;
    let solid = match call.name.name.as_str() {
        "sphere" => sphere(&mut call, findings),
        "box" => cuboid(&mut call, findings),
        "column" => column(&mut call, findings),
        other => {
            findings.push(field.unknown_choice(other, &["sphere", "box", "column"]));
            return None;
        }
    };
    let fields = &mut call.fields;
    let center = fields.need("center", findings).and_then(|field| field.numbers(-1.0e7, 1.0e7, findings));
    let choices = [("zero", HeightFrom::Zero), ("ground", HeightFrom::Ground)];
    let from = fields.take("from").map_or(Some(HeightFrom::Zero), |field| field.choice(&choices, findings));
    let albedo = fields.take("albedo").map_or(Some(ALBEDO), |field| field.numbers(0.0, 1.0, findings));
    let roughness = fields.take("roughness").map_or(Some(ROUGHNESS), |field| field.number(0.0, 1.0, findings));
    call.close(findings);
    Some(Object { solid: solid?, center: center?, from: from?, albedo: albedo?, roughness: roughness? })
}

fn sphere(call: &mut Call<'_>, findings: &mut Vec<Diagnostic>) -> Option<Solid> {
    length(call, "radius", findings).map(|radius| Solid::Sphere { radius })
}

fn cuboid(call: &mut Call<'_>, findings: &mut Vec<Diagnostic>) -> Option<Solid> {
    let size = call.fields.need("size", findings);
    let size = size.and_then(|field| field.numbers(EXTENT.0, EXTENT.1, findings));
    let turn = call.fields.take("turn").map_or(Some(0.0), |field| field.number(-360.0, 360.0, findings));
    Some(Solid::Box { size: size?, turn: turn? })
}

fn column(call: &mut Call<'_>, findings: &mut Vec<Diagnostic>) -> Option<Solid> {
    let (radius, height) = (length(call, "radius", findings), length(call, "height", findings));
    Some(Solid::Column { radius: radius?, height: height? })
}

fn length(call: &mut Call<'_>, name: &'static str, findings: &mut Vec<Diagnostic>) -> Option<f32> {
    call.fields.need(name, findings).and_then(|field| field.number(EXTENT.0, EXTENT.1, findings))
}
