//! One layer of a terrain.

use std::collections::BTreeMap;

use super::fit::Owner;
use super::port;
use super::session::Session;
use super::texture::suits;
use crate::diagnostic::Diagnostic;
use crate::graph::file::{Expr, LayerEntry, LayerMaskEntry, Named};
use crate::graph::model::{ColorSpace, Filter, GraphId, Layer, LayerMask, Role, Texture, Wrap};
use crate::graph::{codes, names, suggest};
use crate::value::Literal;

/// Resolves a layer.
pub(super) fn layer(session: &mut Session<'_>, entry: &LayerEntry) -> Option<Layer> {
    let surface = session.graph(&entry.surface, Role::Surface);
    let mask = mask(session, &entry.mask);
    let parameters = parameters(session, surface?, &entry.parameters);
    Some(Layer { surface: surface?, parameters: parameters?, mask: mask?, span: entry.span })
}

fn mask(session: &mut Session<'_>, mask: &LayerMaskEntry) -> Option<LayerMask> {
    match mask {
        LayerMaskEntry::Full => Some(LayerMask::Full),
        LayerMaskEntry::Graph(file) => session.graph(file, Role::Mask).map(LayerMask::Graph),
        LayerMaskEntry::Painted(file) => {
            let images = session.images();
            let (path, header) = images.find(file, &mut session.findings)?;
            if !suits(&path, header, ColorSpace::Linear, file.span, &mut session.findings) {
                return None;
            }
            Some(LayerMask::Painted(Texture {
                name: names::stem(&path).to_owned(),
                file: path,
                color: ColorSpace::Linear,
                channel: Some(0),
                // The mask lies over the whole terrain once: its borders must not bleed into each other.
                wrap: Wrap::Clamp,
                filter: Filter::Linear,
                anisotropy: 1,
                size: header.size,
                depth: header.depth,
                span: file.span,
            }))
        }
    }
}

fn parameters(
    session: &mut Session<'_>,
    surface: GraphId,
    entries: &[(Named, Option<Expr>)],
) -> Option<BTreeMap<String, Literal>> {
    let graph = &session.graphs.graphs[surface.0];
    let mut values = BTreeMap::new();
    let mut findings = Vec::new();
    for (name, expr) in entries {
        let Some(parameter) = graph.parameters.iter().find(|parameter| parameter.name == name.name) else {
            let message = format!("`{}` has no parameter `{}`", graph.name, name.name);
            let mut finding = Diagnostic::error(codes::UNKNOWN_PARAMETER, name.span, message);
            finding.help = suggest::help(&name.name, graph.parameters.iter().map(|parameter| parameter.name.as_str()));
            findings.push(finding);
            continue;
        };
        let port = port::of_parameter(parameter);
        let value =
            expr.as_ref().and_then(|expr| port::constant(session.library(), expr, &port, Owner::Layer, &mut findings));
        values.extend(value.map(|value| (name.name.clone(), value)));
    }
    session.findings.append(&mut findings);
    (values.len() == entries.len()).then_some(values)
}
