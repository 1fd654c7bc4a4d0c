//! A program that carries its terrain material in itself: WGSL and manifest, made by its build script.

/// The functions and structs of the material: join them to your own shader.
const CORE: &str = include_str!(concat!(env!("OUT_DIR"), "/terrain.wgsl"));
/// What to bind, and what to give to `terrane_surface`.
const MANIFEST: &str = include_str!(concat!(env!("OUT_DIR"), "/terrain.json"));

fn main() {
    println!("{CORE}");
    eprintln!("{} lines of WGSL, {} bytes of manifest", CORE.lines().count(), MANIFEST.len());
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_core_stands_alone() {
        let module = naga::front::wgsl::parse_str(super::CORE).unwrap();
        assert!(module.functions.iter().any(|(_, function)| function.name.as_deref() == Some("terrane_surface")));
        assert!(module.entry_points.is_empty() && module.global_variables.is_empty());
    }
}
