//! Shadow and occlusion of a terrain, as they are written: each of the terrain's shape and of the relief on it.

use super::call::call;
use crate::diagnostic::Diagnostic;
use crate::graph::model::{ReliefShadow, Shadow};
use crate::graph::syntax::{Field, Fields, Shape};

/// `shadow: (terrain: …, relief: …)`
pub(super) fn shadow(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> (Shadow, ReliefShadow) {
    let Some(mut fields) = Fields::open(field.raw, "`shadow`", findings) else {
        return (Shadow::Horizon, ReliefShadow::Off);
    };
    let choices = [("off", Shadow::Off), ("horizon", Shadow::Horizon)];
    let terrain = fields.take("terrain").and_then(|field| field.choice(&choices, findings));
    let relief = fields.take("relief").and_then(|field| relief_shadow(field, findings));
    fields.close(findings);
    (terrain.unwrap_or(Shadow::Horizon), relief.unwrap_or(ReliefShadow::Off))
}

/// `off`, `hard`, `cone` or `cone(planes: 7)`
fn relief_shadow(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<ReliefShadow> {
    let mut call = call(field, "`relief`", findings)?;
    let shadow = match call.name.name.as_str() {
        "off" => Some(ReliefShadow::Off),
        "hard" => Some(ReliefShadow::Hard),
        "cone" => {
            let planes = call.fields.take("planes").map_or(Some(1), |field| field.whole(1, 16, findings));
            planes.map(|planes| ReliefShadow::Cone { planes })
        }
        other => {
            findings.push(field.unknown_choice(other, &["off", "hard", "cone"]));
            return None;
        }
    };
    call.close(findings);
    shadow
}

/// `occlusion: directions(8)` of the terrain alone, or `(terrain: …, relief: …)`: directions where they are given.
pub(super) fn occlusion(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> (Option<u32>, Option<u32>) {
    if !matches!(field.shape(&mut Vec::new()), Some(Shape::Struct(None, _))) {
        return (directions(field, 64, findings), None);
    }
    let Some(mut fields) = Fields::open(field.raw, "`occlusion`", findings) else { return (None, None) };
    let terrain = fields.take("terrain").and_then(|field| directions(field, 64, findings));
    let relief = fields.take("relief").and_then(|field| directions(field, 16, findings));
    fields.close(findings);
    (terrain, relief)
}

fn directions(field: Field<'_>, most: u32, findings: &mut Vec<Diagnostic>) -> Option<u32> {
    let call = call(field, "`occlusion`", findings)?;
    match call.name.name.as_str() {
        "off" => {
            call.close(findings);
            Some(0)
        }
        "directions" => call.only(field, "directions(8)", findings)?.whole(1, most, findings),
        other => {
            findings.push(field.unknown_choice(other, &["off", "directions"]));
            None
        }
    }
}
