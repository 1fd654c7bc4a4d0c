//! x
use std::{fs, path::{Path, PathBuf}};
fn walk(d: &Path, out: &mut Vec<PathBuf>) { let mut v: Vec<_> = fs::read_dir(d).unwrap().map(|e| e.unwrap().path()).collect(); v.sort(); for p in v { if p.is_dir() { walk(&p, out) } else { out.push(p) } } }
fn main() {
    let root = PathBuf::from("/tmp/wt/library/shaderlib/wgsl");
    let mut files = vec![]; walk(&root, &mut files); files.sort();
    let mut sources = terrane_codegen::diagnostic::Sources::default();
    let list: Vec<_> = files.iter().map(|f| (f.strip_prefix(&root).unwrap().to_str().unwrap().to_owned(), fs::read_to_string(f).unwrap())).collect();
    match terrane_codegen::library::Library::from_files(&mut sources, list) {
        Ok(l) => { println!("{} kinds", l.kinds.len());
          for k in l.kinds.values() { for o in &k.overloads { for p in o.inputs.iter().chain([&o.output]).chain(&o.members) {
            if p.range.is_none() && !matches!(p.ty, terrane_codegen::value::Type::Struct(_) | terrane_codegen::value::Type::Texture) && !(p.ty == terrane_codegen::value::Type::U32) { println!("no range: {} {} {}", o.function, p.name, p.doc); } } } } }
        Err(e) => { eprintln!("{}", terrane_codegen::diagnostic::render(&e, &sources, false)); std::process::exit(1) }
    }
}
