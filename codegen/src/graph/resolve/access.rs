//! Members and swizzles behind a reference.

use super::wire::Wire;
use crate::diagnostic::Diagnostic;
use crate::graph::file::Named;
use crate::graph::model::Access;
use crate::graph::{codes, suggest};
use crate::library::{Library, Port};
use crate::value::Type;

/// Follows one step.
///
/// # Errors
/// If the value has no such part.
pub(super) fn step(library: &Library, mut wire: Wire, part: &Named) -> Result<Wire, Diagnostic> {
    match &wire.ty {
        Type::Struct(name) => {
            let members = library.structs.get(name).map(Vec::as_slice).unwrap_or_default();
            let member = members.iter().find(|member| member.name == part.name);
            let member = member.ok_or_else(|| no_member(name, members, part))?;
            wire.access.push(Access::Member(part.name.clone()));
            (wire.ty, wire.unit) = (member.ty.clone(), member.unit.clone());
        }
        Type::Vec2 | Type::Vec3 | Type::Vec4 => {
            let swizzle = swizzle(&wire.ty, part)?;
            wire.ty = Type::floats(swizzle.len()).unwrap_or(Type::F32);
            wire.access.push(Access::Swizzle(swizzle));
        }
        Type::F32 | Type::I32 | Type::U32 => {
            let message = format!("`{}` is asked of a plain {}", part.name, wire.ty);
            return Err(Diagnostic::error(codes::BAD_ACCESS, part.span, message)
                .help(format!("it is one number already: leave out `.{}`", part.name)));
        }
        Type::Texture => {
            let message = format!("`{}` is asked of a texture", part.name);
            return Err(Diagnostic::error(codes::BAD_ACCESS, part.span, message)
                .help("a texture is read by a node; its result has channels"));
        }
    }
    Ok(wire)
}

fn no_member(name: &str, members: &[Port], part: &Named) -> Diagnostic {
    let message = format!("a {name} has no member `{}`", part.name);
    let mut finding = Diagnostic::error(codes::BAD_ACCESS, part.span, message);
    finding.help = suggest::help(&part.name, members.iter().map(|member| member.name.as_str()));
    finding
}

/// The components in letters `xyzw`.
fn swizzle(ty: &Type, part: &Named) -> Result<String, Diagnostic> {
    let count = ty.components().unwrap_or(0);
    let alphabet = |letters: &'static str| move |letter: char| letters.find(letter);
    let read = |letters| part.name.chars().map(alphabet(letters)).collect::<Option<Vec<usize>>>();
    let refuse = |help: String| {
        let message = format!("`{}` is no part of a {ty}", part.name);
        Err(Diagnostic::error(codes::BAD_ACCESS, part.span, message).help(help))
    };
    let Some(indices) = read("xyzw").or_else(|| read("rgba")) else {
        return refuse(format!("write letters of `{}` or of `{}`", &"xyzw"[..count], &"rgba"[..count]));
    };
    if indices.len() > 4 {
        return refuse("a vector has at most four components".into());
    }
    if indices.iter().any(|index| *index >= count) {
        return refuse(format!("it has {count} components: `{}` or `{}`", &"xyzw"[..count], &"rgba"[..count]));
    }
    Ok(indices.into_iter().map(|index| ['x', 'y', 'z', 'w'][index]).collect())
}
