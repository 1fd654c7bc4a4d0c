//! One question to a project: reads the files that it needs, each once, instances before their users.

use std::collections::{BTreeMap, BTreeSet};

use super::fault::{bad_path, file_error};
use super::graph::{self, World};
use super::images::Images;
use super::instances;
use crate::diagnostic::{Diagnostic, SourceId, Sources, Span};
use crate::graph::file::{Content, Document, FileRole, GraphFile, Named, decode};
use crate::graph::files::Files;
use crate::graph::image::ImageHeader;
use crate::graph::model::{Callee, GraphId, Graphs, Role};
use crate::graph::{codes, limits, path};
use crate::library::Library;

/// Which of the sources are which files.
#[derive(Debug, Default)]
pub(in crate::graph) struct Texts {
    /// Files that were read, by path.
    pub(in crate::graph) read: BTreeMap<String, SourceId>,
    /// Empty texts that stand for a file which nothing names.
    places: BTreeMap<String, SourceId>,
}

/// Everything found so far.
pub(in crate::graph) struct Session<'p> {
    pub(super) library: &'p Library,
    files: &'p dyn Files,
    made: &'p BTreeMap<String, ImageHeader>,
    sources: &'p mut Sources,
    texts: &'p mut Texts,
    pub(super) known_instances: Vec<String>,
    pub(in crate::graph) findings: Vec<Diagnostic>,
    pub(in crate::graph) graphs: Graphs,
    /// By path; `None` for a file that is wrong.
    ids: BTreeMap<String, (Role, Option<GraphId>)>,
    /// How many nodes a graph has once every instance is copied to each of its calls.
    expanded: Vec<usize>,
    /// The files that are being resolved, outermost first, with the place that asked for the next one.
    pub(super) chain: Vec<(String, String, Span)>,
    visited: BTreeSet<String>,
}

impl<'p> Session<'p> {
    /// A question to a project's parts.
    pub(in crate::graph) fn new(
        library: &'p Library,
        files: &'p dyn Files,
        made: &'p BTreeMap<String, ImageHeader>,
        sources: &'p mut Sources,
        texts: &'p mut Texts,
    ) -> Self {
        let names = files.list(instances::FOLDER);
        let known_instances = names.iter().filter_map(|name| name.strip_suffix(".ron")).map(str::to_owned).collect();
        Self {
            library,
            files,
            made,
            sources,
            texts,
            known_instances,
            findings: Vec::new(),
            graphs: Graphs::default(),
            ids: BTreeMap::new(),
            expanded: Vec::new(),
            chain: Vec::new(),
            visited: BTreeSet::new(),
        }
    }

