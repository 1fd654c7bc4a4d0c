//! No parameter, local or member has the name of a declaration of the library: what a text needs is found by its words
//! (`codegen/src/library/shake.rs`), so that a name in common drags in what nobody calls.

use terrane_shaderlib::hosts;

use super::LIBRARY;

/// The names that a text declares inside of its declarations: parameters, locals, members.
fn inner_names(text: &str) -> Vec<String> {
    let code: String =
        text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n");
    let mut found = Vec::new();
    let (mut depth, mut before, mut rest) = (0, "", code.as_str());
    while let Some(first) = rest.chars().next() {
        let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
        let length = rest.find(|letter| !is_part(letter)).unwrap_or(rest.len()).max(first.len_utf8());
        let (word, after) = rest.split_at(length);
        // `case NAME:` is the one place where a colon follows a name that is read.
        let typed = after.trim_start().starts_with(':') && before != "case";
        if depth > 0 && is_part(first) && (typed || ["let", "var", "const"].contains(&before)) {
            found.push(word.to_owned());
        }
        depth += i32::from("({".contains(first)) - i32::from(")}".contains(first));
        before = if word.trim().is_empty() { before } else { word };
        rest = after;
    }
    found
}

/// Each shadowing name of a text, after the name of what is searched.
fn shadows(what: &str, text: &str) -> Vec<String> {
    let names = inner_names(text).into_iter().filter(|name| LIBRARY.names.contains_key(name));
    names.map(|name| format!("{what} declares `{name}`, which the library declares as well")).collect()
}

#[test]
fn nothing_in_the_library_shadows_a_declaration() {
    let found: Vec<String> =
        LIBRARY.items.iter().enumerate().flat_map(|(at, item)| shadows(&item.name, LIBRARY.slice(at))).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn nothing_in_a_host_shadows_a_declaration() {
    let hosts = [
        hosts::WGPU_TERRAIN,
        hosts::WGPU_TERRAIN_DISPLACED,
        hosts::WGPU_TERRAIN_FURNISHED,
        hosts::WGPU_TERRAIN_DISPLACED_FURNISHED,
        hosts::WGPU_PREVIEW,
        hosts::WGPU_PREVIEW_DISPLACED,
        hosts::WGPU_SKY,
        hosts::WGPU_RESOLVE,
        hosts::WGPU_DEPTH,
        hosts::WGPU_RELIEF_BUILD,
    ];
    let found: Vec<String> = hosts.iter().copied().flatten().flat_map(|file| shadows(file.path, file.text)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_kind_of_shadow_is_found() {
    let planted = [
        "fn a(ramp: f32) -> f32 { return ramp; }",
        "fn a(x: f32, @location(0) ramp : f32) {}",
        "fn a() { let ramp = 1.0; }",
        "fn a() { for (var ramp: i32 = 0; ramp < 3; ramp++) {} }",
        "fn a() { const ramp = 1.0; }",
        "struct A {\n    // prose\n    ramp: f32,\n}",
    ];
    for text in planted {
        assert_eq!(shadows("a", text).len(), 1, "{text}");
    }
    let innocent =
        ["fn a() -> f32 { return ramp(1.0); } // let ramp", "const ramp: f32 = 1.0;", "switch x { case ramp: {} }"];
    for text in innocent {
        assert_eq!(shadows("a", text), Vec::<String>::new());
    }
}
