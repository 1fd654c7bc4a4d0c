//! One question to a project: reads the files that it needs, each once, instances before their users.

use std::collections::{BTreeMap, BTreeSet};

use super::graph::{self, Instances, World};
use super::images::Images;
use crate::diagnostic::{Diagnostic, SourceId, Sources, Span};
use crate::graph::file::{Content, Document, FileRole, GraphFile, Named, decode};
use crate::graph::files::{FileError, Files};
use crate::graph::image::ImageHeader;
use crate::graph::model::{Callee, GraphId, Graphs, Role};
use crate::graph::{codes, limits, path, suggest};
use crate::library::Library;

/// Where instances live.
const INSTANCES: &str = "graphs/instances";

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
    library: &'p Library,
    files: &'p dyn Files,
    made: &'p BTreeMap<String, ImageHeader>,
    sources: &'p mut Sources,
    texts: &'p mut Texts,
    known_instances: Vec<String>,
    pub(in crate::graph) findings: Vec<Diagnostic>,
    pub(in crate::graph) graphs: Graphs,
    /// By path; `None` for a file that is wrong.
    ids: BTreeMap<String, (Role, Option<GraphId>)>,
    /// How many nodes a graph has once every instance is copied to each of its calls.
    expanded: Vec<usize>,
    /// The files that are being resolved, outermost first, with the place that asked for the next one.
    chain: Vec<(String, String, Span)>,
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
        let names = files.list(INSTANCES);
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

    fn graph_at(&mut self, path: &str, role: Role, from: Span) -> Option<GraphId> {
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

    /// Resolves every instance that a file calls, in the order of their names.
    fn instances(&mut self, document: &Document, file: &GraphFile) -> Instances {
        let calls = file.nodes.iter().filter_map(|node| node.value.as_ref());
        let mut kinds: BTreeMap<&str, Span> = BTreeMap::new();
        for call in calls.filter(|call| self.known_instances.contains(&call.kind.name)) {
            kinds.entry(&call.kind.name).or_insert(call.kind.span);
        }
        let mut instances = Instances::new();
        for (kind, span) in kinds {
            let path = format!("{INSTANCES}/{kind}.ron");
            self.chain.push((document.path.clone(), document.name.clone(), span));
            let id = self.instance(kind, &path, span);
            self.chain.pop();
            instances.insert(kind.to_owned(), id);
        }
        instances
    }

    fn instance(&mut self, kind: &str, path: &str, span: Span) -> Option<GraphId> {
        if self.library.kinds.contains_key(kind) {
            let message = format!("`{kind}` is a node kind, and `{path}` is an instance of the same name");
            let finding = Diagnostic::error(codes::KIND_CLASH, span, message);
            self.findings.push(finding.help("rename the file: its stem is the name that graphs call"));
            return None;
        }
        if let Some(first) = self.chain.iter().position(|(file, ..)| file == path) {
            self.instance_cycle(first);
            return None;
        }
        if self.chain.len() > limits::INCLUDE_DEPTH {
            let message = format!("instances are nested more than {} deep", limits::INCLUDE_DEPTH);
            self.findings.push(Diagnostic::error(codes::LIMIT, span, message));
            return None;
        }
        self.graph_at(path, Role::Instance, span)
    }

    fn instance_cycle(&mut self, first: usize) {
        let mut ring = self.chain[first..].to_vec();
        // The same cycle reads the same, whichever file was looked at first.
        let smallest = (0..ring.len()).min_by_key(|step| ring[*step].1.clone()).unwrap_or(0);
        ring.rotate_left(smallest);
        let names: Vec<String> = ring.iter().chain(&ring[..1]).map(|(_, name, _)| format!("`{name}`")).collect();
        let message = match ring.as_slice() {
            [(_, name, _)] => format!("instance `{name}` calls itself"),
            _ => format!("cycle of instances: {}", names.join(" -> ")),
        };
        let step = |index: usize| (ring[index].2, format!("{} calls {}", names[index], names[index + 1]));
        let (span, text) = step(0);
        let finding = Diagnostic::error(codes::CYCLE, span, message).label(text);
        let finding = (1..ring.len()).map(step).fold(finding, |finding, (span, text)| finding.also(span, text));
        self.findings.push(finding.help("an instance is copied to each of its calls: it cannot contain itself"));
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

/// A path that cannot be one.
pub(in crate::graph) fn bad_path(path: &str, why: &str, span: Span) -> Diagnostic {
    let shown: String = path.chars().take(200).flat_map(char::escape_debug).collect();
    Diagnostic::error(codes::ESCAPING_PATH, span, format!("the path `{shown}` {why}"))
        .help("paths begin at the folder of `terrane.ron` and stay under it")
}

/// A file that cannot be had; `others` are names that would do although no folder lists them.
pub(in crate::graph) fn file_error<'a>(
    files: &dyn Files,
    others: impl Iterator<Item = &'a str>,
    path: &str,
    error: &FileError,
    span: Span,
) -> Diagnostic {
    let (code, message, help) = match error {
        FileError::Missing => {
            (codes::MISSING_FILE, format!("there is no file `{path}`"), near_file(files, others, path))
        }
        FileError::Escapes => {
            let help = "a link on the way points outside the folder of `terrane.ron`".to_owned();
            (codes::ESCAPING_PATH, format!("`{path}` leaves the project"), Some(help))
        }
        FileError::TooLarge(bytes) => {
            let limit = limits::FILE_BYTES >> 20;
            (codes::LIMIT, format!("`{path}` has {bytes} bytes, the limit is {limit} MiB"), None)
        }
        FileError::Unreadable(why) => (codes::UNREADABLE_FILE, format!("`{path}` cannot be read: {why}"), None),
    };
    let mut finding = Diagnostic::error(code, span, message);
    finding.help = help;
    finding
}

fn near_file<'a>(files: &dyn Files, others: impl Iterator<Item = &'a str>, path: &str) -> Option<String> {
    let (folder, name) = path::split(path);
    let listed: Vec<String> = files.list(folder).into_iter().filter(|name| !name.ends_with('/')).collect();
    let made = others.map(path::split).filter(|(made, _)| *made == folder).map(|(_, name)| name);
    let known: Vec<&str> = listed.iter().map(String::as_str).chain(made).collect();
    let join = |name: &str| if folder.is_empty() { name.to_owned() } else { format!("{folder}/{name}") };
    if let Some(near) = suggest::nearest(name, known.iter().copied()) {
        return Some(format!("did you mean `{}`?", join(near)));
    }
    if known.is_empty() {
        return (!folder.is_empty()).then(|| format!("there is no folder `{folder}`"));
    }
    let extension = name.rsplit_once('.').map(|(_, extension)| extension)?;
    let mut alike: Vec<&str> = known.into_iter().filter(|name| name.ends_with(extension)).collect();
    alike.sort_unstable();
    alike.dedup();
    (!alike.is_empty()).then(|| format!("`{folder}` holds {}", suggest::list(&alike)))
}
