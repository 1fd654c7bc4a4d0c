//! From declarations to node kinds, and every rule that a node file must keep.

use std::ops::Range;

use naga::{Handle, TypeInner};

use super::item::{Entry, Item, entries};
use super::kind::{Example, Kind, Overload, Port};
use super::port_line::{self, PortLine};
use super::token::{Token, tokens};
use super::{Library, LibraryFile, codes};
use crate::diagnostic::{Code, Diagnostic};
use crate::value::Type;

/// Suffixes that make a function an overload of its file's kind.
const SUFFIXES: [&str; 6] = ["f32", "vec2", "vec3", "vec4", "i32", "u32"];

/// Fills `kinds` and `structs`; gives what is wrong.
pub(super) fn read(library: &mut Library) -> Vec<Diagnostic> {
    let mut reader = Reader { library, findings: Vec::new() };
    let structs: Vec<_> = reader.library.items.iter().filter(|item| item.keyword == "struct").cloned().collect();
    for item in structs {
        let members = reader.members(&item);
        reader.library.structs.insert(item.name.clone(), members);
    }
    for file in reader.library.files.clone() {
        reader.file(&file);
    }
    reader.findings
}

struct Reader<'a> {
    library: &'a mut Library,
    findings: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn error(&mut self, code: Code, range: Range<usize>, message: impl Into<String>, help: &str) {
        let span = self.library.span(range);
        self.findings.push(Diagnostic::error(code, span, message).help(help));
    }

    fn file(&mut self, file: &LibraryFile) {
        let items: Vec<Item> =
            self.library.items.iter().filter(|item| within(&item.range, &file.range)).cloned().collect();
        let (category, stem) = category_and_stem(&file.path);
        for item in &items {
            self.declaration(item, stem);
        }
        let is_node = |item: &&Item| item.keyword == "fn" && is_node_function(&item.name, stem);
        let functions: Vec<Item> = items.iter().filter(is_node).cloned().collect();
        if !functions.is_empty() {
            self.kind(file, category, stem, &functions);
        }
    }

    fn declaration(&mut self, item: &Item, stem: &str) {
        if !matches!(item.keyword.as_str(), "fn" | "struct" | "const" | "alias") {
            let message = format!("a library file declares `{}`", item.keyword);
            self.error(
                codes::FOREIGN_DECLARATION,
                item.name_range.clone(),
                message,
                "only functions, structs, constants and aliases: resources are arguments",
            );
        }
        let flat = item.name.to_lowercase().replace('_', "");
        if !flat.starts_with(&stem.replace('_', "")) {
            let message = format!("`{}` does not begin with `{stem}`", item.name);
            self.error(
                codes::NAME_WITHOUT_STEM,
                item.name_range.clone(),
                message,
                "all files share one namespace: begin every name with the stem of its file",
            );
        }
    }

    fn kind(&mut self, file: &LibraryFile, category: &str, stem: &str, functions: &[Item]) {
        let (lines, source) = file_doc(&self.library.text, file);
        let doc = lines.join("\n");
        let prose = lines.join(" ");
        let summary = prose.split_once(". ").map_or(prose.as_str(), |(first, _)| first);
        let overloads: Vec<Overload> = functions.iter().filter_map(|item| self.overload(item)).collect();
        let examples: Vec<Example> = functions.iter().flat_map(|item| self.examples(item)).collect();
        let place = functions[0].name_range.clone();
        if summary.is_empty() {
            self.error(
                codes::NODE_UNDOCUMENTED,
                place.clone(),
                format!("node `{stem}` has no `//!` line"),
                "say in one sentence what it does, at the top of the file",
            );
        }
        if source.is_empty() {
            self.error(
                codes::NODE_UNDOCUMENTED,
                place.clone(),
                format!("node `{stem}` has no source"),
                "add a line `//! Source: …` that names the paper, section or listing",
            );
        }
        if examples.is_empty() {
            self.error(
                codes::NODE_UNDOCUMENTED,
                place,
                format!("node `{stem}` has no example"),
                "add a line `/// name(…) == value +- tolerance` above the function",
            );
        }
        let summary = summary.trim_end_matches('.').to_owned() + ".";
        let kind = Kind { name: stem.into(), category: category.into(), summary, doc, source, overloads, examples };
        self.library.kinds.insert(stem.into(), kind);
    }

    fn overload(&mut self, item: &Item) -> Option<Overload> {
        let (_, function) =
            self.library.module.functions.iter().find(|(_, function)| function.name.as_deref() == Some(&item.name))?;
        let types: Vec<Handle<naga::Type>> = function.arguments.iter().map(|argument| argument.ty).collect();
        let names: Vec<Option<String>> = function.arguments.iter().map(|argument| argument.name.clone()).collect();
        let result = function.result.as_ref().map(|result| result.ty);
        let scanned = entries(&self.library.text, item.list.clone());
        let agree = scanned.len() == names.len()
            && scanned.iter().zip(&names).all(|(entry, name)| name.as_deref() == Some(&entry.name));
        if !agree {
            self.error(
                codes::PORT_UNDOCUMENTED,
                item.name_range.clone(),
                format!("the parameters of `{}` could not be read", item.name),
                "one parameter a line, its `///` line above it",
            );
            return None;
        }
        let inputs = self.inputs(&scanned, &types);
        let output = self.output(item, result)?;
        let members = match &output.ty {
            Type::Struct(name) => self.library.structs.get(name).cloned().unwrap_or_default(),
            _ => Vec::new(),
        };
        let doc =
            item.doc.iter().map(|(line, _)| line.as_str()).filter(|line| !line.starts_with("->") && !is_example(line));
        let doc = doc.collect::<Vec<_>>().join("\n");
        Some(Overload {
            function: item.name.clone(),
            doc,
            inputs,
            output,
            members,
            span: self.library.span(item.name_range.clone()),
        })
    }

    /// A texture port `of` is three parameters: `of_texture` (`of` alone is reserved in WGSL), `of_sampler`, `of_layer`.
    fn inputs(&mut self, scanned: &[Entry], types: &[Handle<naga::Type>]) -> Vec<Port> {
        let mut ports = Vec::new();
        let mut index = 0;
        while index < scanned.len() {
            let mut entry = scanned[index].clone();
            index += 1;
            let Some(ty) = self.port_type(types[index - 1], &entry) else { continue };
            if ty == Type::Texture {
                let parameter = entry.name.clone();
                entry.name = parameter.strip_suffix("_texture").unwrap_or_default().to_owned();
                let names: Vec<_> = scanned[index..].iter().take(2).map(|entry| entry.name.clone()).collect();
                let companions = [format!("{}_sampler", entry.name), format!("{}_layer", entry.name)];
                if entry.name.is_empty() || names != companions {
                    self.error(
                        codes::PORT_TYPE,
                        entry.name_range.clone(),
                        format!("`{parameter}` is no texture port"),
                        "declare `NAME_texture: texture_2d_array<f32>, NAME_sampler: sampler, NAME_layer: i32` in this order",
                    );
                }
                index += 2;
            }
            ports.extend(self.port(&entry, ty));
        }
        ports
    }

    fn port(&mut self, entry: &Entry, ty: Type) -> Option<Port> {
        let line = match port_line::parse(&entry.doc) {
            Ok(line) => line,
            Err(problem) => {
                let message = format!("port `{}`: {problem}", entry.name);
                self.error(
                    codes::PORT_UNDOCUMENTED,
                    entry.name_range.clone(),
                    message,
                    "for example `/// How much of it. 0..1 = 1.0`",
                );
                return None;
            }
        };
        let default = line.default.as_ref().map(|values| port_line::literal(values, &ty));
        let outside = |value: f32| line.range.is_some_and(|(low, high)| value < low || value > high);
        if default == Some(None) || default.flatten().is_some_and(|literal| literal.values().into_iter().any(outside)) {
            let message = format!("the default of `{}` is no {ty} in its range", entry.name);
            self.error(codes::PORT_DEFAULT, entry.name_range.clone(), message, "a number, or `(x, y, z)` for a vector");
        }
        let PortLine { doc, unit, constant, range, .. } = line;
        Some(Port { name: entry.name.clone(), ty, doc, unit, range, default: default.flatten(), constant })
    }

    fn output(&mut self, item: &Item, result: Option<Handle<naga::Type>>) -> Option<Port> {
        let line = item.doc.iter().find_map(|(line, _)| line.strip_prefix("->")).unwrap_or_default().trim().to_owned();
        let entry = Entry { name: String::new(), name_range: item.name_range.clone(), doc: line };
        let Some(result) = result else {
            self.error(
                codes::PORT_TYPE,
                item.name_range.clone(),
                format!("node `{}` returns nothing", item.name),
                "a node has a result",
            );
            return None;
        };
        let ty = self.port_type(result, &entry)?;
        // The members of a struct say everything.
        if matches!(ty, Type::Struct(_)) && entry.doc.is_empty() {
            return Some(Port {
                name: String::new(),
                ty,
                doc: String::new(),
                unit: None,
                range: None,
                default: None,
                constant: false,
            });
        }
        self.port(&entry, ty)
    }

    fn members(&mut self, item: &Item) -> Vec<Port> {
        let found = self.library.module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(&item.name));
        let Some(TypeInner::Struct { members, .. }) = found.map(|(_, ty)| ty.inner.clone()) else { return Vec::new() };
        let scanned = entries(&self.library.text, item.list.clone());
        let pairs: Vec<_> = scanned.iter().zip(members).collect();
        pairs
            .into_iter()
            .filter_map(|(entry, member)| {
                let ty = self.member_type(member.ty)?;
                self.port(entry, ty)
            })
            .collect()
    }

    fn port_type(&mut self, handle: Handle<naga::Type>, entry: &Entry) -> Option<Type> {
        let ty = wire_type(&self.library.module, handle);
        if ty.is_none() {
            let message = format!("`{}` has a type that cannot flow along a wire", entry.name);
            self.error(
                codes::PORT_TYPE,
                entry.name_range.clone(),
                message,
                "f32, i32, u32, vec2f, vec3f, vec4f, a struct, or texture_2d_array<f32>",
            );
        }
        ty
    }

    /// Members that no wire can carry (a lattice's `vec2i`) stay inside the library.
    fn member_type(&mut self, handle: Handle<naga::Type>) -> Option<Type> {
        wire_type(&self.library.module, handle)
    }

    fn examples(&mut self, item: &Item) -> Vec<Example> {
        let lines = item.doc.iter().filter(|(line, _)| is_example(line));
        let parsed: Vec<_> = lines.map(|(line, range)| (example(line), range.clone())).collect();
        let mut found = Vec::new();
        for (parts, range) in parsed {
            match parts {
                Some((call, expected, tolerance)) => {
                    found.push(Example { call, expected, tolerance, span: self.library.span(range) })
                }
                None => self.error(
                    codes::NODE_UNDOCUMENTED,
                    range,
                    "this example cannot be read",
                    "write `call == value +- tolerance`",
                ),
            }
        }
        found
    }
}

