//! Where files come from: a folder on a disk, or memory.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// Why a file cannot be had.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileError {
    /// There is none.
    Missing,
    /// A link leads out of the project.
    Escapes,
    /// It has more bytes than were asked for.
    TooLarge(u64),
    /// Anything else, in the system's words.
    Unreadable(String),
}

/// The files of a project, by normalised paths below its root.
pub trait Files: Send + Sync {
    /// A whole file.
    ///
    /// # Errors
    /// If it is not there, leads out of the project, is larger than `limit` bytes or cannot be read.
    fn read(&self, path: &str, limit: u64) -> Result<Vec<u8>, FileError>;

    /// The first bytes of a file, fewer if it has no more.
    ///
    /// # Errors
    /// If it is not there, leads out of the project or cannot be read.
    fn head(&self, path: &str, length: usize) -> Result<Vec<u8>, FileError>;

    /// Names in a folder, sorted; folders end with `/`. Empty if there is no such folder.
    fn list(&self, folder: &str) -> Vec<String>;
}

/// A folder on a disk.
#[derive(Clone, Debug)]
pub struct Disk {
    root: PathBuf,
}

impl Disk {
    /// The folder that holds `terrane.ron`.
    ///
    /// # Errors
    /// If it cannot be resolved.
    pub fn new(root: &Path) -> std::io::Result<Self> {
        root.canonicalize().map(|root| Self { root })
    }

    /// The folder, with every link resolved.
    pub fn root(&self) -> &Path {
        &self.root
    }

    fn open(&self, path: &str) -> Result<(File, u64), FileError> {
        let path = self.root.join(path).canonicalize().map_err(|error| refusal(&error))?;
        if !path.starts_with(&self.root) {
            return Err(FileError::Escapes);
        }
        let file = File::open(&path).map_err(|error| refusal(&error))?;
        let data = file.metadata().map_err(|error| refusal(&error))?;
        if data.is_file() { Ok((file, data.len())) } else { Err(FileError::Unreadable("it is not a file".into())) }
    }
}

fn refusal(error: &std::io::Error) -> FileError {
    use std::io::ErrorKind;
    match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => FileError::Missing,
        // The system's own words differ between systems.
        kind => FileError::Unreadable(kind.to_string()),
    }
}

impl Files for Disk {
    fn read(&self, path: &str, limit: u64) -> Result<Vec<u8>, FileError> {
        let (file, length) = self.open(path)?;
        if length > limit {
            return Err(FileError::TooLarge(length));
        }
        let mut bytes = Vec::new();
        // A file may grow while it is read.
        file.take(limit + 1).read_to_end(&mut bytes).map_err(|error| refusal(&error))?;
        if bytes.len() as u64 > limit { Err(FileError::TooLarge(bytes.len() as u64)) } else { Ok(bytes) }
    }

    fn head(&self, path: &str, length: usize) -> Result<Vec<u8>, FileError> {
        let (file, _) = self.open(path)?;
        let mut bytes = Vec::new();
        file.take(length as u64).read_to_end(&mut bytes).map_err(|error| refusal(&error))?;
        Ok(bytes)
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let Ok(path) = self.root.join(folder).canonicalize() else { return Vec::new() };
        if !path.starts_with(&self.root) {
            return Vec::new();
        }
        let entries = std::fs::read_dir(path).into_iter().flatten().filter_map(Result::ok);
        let name = |entry: std::fs::DirEntry| {
            let slash = if entry.path().is_dir() { "/" } else { "" };
            Some(format!("{}{slash}", entry.file_name().to_str()?))
        };
        let mut names: Vec<String> = entries.filter_map(name).collect();
        names.sort();
        names
    }
}

/// Files in memory, by path.
#[derive(Clone, Debug, Default)]
pub struct Memory(pub BTreeMap<String, Vec<u8>>);

impl Memory {
    /// Adds or replaces a file.
    pub fn with(mut self, path: &str, bytes: impl Into<Vec<u8>>) -> Self {
        self.0.insert(path.to_owned(), bytes.into());
        self
    }
}

impl Files for Memory {
    fn read(&self, path: &str, limit: u64) -> Result<Vec<u8>, FileError> {
        let bytes = self.0.get(path).ok_or(FileError::Missing)?;
        if bytes.len() as u64 > limit { Err(FileError::TooLarge(bytes.len() as u64)) } else { Ok(bytes.clone()) }
    }

    fn head(&self, path: &str, length: usize) -> Result<Vec<u8>, FileError> {
        let bytes = self.0.get(path).ok_or(FileError::Missing)?;
        Ok(bytes[..length.min(bytes.len())].to_vec())
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let prefix = if folder.is_empty() { String::new() } else { format!("{folder}/") };
        let name = |path: &String| {
            let rest = path.strip_prefix(&prefix)?;
            Some(rest.split_once('/').map_or_else(|| rest.to_owned(), |(folder, _)| format!("{folder}/")))
        };
        let mut names: Vec<String> = self.0.keys().filter_map(name).collect();
        names.sort();
        names.dedup();
        names
    }
}
