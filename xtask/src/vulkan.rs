//! Whether wgpu will find a Vulkan driver: the loader library, and the description of at least one driver.

use std::env;
use std::path::{Path, PathBuf};

use crate::setup::Missing;
use crate::step::answer;

/// What must be installed before Terrane can draw; `None` where Vulkan is there or (macOS, Windows) not needed.
pub(crate) fn missing() -> Option<Missing> {
    let packages = match (has_loader(), has_driver()) {
        _ if !cfg!(target_os = "linux") => return None,
        (true, true) => return None,
        (true, false) => &["mesa-vulkan-drivers"][..],
        (false, _) => &["mesa-vulkan-drivers", "libvulkan1"][..],
    };
    Some(Missing { what: "a Vulkan driver (Mesa draws on the CPU where there is no GPU)", packages })
}

fn has_loader() -> bool {
    // Ordinary users do not have /sbin on their PATH.
    let cached = ["ldconfig", "/sbin/ldconfig"].iter().filter_map(|ldconfig| answer(ldconfig, &["-p"])).next();
    let named = env::var("LD_LIBRARY_PATH").unwrap_or_default();
    cached.is_some_and(|list| list.contains("libvulkan.so.1"))
        || env::split_paths(&named).any(|folder| folder.join("libvulkan.so.1").exists())
}

/// The places where the Vulkan loader itself looks ("Driver Discovery on Linux" in its LoaderDriverInterface.md).
fn has_driver() -> bool {
    let named = ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"].iter().find_map(env::var_os);
    if let Some(files) = named {
        return env::split_paths(&files).any(|path| path.exists());
    }
    let home = PathBuf::from(env::var_os("HOME").unwrap_or_default());
    let system = ["/etc", "/usr/local/etc", "/usr/local/share", "/usr/share"].map(PathBuf::from);
    let own = [home.join(".config"), home.join(".local/share")];
    system.iter().chain(&own).any(|folder| has_json(&folder.join("vulkan/icd.d")))
}

fn has_json(folder: &Path) -> bool {
    let entries = folder.read_dir().into_iter().flatten().flatten();
    entries.into_iter().any(|entry| entry.path().extension().is_some_and(|extension| extension == "json"))
}
