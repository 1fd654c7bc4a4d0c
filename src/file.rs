//! Files that are replaced in one step or not at all.

use std::fmt;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// A file could not be written. What was there before is still there.
#[derive(Debug)]
pub struct Error {
    /// The file.
    pub path: PathBuf,
    /// Why.
    pub source: io::Error,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot write {}: {}", self.path.display(), self.source)
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.source)
    }
}

/// Writes a file beside the target and renames it: whatever happens, the target is the old file or the new one. Folders
/// that are missing are made. A file that holds these bytes already is left alone, so that build systems see no change.
///
/// # Errors
/// If a folder cannot be made or the file not be written; the old file is still there.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    if std::fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    replace(path, bytes).map_err(|source| Error { path: path.to_owned(), source })
}

/// Finds out whether [`write()`] can write a file, before somebody waits for what is to be in it. Makes its folder.
///
/// # Errors
/// Those that [`write()`] would give, but for a full disk.
pub fn check(path: &Path) -> Result<(), Error> {
    temporary(path).map(drop).map_err(|source| Error { path: path.to_owned(), source })
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = temporary(path)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path).map(drop).map_err(|error| error.error)
}

/// A new file beside the target, gone with its value unless it takes the target's place.
fn temporary(target: &Path) -> io::Result<tempfile::NamedTempFile> {
    // Renaming over a device or a pipe would take it away.
    if std::fs::metadata(target).is_ok_and(|there| !there.is_file()) {
        return Err(io::Error::other("it is there and no file"));
    }
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    make(folder)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".terrane-").suffix(".new");
    // A temporary file is private by default; what Terrane makes need not be, and the user's umask has the last word.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // tempfile's own error names the temporary file, which nobody knows.
    builder.tempfile_in(folder).map_err(|error| io::Error::other(format!("in {}: {error}", folder.display())))
}

fn make(folder: &Path) -> io::Result<()> {
    if let Some(taken) = folder.ancestors().find(|taken| taken.is_file()) {
        return Err(io::Error::other(format!("{} is no folder", taken.display())));
    }
    std::fs::create_dir_all(folder)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::{check, write};

    fn entries(folder: &Path) -> usize {
        fs::read_dir(folder).map_or(0, Iterator::count)
    }

    #[test]
    fn a_target_that_cannot_be_replaced_stays() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("taken");
        fs::create_dir_all(target.join("inside")).unwrap();
        let error = write(&target, b"new").unwrap_err().to_string();
        assert_eq!(error, format!("cannot write {}: it is there and no file", target.display()));
        assert!(check(&target).is_err() && target.join("inside").is_dir());
        assert_eq!(entries(folder.path()), 1, "no temporary file is left");
    }

    #[test]
    fn folders_are_made_and_files_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a/b.txt");
        write(&target, b"old").unwrap();
        write(&target, b"new").unwrap();
        assert_eq!(fs::read(&target).unwrap(), b"new");
        assert_eq!(entries(&folder.path().join("a")), 1, "no temporary file is left");
    }

    #[test]
    fn a_file_where_a_folder_should_be_is_named_and_stays() {
        let folder = tempfile::tempdir().unwrap();
        let taken = folder.path().join("taken");
        fs::write(&taken, "old").unwrap();
        let target = taken.join("deep/new.png");
        let said = format!("cannot write {}: {} is no folder", target.display(), taken.display());
        assert_eq!(check(&target).unwrap_err().to_string(), said);
        assert_eq!(write(&target, b"new").unwrap_err().to_string(), said);
        assert_eq!(fs::read(&taken).unwrap(), b"old");
    }

    #[test]
    fn a_check_leaves_the_target_as_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("new/picture.png");
        check(&target).unwrap();
        assert_eq!(entries(&folder.path().join("new")), 0);
        fs::write(&target, "old").unwrap();
        check(&target).unwrap();
        assert_eq!(fs::read(&target).unwrap(), b"old");
    }

    // Nobody may make files there, not even root.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_folder_without_permission_is_found_by_the_check() {
        let error = check(Path::new("/proc/picture.png")).unwrap_err().to_string();
        assert!(error.starts_with("cannot write /proc/picture.png: in /proc: "), "{error}");
    }
}
