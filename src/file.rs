//! Files that are replaced in one step or not at all.

use std::io::{self, Write as _};
use std::path::Path;

/// Writes a file beside the target and renames it: whatever happens, the target is the old file or the new one. A file
/// that holds these bytes already is left alone, so that build systems see no change.
///
/// # Errors
/// If the folder cannot be made or the file not be written; the old file is still there.
pub fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if std::fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)?;
    let mut file = temporary(folder)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

fn temporary(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".terrane-").suffix(".new");
    // A temporary file is private by default; what Terrane makes need not be.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o644));
    builder.tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::write;

    #[test]
    fn a_target_that_cannot_be_replaced_stays() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let target = folder.path().join("taken");
        std::fs::create_dir_all(target.join("inside"))?;
        assert!(write(&target, b"new").is_err());
        assert!(target.join("inside").is_dir());
        assert_eq!(std::fs::read_dir(folder.path())?.count(), 1, "no temporary file is left");
        Ok(())
    }

    #[test]
    fn folders_are_made_and_files_replaced() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let target = folder.path().join("a/b.txt");
        write(&target, b"old")?;
        write(&target, b"new")?;
        assert_eq!(std::fs::read(&target)?, b"new");
        Ok(())
    }
}
