//! Paths in files: relative to the project root, under it, and the same file on every system.

/// Names that Windows gives to devices, in any folder and with any extension.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "conin$", "conout$"];

/// The path with `/` between its parts and nothing else, or why it is none.
///
/// # Errors
/// What is wrong, as the end of the sentence "the path …".
pub(crate) fn normalise(path: &str) -> Result<String, &'static str> {
    if path.is_empty() {
        return Err("is empty");
    }
    if path.chars().any(char::is_control) {
        return Err("holds a control character");
    }
    if path.contains('\\') {
        return Err("holds `\\`: write `/` on every system");
    }
    if path.starts_with('/') {
        return Err("is absolute: it should begin at the project root");
    }
    if path.contains(':') {
        return Err("holds `:`: it should begin at the project root");
    }
    let parts: Vec<&str> = path.split('/').filter(|part| !matches!(*part, "" | ".")).collect();
    if parts.contains(&"..") {
        return Err("holds `..`: it should begin at the project root and stay under it");
    }
    if parts.iter().any(|part| is_device(part) || part.ends_with(['.', ' '])) {
        return Err("holds a name that Windows reads as another file");
    }
    if parts.is_empty() { Err("names no file") } else { Ok(parts.join("/")) }
}

fn is_device(part: &str) -> bool {
    let stem = part.split('.').next().unwrap_or(part).trim_end().to_ascii_lowercase();
    let numbered = |name: &str| stem.strip_prefix(name).is_some_and(|rest| matches!(rest.as_bytes(), [b'0'..=b'9']));
    DEVICES.contains(&stem.as_str()) || numbered("com") || numbered("lpt")
}

/// Folder and file name.
pub(crate) fn split(path: &str) -> (&str, &str) {
    path.rsplit_once('/').unwrap_or(("", path))
}

#[cfg(test)]
mod tests {
    use super::normalise;

    #[test]
    fn keeps_what_is_inside() {
        assert_eq!(normalise("textures/a.png").as_deref(), Ok("textures/a.png"));
        assert_eq!(normalise("./textures//a.png").as_deref(), Ok("textures/a.png"));
        assert_eq!(normalise("a..b/c.png").as_deref(), Ok("a..b/c.png"));
    }

    #[test]
    fn refuses_what_is_outside_or_ambiguous() {
        let bad =
            ["", ".", "/etc/passwd", "..", "a/../../b", "C:/a", "c:a", "\\\\server\\a", "\\\\?\\C:\\a", "a\0b", "a\nb"];
        for path in bad.into_iter().chain(["nul", "a/CON.png", "com1.txt", "a/b. ", "a/b.", "a.png:stream"]) {
            assert!(normalise(path).is_err(), "{path:?}");
        }
    }
}
