//! Textures as they are written.

use super::Named;
use crate::diagnostic::{Diagnostic, Span};
use crate::graph::model::{ColorSpace, Filter, Wrap};
use crate::graph::syntax::{Field, Fields};

/// One texture, or a set of them by naming pattern.
#[derive(Clone, Debug)]
pub(crate) struct TextureEntry {
    pub(crate) files: TextureFiles,
    pub(crate) wrap: Wrap,
    pub(crate) filter: Filter,
    pub(crate) anisotropy: u8,
}

/// Where the images are.
#[derive(Clone, Debug)]
pub(crate) enum TextureFiles {
    /// `file:`, with how to read it.
    One { file: Named, color: ColorSpace, channel: Option<(u8, Span)> },
    /// `set:`, the path up to `_albedo.png`.
    Set(Named),
}

/// Reads a texture or a set.
pub(super) fn texture(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<TextureEntry> {
    let mut fields = Fields::open(field.raw, "a texture", findings)?;
    let colors = [("srgb", ColorSpace::Srgb), ("linear", ColorSpace::Linear)];
    let channels = [("r", 0), ("g", 1), ("b", 2), ("a", 3)];
    let wraps = [("repeat", Wrap::Repeat), ("clamp", Wrap::Clamp), ("mirror", Wrap::Mirror)];
    let filters = [("linear", Filter::Linear), ("nearest", Filter::Nearest)];
    let wrap = fields.take("wrap").map_or(Some(Wrap::Repeat), |field| field.choice(&wraps, findings));
    let filter = fields.take("filter").map_or(Some(Filter::Linear), |field| field.choice(&filters, findings));
    let anisotropy = fields.take("anisotropy").map_or(Some(1), |field| field.whole(1, 16, findings));
    let set = fields.take("set");
    fields.what = if set.is_some() { "a set of textures" } else { fields.what };
    let files = if let Some(set) = set {
        set.text(findings).map(|path| TextureFiles::Set(Named::new(&path, set.raw.span())))
    } else {
        let file = fields.need("file", findings);
        let file = file.and_then(|field| Some(Named::new(&field.text(findings)?, field.raw.span())));
        let color = fields.need("color", findings).and_then(|field| field.choice(&colors, findings));
        let channel = fields.take("channel").map(|field| Some((field.choice(&channels, findings)?, field.raw.span())));
        // Unreadable is not the same as absent.
        let channel = channel.map_or(Some(None), |found| found.map(Some));
        file.zip(color).zip(channel).map(|((file, color), channel)| TextureFiles::One { file, color, channel })
    };
    fields.close(findings);
    Some(TextureEntry { files: files?, wrap: wrap?, filter: filter?, anisotropy: anisotropy? as u8 })
}