fn within(inner: &Range<usize>, outer: &Range<usize>) -> bool {
    outer.start <= inner.start && inner.end <= outer.end
}

fn category_and_stem(path: &str) -> (&str, &str) {
    let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
    (folder.rsplit('/').next().unwrap_or(folder), file.strip_suffix(".wgsl").unwrap_or(file))
}

fn is_node_function(name: &str, stem: &str) -> bool {
    name == stem
        || name
            .strip_prefix(stem)
            .and_then(|rest| rest.strip_prefix('_'))
            .is_some_and(|suffix| SUFFIXES.contains(&suffix))
}

fn is_example(line: &str) -> bool {
    line.contains("==") && line.contains("+-")
}

fn example(line: &str) -> Option<(String, String, f64)> {
    let (call, rest) = line.split_once("==")?;
    let (expected, tolerance) = rest.rsplit_once("+-")?;
    Some((call.trim().into(), expected.trim().into(), tolerance.trim().parse().ok()?))
}

/// The `//!` lines of a file, and what its source line says.
fn file_doc(text: &str, file: &LibraryFile) -> (Vec<String>, String) {
    let text = &text[file.range.clone()];
    let docs = tokens(text).into_iter().filter(|(token, _)| *token == Token::FileDoc);
    let lines = docs.map(|(_, range)| text[range.start + 3..range.end].trim().to_owned());
    let (mut doc, mut source, mut in_source) = (Vec::new(), Vec::new(), false);
    for line in lines {
        if let Some(first) = line.strip_prefix("Source:") {
            in_source = true;
            source.push(first.trim().to_owned());
        } else if in_source {
            source.push(line);
        } else {
            doc.push(line);
        }
    }
    (doc, source.join(" ").trim().to_owned())
}

fn wire_type(module: &naga::Module, handle: Handle<naga::Type>) -> Option<Type> {
    use naga::{ImageClass, ImageDimension, Scalar, ScalarKind, VectorSize};
    let ty = &module.types[handle];
    Some(match ty.inner {
        TypeInner::Scalar(Scalar::F32) => Type::F32,
        TypeInner::Scalar(Scalar::I32) => Type::I32,
        TypeInner::Scalar(Scalar::U32) => Type::U32,
        TypeInner::Vector { size: VectorSize::Bi, scalar: Scalar::F32 } => Type::Vec2,
        TypeInner::Vector { size: VectorSize::Tri, scalar: Scalar::F32 } => Type::Vec3,
        TypeInner::Vector { size: VectorSize::Quad, scalar: Scalar::F32 } => Type::Vec4,
        TypeInner::Struct { .. } => Type::Struct(ty.name.clone()?),
        TypeInner::Image {
            dim: ImageDimension::D2,
            arrayed: true,
            class: ImageClass::Sampled { kind: ScalarKind::Float, multi: false },
        } => Type::Texture,
        _ => return None,
    })
}
