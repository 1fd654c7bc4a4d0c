//! naga's verdict on emitted text. A refusal is a diagnostic on the graph node that the text came from.

use std::ops::Range;

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::diagnostic::{Code, Diagnostic, SourceId, Span};
use crate::emit::{Place, Shader};
use crate::library::Library;
use crate::program::Program;

/// naga refuses what was emitted for a node.
pub const REFUSED: Code = Code { id: "TG200", name: "refused-by-naga" };

/// A text that naga accepts, as naga sees it.
#[derive(Debug)]
pub struct Checked {
    /// The parsed text.
    pub module: naga::Module,
    /// What the validator found out.
    pub info: ModuleInfo,
}

/// Parses and validates.
///
/// # Errors
/// One diagnostic at the node, layer or library function that naga names most narrowly.
pub fn check(shader: &Shader, library: &Library, program: &Program) -> Result<Checked, Diagnostic> {
    let blame = |ranges: Vec<Range<usize>>, message: String| {
        let place = narrowest(shader, ranges);
        let (span, what) = culprit(place, library, program);
        Diagnostic::error(REFUSED, span, format!("naga refuses the WGSL of {what}"))
            .note(message)
            .help("this is a defect of the node's WGSL or of Terrane, not of the graph: please report it")
    };
    let module = naga::front::wgsl::parse_str(&shader.text).map_err(|error| {
        let ranges = error.labels().filter_map(|(span, _)| span.to_range()).collect();
        blame(ranges, error.message().to_owned())
    })?;
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    let info = validator.validate(&module).map_err(|error| {
        let ranges = error.spans().filter_map(|(span, _)| span.to_range()).collect();
        blame(ranges, crate::library::causes(error.as_inner()))
    })?;
    Ok(Checked { module, info })
}

/// naga's spans are coarse: the whole function is a label too. The shortest one that lies in mapped text counts.
fn narrowest(shader: &Shader, mut ranges: Vec<Range<usize>>) -> Option<Place> {
    ranges.sort_by_key(Range::len);
    ranges.into_iter().find_map(|range| shader.place(range.start))
}

fn culprit(place: Option<Place>, library: &Library, program: &Program) -> (Span, String) {
    let nowhere = Span { source: SourceId(0), start: 0, end: 0 };
    match place {
        Some(Place::Value(id)) => match program.pool.origins(id).first() {
            Some(origin) => (origin.span, format!("node `{}`", origin.path)),
            None => (nowhere, "a value without a node".into()),
        },
        Some(Place::Layer(layer)) => (program.layers[layer].span, format!("layer `{}`", program.layers[layer].name)),
        Some(Place::Item(item)) => {
            let item = &library.items[item];
            (library.span(item.name_range.clone()), format!("library function `{}`", item.name))
        }
        None => (nowhere, "the composition".into()),
    }
}
