//! Files as they are written: decoded with places, nothing looked up yet.
//!
//! A part that is wrong is reported once and then known by name only, so that whatever refers to it is left in peace.

mod call;
mod decode;
mod expr;
mod graph;
mod light;
mod object;
mod port;
mod project;
mod relief;
mod scene;
mod terrain;
mod texture;

pub(crate) use decode::{decode, role_of};
pub(crate) use expr::{Expr, Value};
pub(crate) use graph::{AllowEntry, GraphFile, NodeEntry, ReliefEntry, unknown_output};
pub(crate) use port::{PortEntry, PortKind};
pub(crate) use project::{MadeEntry, ProjectFile};
pub(crate) use scene::SceneFile;
pub(crate) use terrain::{HeightEntry, LayerEntry, LayerMaskEntry, TerrainFile};
pub(crate) use texture::{TextureEntry, TextureFiles};

use crate::diagnostic::{SourceId, Span};

/// A name and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Named {
    /// The name.
    pub(crate) name: String,
    /// Its place.
    pub(crate) span: Span,
}

impl Named {
    pub(crate) fn new(name: &str, span: Span) -> Self {
        Self { name: name.to_owned(), span }
    }
}

/// A named part of a file; without a value if it could not be read.
#[derive(Clone, Debug)]
pub(crate) struct Entry<T> {
    /// Its name.
    pub(crate) name: Named,
    /// From the name to the end of the value.
    pub(crate) span: Span,
    /// What it says.
    pub(crate) value: Option<T>,
}

/// One decoded file.
#[derive(Clone, Debug)]
pub(crate) struct Document {
    /// The file.
    pub(crate) source: SourceId,
    /// Project-relative path.
    pub(crate) path: String,
    /// File stem.
    pub(crate) name: String,
    /// What the author says of it.
    pub(crate) doc: String,
    /// The name in front: `Surface`.
    pub(crate) head: Span,
    /// What it says.
    pub(crate) content: Content,
}

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FileRole {
    /// `Surface(…)`
    Surface,
    /// `Instance(…)`
    Instance,
    /// `Mask(…)`
    Mask,
    /// `Terrain(…)`
    Terrain,
    /// `Scene(…)`
    Scene,
    /// `Project(…)`
    Project,
}

impl FileRole {
    /// Every role with its name in files and in messages.
    pub(crate) const ALL: [(&'static str, Self, &'static str); 6] = [
        ("Surface", Self::Surface, "a surface"),
        ("Instance", Self::Instance, "an instance"),
        ("Mask", Self::Mask, "a mask"),
        ("Terrain", Self::Terrain, "a terrain"),
        ("Scene", Self::Scene, "a scene"),
        ("Project", Self::Project, "a project"),
    ];

    /// In messages, with its article.
    pub(crate) fn words(self) -> &'static str {
        Self::ALL[self as usize].2
    }
}

/// What a file says.
#[derive(Clone, Debug)]
pub(crate) enum Content {
    /// A surface, an instance or a mask.
    Graph(Box<GraphFile>),
    /// A terrain.
    Terrain(Box<TerrainFile>),
    /// A scene.
    Scene(Box<SceneFile>),
    /// `terrane.ron`.
    Project(ProjectFile),
}

impl Content {
    /// What the file is.
    pub(crate) fn role(&self) -> FileRole {
        match self {
            Self::Graph(graph) => graph.role,
            Self::Terrain(_) => FileRole::Terrain,
            Self::Scene(_) => FileRole::Scene,
            Self::Project(_) => FileRole::Project,
        }
    }
}
