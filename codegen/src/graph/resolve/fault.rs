//! Paths that are none and files that cannot be had.

use crate::diagnostic::{Diagnostic, Span};
use crate::graph::files::{FileError, Files};
use crate::graph::{codes, limits, path, suggest};

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
