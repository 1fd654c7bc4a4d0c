//! Textures of a graph: one file each, or a set by naming pattern.
//!
//! `"granite": (set: "textures/granite")` declares a texture for every file of the set that exists or that a recipe
//! makes: `textures/granite_albedo.png` becomes `granite_albedo`, and so on, each with the colour space and channel of
//! its role. At least one must exist.

use super::fault::bad_path;
use super::images::Images;
use super::port::sorted;
use super::scope::{Scope, Target};
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::file::{Entry, Named, TextureEntry, TextureFiles};
use crate::graph::image::ImageHeader;
use crate::graph::model::{ColorSpace, Texture};
use crate::graph::{codes, path, suggest};

/// The members of a set: end of the file's name, colour space, the one channel that is meant.
const SET: [(&str, ColorSpace, Option<u8>); 8] = [
    ("albedo", ColorSpace::Srgb, None),
    ("emissive", ColorSpace::Srgb, None),
    ("height", ColorSpace::Linear, Some(0)),
    ("mask", ColorSpace::Linear, Some(0)),
    ("metallic", ColorSpace::Linear, Some(0)),
    ("normal", ColorSpace::Linear, None),
    ("occlusion", ColorSpace::Linear, Some(0)),
    ("roughness", ColorSpace::Linear, Some(0)),
];

/// A texture, and how many channels its image has.
pub(super) struct Declared {
    pub(super) texture: Texture,
    pub(super) channels: u8,
}

/// Declares the textures, sorted by name.
pub(super) fn textures(
    scope: &mut Scope<'_>,
    images: Images<'_>,
    entries: &[Entry<TextureEntry>],
    findings: &mut Vec<Diagnostic>,
) -> Vec<Declared> {
    let mut declared: Vec<Declared> = Vec::new();
    let mut names = Vec::new();
    for entry in sorted(entries) {
        let target = match entry.value.as_ref().map(|value| (value, &value.files)) {
            None => Target::Broken,
            Some((value, TextureFiles::One { file, color, channel })) => {
                match one(entry, value, file, (*color, *channel), images, findings) {
                    Some(found) => {
                        names.push(entry.name.clone());
                        declared.push(found);
                        continue;
                    }
                    None => Target::Broken,
                }
            }
            Some((value, TextureFiles::Set(base))) => {
                let members = set(entry, value, base, images, findings);
                let member_names: Vec<String> = members.iter().map(|member| member.texture.name.clone()).collect();
                names.extend(member_names.iter().map(|name| Named { name: name.clone(), span: entry.name.span }));
                declared.extend(members);
                if member_names.is_empty() { Target::Broken } else { Target::Set(member_names) }
            }
        };
        scope.declare(&entry.name, "texture", target, findings);
    }
    declared.sort_by(|a, b| a.texture.name.cmp(&b.texture.name));
    names.sort_by(|a, b| a.name.cmp(&b.name));
    for (index, name) in names.iter().enumerate() {
        scope.declare(name, "texture", Target::Texture(index), findings);
    }
    declared
}

fn one(
    entry: &Entry<TextureEntry>,
    value: &TextureEntry,
    file: &Named,
    (color, channel): (ColorSpace, Option<(u8, Span)>),
    images: Images<'_>,
    findings: &mut Vec<Diagnostic>,
) -> Option<Declared> {
    let (path, header) = images.find(file, findings)?;
    let suits = suits(&path, header, color, file.span, findings);
    if let Some((channel, span)) = channel
        && channel >= header.channels
    {
        let letters = ["only `r`", "", "`r`, `g`, `b`", "`r`, `g`, `b`, `a`"][usize::from(header.channels) - 1];
        let message = format!("`{path}` has no channel `{}`", ["r", "g", "b", "a"][usize::from(channel)]);
        findings.push(Diagnostic::error(codes::BAD_CHANNEL, span, message).help(format!("it has {letters}")));
        return None;
    }
    suits.then(|| {
        let channel = channel.map(|(channel, _)| channel);
        let texture = texture(entry.name.name.clone(), entry, value, path, header, (color, channel));
        Declared { texture, channels: header.channels }
    })
}

fn texture(
    name: String,
    entry: &Entry<TextureEntry>,
    value: &TextureEntry,
    file: String,
    header: ImageHeader,
    (color, channel): (ColorSpace, Option<u8>),
) -> Texture {
    let TextureEntry { wrap, filter, anisotropy, .. } = *value;
    let (size, depth, span) = (header.size, header.depth, entry.name.span);
    Texture { name, file, color, channel, wrap, filter, anisotropy, size, depth, span }
}

/// Whether the GPU formats that we use can hold an image for its use.
pub(super) fn suits(
    path: &str,
    header: ImageHeader,
    color: ColorSpace,
    span: Span,
    findings: &mut Vec<Diagnostic>,
) -> bool {
    let problem = match (header.depth, header.channels, color) {
        (16, _, ColorSpace::Srgb) => {
            Some((", used as a colour", "colours are 8 bit; heights and other data are `color: linear`"))
        }
        (16, 3.., ColorSpace::Linear) => Some((" with several channels", "16 bit images are grey, one channel each")),
        _ => None,
    };
    if let Some((what, help)) = problem {
        let message = format!("`{path}` is a 16 bit image{what}");
        findings.push(Diagnostic::error(codes::BAD_IMAGE, span, message).help(help));
    }
    problem.is_none()
}

fn set(
    entry: &Entry<TextureEntry>,
    value: &TextureEntry,
    base: &Named,
    images: Images<'_>,
    findings: &mut Vec<Diagnostic>,
) -> Vec<Declared> {
    let base_path = match path::normalise(&base.name) {
        Ok(path) => path,
        Err(why) => {
            findings.push(bad_path(&base.name, why, base.span));
            return Vec::new();
        }
    };
    let found: Vec<_> = SET.iter().filter(|(role, ..)| images.exists(&member_path(&base_path, role))).collect();
    if found.is_empty() {
        let ends: Vec<String> = SET.iter().map(|(role, ..)| member_path("", role)).collect();
        findings.push(
            Diagnostic::error(codes::EMPTY_SET, base.span, format!("no file of the set `{base_path}` exists"))
                .help(format!("a set is one or more files that begin so and end in {}", suggest::list(&ends))),
        );
    }
    let mut member = |(role, color, channel): &(&str, ColorSpace, Option<u8>)| {
        let file = Named { name: member_path(&base_path, role), span: base.span };
        let (path, header) = images.find(&file, findings)?;
        let suits = suits(&path, header, *color, base.span, findings);
        let name = format!("{}_{role}", entry.name.name);
        let texture = texture(name, entry, value, path, header, (*color, *channel));
        suits.then_some(Declared { texture, channels: header.channels })
    };
    found.into_iter().filter_map(&mut member).collect()
}

fn member_path(base: &str, role: &str) -> String {
    format!("{base}_{role}.png")
}
