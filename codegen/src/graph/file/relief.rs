//! How a terrain traces its displaced surface, as it is written.

use terrane_shaderlib::relief::Method;

use super::call::call;
use crate::diagnostic::Diagnostic;
use crate::graph::codes;
use crate::graph::model::{ReliefMethod, ReliefShadow, ReliefTrace, ReliefWeights};
use crate::graph::syntax::{Field, Fields};

/// `relief: (method: …, weights: …, fade: (…, …))`; shadow and occlusion are written elsewhere.
pub(super) fn relief(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<ReliefTrace> {
    let mut fields = Fields::open(field.raw, "`relief`", findings)?;
    let method = fields.need("method", findings).and_then(|field| method(field, findings));
    let weights = fields.take("weights").map_or(Some(ReliefWeights::Entry), |field| weights(field, findings));
    let fade = fields.need("fade", findings).and_then(|field| field.range(0.0, 100_000.0, findings));
    fields.close(findings);
    let (shadow, occlusion) = (ReliefShadow::Off, 0);
    Some(ReliefTrace { method: method?, weights: weights?, fade: fade?, shadow, occlusion })
}

fn method(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<ReliefMethod> {
    let mut call = call(field, "`auto`", findings)?;
    if call.name.name != "auto" {
        return fixed(field, &call.name.name, findings);
    }
    let max_error = call.fields.need("max_error", findings).and_then(|field| field.number(0.001, 64.0, findings));
    call.close(findings);
    max_error.map(|max_error| ReliefMethod::Auto { max_error })
}

/// A method as it is written for `terrane measure` too.
fn fixed(field: Field<'_>, name: &str, findings: &mut Vec<Diagnostic>) -> Option<ReliefMethod> {
    if let Ok(method) = field.raw.text().parse::<Method>() {
        return Some(ReliefMethod::Fixed(method));
    }
    let known: Vec<&str> = std::iter::once("auto").chain(Method::names()).collect();
    findings.push(if known.contains(&name) {
        let message = format!("`{}` is no budget of `{name}`", field.raw.text());
        let finding = Diagnostic::error(codes::WRONG_SHAPE, field.raw.span(), message);
        finding.help("`terrane measure --help` lists the methods with their budgets")
    } else {
        field.unknown_choice(name, &known)
    });
    None
}

fn weights(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<ReliefWeights> {
    let choices = [("entry", ReliefWeights::Entry), ("along_ray", ReliefWeights::AlongRay)];
    let weights = field.choice(&choices, findings)?;
    if weights == ReliefWeights::AlongRay {
        let message = "masks are not followed along the ray: they count where it enters";
        let finding = Diagnostic::warning(codes::RELIEF_NOT_TRACED, field.raw.span(), message);
        findings.push(finding.help("write `weights: entry`, which is what is drawn"));
    }
    Some(weights)
}
