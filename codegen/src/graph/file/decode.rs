//! What every file has: a role in front, a version, a sentence about itself.

use super::{Content, Document, FileRole, graph, project, scene, terrain};
use crate::diagnostic::{Diagnostic, SourceId, Span};
use crate::graph::syntax::{Fields, Key, Raw, Shape};
use crate::graph::{codes, names, suggest};

/// The version of the format.
const VERSION: u32 = 1;

/// Decodes a file. Nothing comes back if not even its role, version and fields can be told.
pub(crate) fn decode(source: SourceId, path: &str, text: &str, findings: &mut Vec<Diagnostic>) -> Option<Document> {
    let raw = Raw::file(source, text).map_err(|finding| findings.push(finding)).ok()?;
    let (role, head, entries) = head(raw, findings)?;
    let name = names::stem(path);
    if role != FileRole::Project && !names::is_name(name) {
        let message = format!("the file is called `{name}`, which is not a name");
        findings.push(
            Diagnostic::error(codes::INVALID_NAME, head, message)
                .help("lower case letters, digits and single `_`, beginning with a letter: it becomes a name in WGSL"),
        );
    }
    let mut fields = Fields::new(role.words(), head, entries, findings);
    version(&mut fields, findings)?;
    let doc = fields.take("doc").and_then(|field| field.text(findings)).unwrap_or_default();
    let content = match role {
        FileRole::Surface | FileRole::Instance | FileRole::Mask => {
            Content::Graph(Box::new(graph::read(role, &mut fields, findings)))
        }
        FileRole::Terrain => Content::Terrain(Box::new(terrain::read(&mut fields, findings))),
        FileRole::Scene => Content::Scene(Box::new(scene::read(&mut fields, findings))),
        FileRole::Project => Content::Project(project::read(&mut fields, findings)),
    };
    fields.close(findings);
    Some(Document { source, path: path.to_owned(), name: name.to_owned(), doc, head, content })
}

/// The role of a file, for those who only want to know that.
pub(crate) fn role_of(source: SourceId, text: &str) -> Option<FileRole> {
    let raw = Raw::file(source, text).ok()?;
    head(raw, &mut Vec::new()).map(|(role, ..)| role)
}

type Entries<'a> = Vec<(Key<'a>, Raw<'a>)>;

fn head<'a>(raw: Raw<'a>, findings: &mut Vec<Diagnostic>) -> Option<(FileRole, Span, Entries<'a>)> {
    let known = FileRole::ALL.map(|(name, ..)| name);
    let finding = match raw.shape() {
        Ok(Shape::Struct(Some(key), entries)) => {
            if let Some((_, role, _)) = FileRole::ALL.iter().find(|(name, ..)| *name == key.name) {
                return Some((*role, key.span, entries));
            }
            let message = format!("a file cannot be a `{}`", key.name);
            let finding = Diagnostic::error(codes::WRONG_ROLE, key.span, message);
            match suggest::nearest(key.name, known) {
                Some(name) => finding.help(format!("did you mean `{name}`?")),
                None => finding.help(format!("a file is one of {}", suggest::list(&known))),
            }
        }
        Ok(other) => {
            let place = Span { end: raw.span().start, ..raw.span() };
            let message = format!("the file is {}, it should say what it is", other.words());
            Diagnostic::error(codes::WRONG_SHAPE, place, message).help(format!(
                "write for instance `Surface(version: 1, …)`; a file is one of {}",
                suggest::list(&known)
            ))
        }
        Err(finding) => finding,
    };
    findings.push(finding);
    None
}

/// A file of another version may mean anything by its fields: nothing else in it is looked at.
fn version(fields: &mut Fields<'_>, findings: &mut Vec<Diagnostic>) -> Option<()> {
    let field = fields.need("version", findings)?;
    let number = field.digits(findings)?;
    if number.value == f64::from(VERSION) {
        return Some(());
    }
    let message = format!("version {} is not supported", number.text);
    findings.push(
        Diagnostic::error(codes::UNSUPPORTED_VERSION, number.span, message)
            .help(format!("this terrane reads version {VERSION}; a newer one may read this file")),
    );
    None
}