    /// The library, for those who check numbers.
    pub(super) fn library(&self) -> &'p Library {
        self.library
    }

    /// Images of the project.
    pub(super) fn images(&self) -> Images<'p> {
        Images { files: self.files, made: self.made }
    }

    /// A place for findings about a file that no other file names, such as that it does not exist.
    pub(in crate::graph) fn place(&mut self, path: &str) -> Span {
        let source = *self.texts.places.entry(path.to_owned()).or_insert_with(|| self.sources.add(path, ""));
        Span { source, start: 0, end: 0 }
    }

    /// The normalised path of a file that is named somewhere.
    pub(in crate::graph) fn path(&mut self, file: &Named) -> Option<String> {
        path::normalise(&file.name).map_err(|why| self.findings.push(bad_path(&file.name, why, file.span))).ok()
    }

    /// Decodes a file at a normalised path; `from` is where it is named.
    pub(in crate::graph) fn document(&mut self, path: &str, from: Span) -> Option<Document> {
        self.visited.insert(path.to_owned());
        if self.visited.len() > limits::FILES {
            let message = format!("more than {} files are needed", limits::FILES);
            self.findings.push(Diagnostic::error(codes::LIMIT, from, message));
            return None;
        }
        let source = match self.texts.read.get(path) {
            Some(source) => *source,
            None => self.read(path, from)?,
        };
        decode(source, path, &self.sources.get(source).text, &mut self.findings)
    }

    fn read(&mut self, path: &str, from: Span) -> Option<SourceId> {
        let bytes = match self.files.read(path, limits::FILE_BYTES) {
            Ok(bytes) => bytes,
            Err(error) => {
                self.findings.push(file_error(self.files, std::iter::empty(), path, &error, from));
                return None;
            }
        };
        match String::from_utf8(bytes) {
            Ok(text) => {
                let source = self.sources.add(path, text);
                self.texts.read.insert(path.to_owned(), source);
                Some(source)
            }
            Err(error) => {
                let message = format!("`{path}` is not UTF-8: byte {}", error.utf8_error().valid_up_to());
                self.findings.push(Diagnostic::error(codes::UNREADABLE_FILE, from, message));
                None
            }
        }
    }

    /// A file that must have a certain role.
    pub(in crate::graph) fn document_as(&mut self, path: &str, role: FileRole, from: Span) -> Option<Document> {
        let document = self.document(path, from)?;
        let found = document.content.role();
        if found == role {
            return Some(document);
        }
        self.wrong_role(path, found.words(), role.words(), from, Some(document.head));
        None
    }

    fn wrong_role(&mut self, path: &str, found: &str, wanted: &str, from: Span, head: Option<Span>) {
        let message = format!("`{path}` is {found}, here it should be {wanted}");
        let named = !self.texts.places.values().any(|place| *place == from.source);
        self.findings.push(match head {
            Some(head) if named => Diagnostic::error(codes::WRONG_ROLE, from, message).also(head, "it says so here"),
            head => Diagnostic::error(codes::WRONG_ROLE, head.unwrap_or(from), message),
        });
    }

    /// The graph in a file that is named somewhere.
    pub(in crate::graph) fn graph(&mut self, file: &Named, role: Role) -> Option<GraphId> {
        let path = self.path(file)?;
        self.graph_at(&path, role, file.span)
    }

    pub(super) fn graph_at(&mut self, path: &str, role: Role, from: Span) -> Option<GraphId> {
        if let Some((found, id)) = self.ids.get(path) {
            let (found, id) = (*found, *id);
            if found != role {
                self.wrong_role(path, words(found), words(role), from, None);
                return None;
            }
            return id;
        }
        let document = self.document_as(path, file_role(role), from)?;
        let Content::Graph(file) = &document.content else { return None };
        let id = self.resolve(&document, file);
        self.ids.insert(path.to_owned(), (role, id));
        id
    }

    fn resolve(&mut self, document: &Document, file: &GraphFile) -> Option<GraphId> {
        if file.role == FileRole::Instance && self.library.kinds.contains_key(&document.name) {
            let message = format!("there is a node kind `{}` already", document.name);
            self.findings.push(
                Diagnostic::error(codes::KIND_CLASH, document.head, message)
                    .help("rename the file: its stem is the name that graphs call"),
            );
        }
        let instances = self.instances(document, file);
        let world = World {
            library: self.library,
            images: Images { files: self.files, made: self.made },
            graphs: &self.graphs.graphs,
            known_instances: &self.known_instances,
        };
        let graph = graph::graph(world, document, file, &instances, &mut self.findings)?;
        let nodes = graph.nodes.iter().map(|node| match node.callee {
            Callee::Function { .. } => 1,
            Callee::Instance(id) => self.expanded[id.0],
        });
        let expanded = nodes.fold(0, usize::saturating_add);
        if expanded > limits::NODES {
            let message = format!("the graph has more than {} nodes, those of its instances counted", limits::NODES);
            self.findings.push(Diagnostic::error(codes::LIMIT, document.head, message));
            return None;
        }
        self.expanded.push(expanded);
        self.graphs.graphs.push(graph);
        Some(GraphId(self.graphs.graphs.len() - 1))
    }

    /// Nodes of a graph once every instance is copied to each of its calls.
    pub(super) fn expanded(&self, id: GraphId) -> usize {
        self.expanded[id.0]
    }
}

fn file_role(role: Role) -> FileRole {
    match role {
        Role::Surface => FileRole::Surface,
        Role::Instance => FileRole::Instance,
        Role::Mask => FileRole::Mask,
    }
}

fn words(role: Role) -> &'static str {
    file_role(role).words()
}
