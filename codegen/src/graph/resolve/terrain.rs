//! A terrain and every graph behind it.

use super::layer::layer;
use super::session::Session;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::file::{Content, Document, FileRole, HeightEntry, TerrainFile};
use crate::graph::model::{HeightMap, Layer, LayerMask, Terrain};
use crate::graph::{codes, limits};

impl Session<'_> {
    /// The terrain at a normalised path; `from` is where it is named.
    pub(in crate::graph) fn terrain(&mut self, path: &str, from: Span) -> Option<Terrain> {
        let document = self.document_as(path, FileRole::Terrain, from)?;
        let Content::Terrain(file) = &document.content else { return None };
        self.resolve_terrain(&document, file)
    }

    /// A terrain that is decoded already.
    pub(in crate::graph) fn resolve_terrain(&mut self, document: &Document, file: &TerrainFile) -> Option<Terrain> {
        let height = file.height.as_ref().and_then(|height| self.height_map(height));
        let layers: Vec<Option<Layer>> = file.layers.iter().map(|entry| layer(self, entry)).collect();
        let layers: Vec<Layer> = layers.into_iter().collect::<Option<_>>()?;
        self.limit_nodes(document, &layers)?;
        Some(Terrain {
            source: document.source,
            path: document.path.clone(),
            name: document.name.clone(),
            doc: document.doc.clone(),
            height: height?,
            patch: file.patch?,
            layers,
            blend: file.blend,
            relief: file.relief,
            shadow: file.shadow,
            occlusion: file.occlusion,
        })
    }

    fn height_map(&mut self, entry: &HeightEntry) -> Option<HeightMap> {
        let images = self.images();
        let (file, header) = images.find(&entry.file, &mut self.findings)?;
        if header.channels != 1 {
            let message = format!("`{file}` has {} channels, a height map is grey", header.channels);
            self.findings.push(Diagnostic::error(codes::BAD_IMAGE, entry.file.span, message));
            return None;
        }
        if header.size.0 < 2 || header.size.1 < 2 {
            let message =
                format!("`{file}` is {}x{} texels, a height map has at least 2x2", header.size.0, header.size.1);
            let finding = Diagnostic::error(codes::BAD_IMAGE, entry.file.span, message);
            self.findings.push(finding.help("the ground is the surface between neighbouring texels"));
            return None;
        }
        let HeightEntry { size, range, span, .. } = *entry;
        Some(HeightMap { file, texels: header.size, size, range, span })
    }

    /// All layers together become one shader.
    fn limit_nodes(&mut self, document: &Document, layers: &[Layer]) -> Option<()> {
        let mask = |layer: &Layer| match layer.mask {
            LayerMask::Graph(id) => Some(id),
            _ => None,
        };
        let graphs = layers.iter().flat_map(|layer| std::iter::once(layer.surface).chain(mask(layer)));
        let nodes: usize = graphs.map(|id| self.expanded(id)).sum();
        if nodes <= limits::NODES {
            return Some(());
        }
        let message = format!("the layers have {nodes} nodes, the limit is {}", limits::NODES);
        self.findings.push(Diagnostic::error(codes::LIMIT, document.head, message));
        None
    }
}
