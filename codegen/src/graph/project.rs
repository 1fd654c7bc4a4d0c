//! A project: the folder with `terrane.ron`, its library, and questions about its graphs.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::file::{Content, FileRole, Named, role_of};
use super::files::{Disk, FileError, Files};
use super::image::ImageHeader;
use super::made::{Made, made};
use super::model::{GraphId, Graphs, Role, Scene, Terrain};
use super::resolve::{Session, Texts, file_error};
use super::{codes, limits, path};
use crate::diagnostic::{Diagnostic, SourceId, Sources, Span, any_error, sort};
use crate::library::Library;

/// The file that makes a folder a project.
pub const PROJECT_FILE: &str = "terrane.ron";

/// A project that is ready to answer questions about its graphs.
pub struct Project {
    /// Every text read so far, for rendering diagnostics.
    pub sources: Sources,
    /// The node kinds: the standard ones and the project's own.
    pub library: Library,
    /// What `terrane.ron` asks to be made, sorted by path.
    pub made: Vec<Made>,
    root: PathBuf,
    files: Box<dyn Files>,
    made_files: BTreeMap<String, ImageHeader>,
    texts: Texts,
}

/// A project that cannot even be opened.
#[derive(Debug)]
pub struct OpenError {
    /// The texts that the findings point into.
    pub sources: Sources,
    /// What is wrong.
    pub diagnostics: Vec<Diagnostic>,
}

/// Everything that a question found, or everything that is wrong.
pub type Answer<T> = Result<(Graphs, T, Vec<Diagnostic>), Vec<Diagnostic>>;

impl Project {
    /// Opens the project that a folder or file belongs to: the nearest folder upwards with a `terrane.ron`.
    ///
    /// # Errors
    /// If there is none, if `terrane.ron` is wrong, or if a node of the project is.
    pub fn open(inside: impl AsRef<Path>) -> Result<Self, OpenError> {
        let inside = inside.as_ref();
        let start = inside.canonicalize().unwrap_or_else(|_| std::path::absolute(inside).unwrap_or(inside.into()));
        let root = start.ancestors().find(|folder| folder.join(PROJECT_FILE).is_file());
        let disk = root.and_then(|root| Disk::new(root).ok());
        let Some(disk) = disk else { return Err(no_project(inside)) };
        let root = disk.root().to_owned();
        let files = Box::new(disk);
        let mut sources = Sources::default();
        let library = own_nodes(&*files, &mut sources).and_then(|nodes| Library::load(&mut sources, &nodes));
        match library {
            Ok(library) => Self::with(root, files, library, sources),
            Err(diagnostics) => Err(OpenError { sources, diagnostics }),
        }
    }

    /// A project of given files and library, for tests and for tools that keep files elsewhere. `sources` is what the
    /// library was read from.
    ///
    /// # Errors
    /// If `terrane.ron` is wrong.
    pub fn with(root: PathBuf, files: Box<dyn Files>, library: Library, sources: Sources) -> Result<Self, OpenError> {
        let (made, made_files, texts) = (Vec::new(), BTreeMap::new(), Texts::default());
        let mut project = Self { sources, library, made, root, files, made_files, texts };
        let mut findings = Vec::new();
        project.read_project_file(&mut findings);
        if any_error(&findings) {
            sort(&mut findings);
            return Err(OpenError { sources: project.sources, diagnostics: findings });
        }
        Ok(project)
    }

    fn read_project_file(&mut self, findings: &mut Vec<Diagnostic>) {
        let mut session = self.session();
        let place = session.place(PROJECT_FILE);
        let document = session.document_as(PROJECT_FILE, FileRole::Project, place);
        findings.append(&mut session.findings);
        if let Some(Content::Project(file)) = document.map(|document| document.content) {
            self.made = made(&file, findings);
            self.made_files = self.made.iter().flat_map(|made| made.files.iter().cloned()).collect();
        }
    }

    /// The folder of `terrane.ron`.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The files of the project.
    pub fn files(&self) -> &dyn Files {
        &*self.files
    }

    /// The project-relative path of a file, given from the working directory.
    ///
    /// # Errors
    /// If it lies outside the project.
    pub fn relative(&mut self, file: &Path) -> Result<String, Vec<Diagnostic>> {
        let outer = std::path::absolute(file).unwrap_or(file.into());
        let outer = outer.canonicalize().unwrap_or(outer);
        let inner = outer.strip_prefix(&self.root).ok().and_then(Path::to_str);
        let inner = inner.map(|path| path.replace(std::path::MAIN_SEPARATOR, "/"));
        inner.ok_or_else(|| {
            let shown = file.display().to_string();
            let place = self.session().place(&shown);
            let message = format!("`{shown}` lies outside the project");
            vec![
                Diagnostic::error(codes::ESCAPING_PATH, place, message)
                    .help(format!("the project is {}", self.root.display())),
            ]
        })
    }

    /// A terrain and every graph behind it, with warnings. The path is project-relative.
    ///
    /// # Errors
    /// Everything that is wrong, in the order of files and places.
    pub fn terrain(&mut self, path: &str) -> Answer<Terrain> {
        self.ask(path, |session, named| {
            let path = session.path(named)?;
            session.terrain(&path, named.span)
        })
    }

    /// A scene and every graph behind it, with warnings. The path is project-relative.
    ///
    /// # Errors
    /// Everything that is wrong, in the order of files and places.
    pub fn scene(&mut self, path: &str) -> Answer<Scene> {
        self.ask(path, |session, named| {
            let path = session.path(named)?;
            let document = session.document_as(&path, FileRole::Scene, named.span)?;
            let Content::Scene(file) = &document.content else { return None };
            session.resolve_scene(&document, file)
        })
    }

