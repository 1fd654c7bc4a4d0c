//! Textures of which one channel is meant.

use super::call::{Argument, Callable};
use super::wire::Operand;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::codes;
use crate::graph::model::{InputValue, Texture};
use crate::value::Type;

/// The channel that all textures of a call ask for.
pub(super) fn texture_channel(
    textures: &[Texture],
    arguments: &[Argument<'_>],
    callable: Callable<'_>,
    findings: &mut Vec<Diagnostic>,
) -> Option<(u8, Span)> {
    let texture = |argument: &Argument<'_>| match &argument.operand {
        Operand::Wire(wire) => match wire.value {
            InputValue::Texture(index) => Some((textures[index].channel, argument.span)),
            _ => None,
        },
        _ => None,
    };
    let given: Vec<(Option<u8>, Span)> = arguments.iter().filter_map(texture).collect();
    let (first, span) = *given.first()?;
    if let Callable::Instance(..) = callable {
        for (_, span) in given.iter().filter(|(channel, _)| channel.is_some()) {
            let message = "a texture with a `channel` goes into an instance, which reads whole texels";
            findings.push(
                Diagnostic::error(codes::BAD_CHANNEL, *span, message)
                    .help("declare it without `channel`, and pick the component inside: \"name.r\""),
            );
        }
        return None;
    }
    if let Some((_, other)) = given.iter().find(|(channel, _)| *channel != first) {
        let message = "the textures of one node ask for different channels";
        findings.push(Diagnostic::error(codes::BAD_CHANNEL, *other, message).also(span, "another channel here"));
    }
    first.map(|channel| (channel, span))
}

/// A node that does not return the texel does not return a channel of it either.
pub(super) fn ignored_channel(
    texture: Option<(u8, Span)>,
    callable: Callable<'_>,
    overload: usize,
    findings: &mut Vec<Diagnostic>,
) {
    let (Some((1.., span)), Callable::Kind(kind)) = (texture, callable) else { return };
    if kind.overloads[overload].output.ty != Type::Vec4 {
        let message = format!("`{}` decides itself which channel it reads: `channel` has no effect on it", kind.name);
        let help = "what reads one number of a texture reads the red channel";
        findings.push(Diagnostic::warning(codes::IGNORED_CHANNEL, span, message).help(help));
    }
}
