//! Installing what is missing with Debian's package manager, or saying exactly what to install.

use std::process::Command;

use crate::step::{answer, command, step, succeed};

/// Something that the machine lacks.
pub(crate) struct Missing {
    /// In words, for the message.
    pub(crate) what: &'static str,
    /// The Debian packages that bring it.
    pub(crate) packages: &'static [&'static str],
}

/// Installs the packages of everything that is missing.
///
/// # Errors
/// If this is no Debian, the user may not install, or apt-get fails: a message with the command to run.
pub(crate) fn install(missing: &[Missing]) -> Result<(), String> {
    if missing.is_empty() {
        return Ok(());
    }
    let packages: Vec<&str> = missing.iter().flat_map(|missing| missing.packages).copied().collect();
    let list = missing.iter().map(|missing| missing.what).collect::<Vec<_>>().join(", ");
    if answer("apt-get", &["--version"]).is_none() {
        let names = packages.join(" ");
        return Err(format!(
            "This needs {list}.\nInstall what your system calls them (on Debian: {names}) and try again."
        ));
    }
    let Some(prefix) = administrator() else {
        return Err(format!("This needs {list}. Run\n\n    {}\n\nand try again.", by_hand(&packages)));
    };
    step(&format!("install {}", packages.join(" ")), || {
        // A package source that cannot be reached is no reason to stop: the others may have what we need.
        let _ = succeed(apt(prefix, &["update"]));
        let fixed = ["install", "-y", "--no-install-recommends"];
        succeed(apt(prefix, &[&fixed[..], &packages].concat()))
            .map_err(|error| format!("{error}\nThis needs {list}. The command was\n\n    {}", by_hand(&packages)))
    })
}

/// What to put before `apt-get`: nothing for root, `sudo` where it asks no password, `None` where we may not install.
fn administrator() -> Option<&'static [&'static str]> {
    if answer("id", &["-u"]).as_deref() == Some("0") {
        return Some(&[]);
    }
    answer("sudo", &["-n", "true"]).map(|_| &["sudo", "-n"][..])
}

fn apt(prefix: &[&str], arguments: &[&str]) -> Command {
    // `env` sets the variable on sudo's far side, where the caller's environment does not reach.
    let words = [prefix, &["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-q"], arguments].concat();
    command(words[0], &words[1..])
}

fn by_hand(packages: &[&str]) -> String {
    let packages = packages.join(" ");
    format!("sudo apt-get update && sudo apt-get install -y --no-install-recommends {packages}")
}
