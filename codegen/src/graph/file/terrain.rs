//! Terrains as they are written.

use super::Named;
use super::call::call;
use super::expr::{self, Expr};
use super::light::{occlusion, shadow};
use super::relief::relief;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::model::{Blend, ReliefShadow, ReliefTrace, Shadow};
use crate::graph::syntax::{Field, Fields, Shape};
use crate::graph::{codes, limits};

/// Metres: what 24.8 fixed point can address.
const LARGEST: f32 = 8_388_608.0;
/// Directions of the sky where a terrain does not say.
const DIRECTIONS: u32 = 8;

/// A terrain.
#[derive(Clone, Debug)]
pub(crate) struct TerrainFile {
    pub(crate) height: Option<HeightEntry>,
    pub(crate) patch: Option<f32>,
    pub(crate) layers: Vec<LayerEntry>,
    pub(crate) blend: Blend,
    pub(crate) relief: Option<ReliefTrace>,
    pub(crate) shadow: Shadow,
    pub(crate) occlusion: u32,
}

/// `height: (…)`
#[derive(Clone, Debug)]
pub(crate) struct HeightEntry {
    pub(crate) file: Named,
    pub(crate) size: (f32, f32),
    pub(crate) range: (f32, f32),
    pub(crate) span: Span,
}

/// One layer.
#[derive(Clone, Debug)]
pub(crate) struct LayerEntry {
    pub(crate) surface: Named,
    pub(crate) parameters: Vec<(Named, Option<Expr>)>,
    pub(crate) mask: LayerMaskEntry,
    pub(crate) span: Span,
}

/// `mask:` of a layer.
#[derive(Clone, Debug)]
pub(crate) enum LayerMaskEntry {
    Full,
    Painted(Named),
    Graph(Named),
}

/// Reads the fields of a terrain.
pub(super) fn read(fields: &mut Fields<'_>, findings: &mut Vec<Diagnostic>) -> TerrainFile {
    let height = fields.need("height", findings).and_then(|field| height(field, findings));
    let patch = fields.take("patch").map_or(Some(64.0), |field| patch(field, height.as_ref(), findings));
    let layers = fields.need("layers", findings).map(|field| layers(field, findings)).unwrap_or_default();
    let blend = fields.take("blend").and_then(|field| blend(field, findings)).unwrap_or(Blend::Over);
    let relief = fields.take("relief").and_then(|field| relief(field, findings));
    let shadow = fields.take("shadow").map(|field| shadow(field, findings));
    let (shadow, relief_shadow) = shadow.unwrap_or((Shadow::Horizon, ReliefShadow::Off));
    let occlusion = fields.take("occlusion").map(|field| occlusion(field, findings)).unwrap_or_default();
    let relief =
        relief.map(|trace| ReliefTrace { shadow: relief_shadow, occlusion: occlusion.1.unwrap_or(0), ..trace });
    let occlusion = occlusion.0.unwrap_or(DIRECTIONS);
    TerrainFile { height, patch, layers, blend, relief, shadow, occlusion }
}

fn height(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<HeightEntry> {
    let mut fields = Fields::open(field.raw, "`height`", findings)?;
    let file =
        fields.need("file", findings).and_then(|field| Some(Named::new(&field.text(findings)?, field.raw.span())));
    let size = fields.need("size", findings).and_then(|field| field.numbers(1.0, LARGEST, findings));
    let range = fields.need("range", findings).and_then(|field| field.range(-20_000.0, 20_000.0, findings));
    fields.close(findings);
    let span = Span { end: field.raw.span().end, ..field.name_span };
    size.zip(range).zip(file).map(|(([x, z], range), file)| HeightEntry { file, size: (x, z), range, span })
}

fn patch(field: Field<'_>, height: Option<&HeightEntry>, findings: &mut Vec<Diagnostic>) -> Option<f32> {
    let Some(height) = height else { return field.number(1.0, LARGEST, findings) };
    let low = (height.size.0.max(height.size.1) / limits::PATCHES).max(1.0);
    field.number(low, height.size.0.min(height.size.1), findings)
}

fn layers(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Vec<LayerEntry> {
    let items = match field.shape(findings) {
        Some(Shape::List(items)) => items,
        Some(other) => {
            field.wrong(&other, "a list: [(surface: …), …]", findings);
            return Vec::new();
        }
        None => return Vec::new(),
    };
    if items.is_empty() || items.len() > limits::LAYERS {
        let message = format!("a terrain has 1 to {} layers, this one has {}", limits::LAYERS, items.len());
        findings.push(Diagnostic::error(codes::LIMIT, field.name_span, message));
        return Vec::new();
    }
    items.into_iter().filter_map(|raw| layer(Field { raw, ..field }, findings)).collect()
}

fn layer(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<LayerEntry> {
    let mut fields = Fields::open(field.raw, "a layer", findings)?;
    let surface = fields.need("surface", findings);
    let surface = surface.and_then(|field| Some(Named::new(&field.text(findings)?, field.raw.span())));
    let values = fields.take("parameters").map(|field| field.map(findings)).unwrap_or_default();
    let parameters = values
        .into_iter()
        .map(|field| (Named::new(field.name, field.name_span), expr::read(field, findings)))
        .collect();
    let mask = fields.take("mask").map_or(Some(LayerMaskEntry::Full), |field| mask(field, findings));
    fields.close(findings);
    Some(LayerEntry { surface: surface?, parameters, mask: mask?, span: field.raw.span() })
}

fn mask(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<LayerMaskEntry> {
    let call = call(field, "a mask", findings)?;
    let example = format!("{}(\"path of a file\")", call.name.name);
    let known = ["painted", "graph"];
    if !known.contains(&call.name.name.as_str()) {
        findings.push(field.unknown_choice(&call.name.name, &known));
        return None;
    }
    let path = call.only(field, &example, findings)?;
    let path = Named::new(&path.text(findings)?, path.raw.span());
    Some(if call.name.name == "painted" { LayerMaskEntry::Painted(path) } else { LayerMaskEntry::Graph(path) })
}

fn blend(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<Blend> {
    let mut call = call(field, "`height_soft`", findings)?;
    let blend = match call.name.name.as_str() {
        "over" => Some(Blend::Over),
        "height_max" => Some(Blend::HeightMax),
        "height_soft" => {
            let band = call.fields.need("band", findings).and_then(|field| field.number(0.001, 1.0, findings));
            band.map(|band| Blend::HeightSoft { band })
        }
        other => {
            findings.push(field.unknown_choice(other, &["over", "height_max", "height_soft"]));
            return None;
        }
    };
    call.close(findings);
    blend
}