    /// One surface and every instance behind it, with warnings. The path is project-relative.
    ///
    /// # Errors
    /// Everything that is wrong, in the order of files and places.
    pub fn surface(&mut self, path: &str) -> Answer<GraphId> {
        self.ask(path, |session, named| session.graph(named, Role::Surface))
    }

    /// A graph of any role, with warnings. The path is project-relative.
    ///
    /// # Errors
    /// Everything that is wrong, in the order of files and places.
    pub fn graph(&mut self, path: &str, role: Role) -> Answer<GraphId> {
        self.ask(path, |session, named| session.graph(named, role))
    }

    /// Everything that is wrong or doubtful about a file of any kind and about those that it needs.
    pub fn check(&mut self, path: &str) -> Vec<Diagnostic> {
        let found = self.role(path);
        let checked = match found {
            Some(FileRole::Terrain) => self.terrain(path).map(|(.., findings)| findings),
            Some(FileRole::Scene) => self.scene(path).map(|(.., findings)| findings),
            Some(FileRole::Instance) => self.graph(path, Role::Instance).map(|(.., findings)| findings),
            Some(FileRole::Mask) => self.graph(path, Role::Mask).map(|(.., findings)| findings),
            Some(FileRole::Project) => Ok(Vec::new()),
            // A file that does not say what it is says why when it is read as anything.
            Some(FileRole::Surface) | None => self.surface(path).map(|(.., findings)| findings),
        };
        checked.unwrap_or_else(|findings| findings)
    }

    /// Checks every `.ron` file under `graphs/`.
    pub fn check_all(&mut self) -> Vec<Diagnostic> {
        let mut findings: Vec<Diagnostic> = self.graph_files().iter().flat_map(|path| self.check(path)).collect();
        sort(&mut findings);
        findings
    }

    /// Every `.ron` file under `graphs/`, sorted.
    pub fn graph_files(&self) -> Vec<String> {
        let mut found = Vec::new();
        let mut folders = vec!["graphs".to_owned()];
        while let Some(folder) = folders.pop() {
            for name in self.files.list(&folder) {
                match name.strip_suffix('/') {
                    Some(name) if folders.len() < limits::FILES => folders.push(format!("{folder}/{name}")),
                    None if name.ends_with(".ron") => found.push(format!("{folder}/{name}")),
                    _ => {}
                }
            }
        }
        found.sort();
        found
    }

    /// What a file is, by its first word.
    pub fn role(&mut self, path: &str) -> Option<FileRole> {
        let path = path::normalise(path).ok()?;
        if let Some(source) = self.texts.read.get(&path) {
            return role_of(*source, &self.sources.get(*source).text);
        }
        let bytes = self.files.read(&path, limits::FILE_BYTES).ok()?;
        role_of(SourceId(0), &String::from_utf8(bytes).ok()?)
    }

    fn session(&mut self) -> Session<'_> {
        Session::new(&self.library, &*self.files, &self.made_files, &mut self.sources, &mut self.texts)
    }

    fn ask<T>(&mut self, path: &str, question: impl FnOnce(&mut Session<'_>, &Named) -> Option<T>) -> Answer<T> {
        let mut session = self.session();
        let named = Named { name: path.to_owned(), span: session.place(path) };
        let answer = question(&mut session, &named);
        let (mut findings, graphs) = (session.findings, session.graphs);
        sort(&mut findings);
        shorten(&mut findings);
        match answer {
            Some(answer) if !any_error(&findings) => Ok((graphs, answer, findings)),
            _ => Err(findings),
        }
    }
}

/// Keeps the report readable, and its rendering short, for a file that is wrong everywhere.
fn shorten(findings: &mut Vec<Diagnostic>) {
    let hidden = findings.len().saturating_sub(limits::FINDINGS);
    findings.truncate(limits::FINDINGS);
    if let Some(last) = findings.last_mut().filter(|_| hidden > 0) {
        last.notes.push(format!("{hidden} more findings are not shown"));
    }
}

/// The WGSL files of a project's `nodes/` folder.
fn own_nodes(files: &dyn Files, sources: &mut Sources) -> Result<Vec<(String, String)>, Vec<Diagnostic>> {
    let mut nodes = Vec::new();
    let mut findings = Vec::new();
    for name in files.list("nodes").into_iter().filter(|name| name.ends_with(".wgsl")) {
        let path = format!("nodes/{name}");
        let text = files.read(&path, limits::FILE_BYTES).and_then(|bytes| {
            String::from_utf8(bytes)
                .map_err(|error| FileError::Unreadable(format!("it is not UTF-8: {}", error.utf8_error())))
        });
        match text {
            Ok(text) => nodes.push((path, text)),
            Err(error) => {
                let place = Span { source: sources.add(&path, ""), start: 0, end: 0 };
                findings.push(file_error(files, std::iter::empty(), &path, &error, place));
            }
        }
    }
    if findings.is_empty() { Ok(nodes) } else { Err(findings) }
}

fn no_project(inside: &Path) -> OpenError {
    let mut sources = Sources::default();
    let place = Span { source: sources.add(inside.display().to_string(), ""), start: 0, end: 0 };
    let message = format!("no folder from here upwards holds a `{PROJECT_FILE}`");
    let finding = Diagnostic::error(codes::NO_PROJECT, place, message);
    let diagnostics = vec![finding.help("`terrane new DIR` makes a project")];
    OpenError { sources, diagnostics }
}
