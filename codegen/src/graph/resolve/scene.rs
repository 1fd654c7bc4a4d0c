//! A scene and the terrain behind it.

use super::session::Session;
use crate::graph::file::{Document, SceneFile};
use crate::graph::model::Scene;

impl Session<'_> {
    /// A scene that is decoded already.
    pub(in crate::graph) fn resolve_scene(&mut self, document: &Document, file: &SceneFile) -> Option<Scene> {
        let terrain = file.terrain.as_ref().and_then(|named| {
            let path = self.path(named)?;
            self.terrain(&path, named.span)
        });
        Some(Scene {
            source: document.source,
            path: document.path.clone(),
            name: document.name.clone(),
            doc: document.doc.clone(),
            terrain: terrain?,
            image: file.image?,
            camera: file.camera?,
            sun: file.sun?,
            turbidity: file.turbidity,
            exposure: file.exposure,
            objects: file.objects.clone(),
        })
    }
}
