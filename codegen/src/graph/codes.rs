//! What can be wrong with a graph file: every code, once, with one line that says why it exists.

use crate::diagnostic::Code;

macro_rules! codes {
    ($($(#[$group:meta])* $constant:ident = $id:literal $name:literal $why:literal;)*) => {
        $(#[doc = $why] pub const $constant: Code = Code { id: $id, name: $name };)*

        /// Every code with its explanation, in the order of the ids.
        pub const ALL: &[(Code, &str)] = &[$(($constant, $why)),*];
    };
}

codes! {
    INVALID_RON = "TG100" "invalid-ron" "The text is not RON: the `ron` crate refuses it, and nothing in it can be read.";
    MISSING_FILE = "TG101" "missing-file" "A file that another one names, or that a command was given, does not exist and no recipe makes it.";
    UNREADABLE_FILE = "TG102" "unreadable-file" "A file exists and cannot be read: no permission, a folder, or not UTF-8.";
    ESCAPING_PATH = "TG103" "escaping-path" "A path leaves the project, or would mean different files on different systems.";
    WRONG_ROLE = "TG104" "wrong-role" "A file is used as something that it is not, such as a mask where a surface belongs.";
    UNSUPPORTED_VERSION = "TG105" "unsupported-version" "A file states a version of the format that this terrane does not read.";
    LIMIT = "TG106" "limit-exceeded" "A file is larger, deeper or more numerous than anybody needs; limits keep hostile input harmless.";
    UNKNOWN_FIELD = "TG107" "unknown-field" "A field that the format does not have: RON would ignore it silently, and so would hide a typing error.";
    MISSING_FIELD = "TG108" "missing-field" "A field that the format needs is not there.";
    DUPLICATE_KEY = "TG109" "duplicate-key" "A key occurs twice: RON would keep the last one silently.";
    WRONG_SHAPE = "TG110" "wrong-shape" "A value of another shape is expected here, such as a map where a number stands.";
    INVALID_NAME = "TG111" "invalid-name" "Names are `[a-z][a-z0-9_]*`: they become names in WGSL and must not hide RON's own words.";
    SHADOWING = "TG112" "shadowing" "Two things share a name; frame fields, parameters, textures, inputs and nodes live in one namespace.";
    NOT_FINITE = "TG113" "not-finite" "NaN and infinity: WGSL gives no meaning to them, and one such pixel spreads.";
    OVERFLOW = "TG114" "number-overflow" "A number is too large for the type that a shader computes with.";
    LOSSY_NUMBER = "TG115" "lossy-number" "A number cannot be held as it is written: a shader would silently compute with another one.";
    UNKNOWN_CHOICE = "TG116" "unknown-choice" "One of a few words is expected here, and this is none of them.";
    UNNAMED_ARGUMENT = "TG117" "unnamed-argument" "Arguments are named, always: their order in a kind may change.";
    NESTED_CALL = "TG118" "nested-call" "A call inside an argument: every node has a name, so that it can be reused, shown and reported.";
    UNKNOWN_KIND = "TG120" "unknown-kind" "A node calls something that is neither in the library nor an instance.";
    UNKNOWN_PORT = "TG121" "unknown-port" "An argument that the node does not take.";
    MISSING_INPUT = "TG122" "missing-input" "A node does not get an input that has no default.";
    UNKNOWN_NAME = "TG123" "unknown-name" "A reference to something that the file does not declare.";
    BAD_ACCESS = "TG124" "bad-access" "A member or swizzle that the value does not have.";
    TYPE_MISMATCH = "TG125" "type-mismatch" "A value of one type goes to an input of another.";
    NO_OVERLOAD = "TG126" "no-overload" "A node exists for several types, and for none of the combination that it gets.";
    UNIT_MISMATCH = "TG127" "unit-mismatch" "A value in one unit goes to an input in another: it would render, and be wrong everywhere.";
    OUT_OF_RANGE = "TG128" "out-of-range" "A number outside the range that its port, parameter or field declares.";
    CONST_PORT = "TG129" "const-port" "An input that shapes the code, such as a loop count, must be written as a number.";
    CYCLE = "TG130" "cycle" "A value depends on itself, directly or through instances.";
    AMBIGUOUS_OUTPUT = "TG131" "ambiguous-output" "An instance has several outputs, and a wire does not say which one it means.";
    KIND_CLASH = "TG132" "kind-clash" "An instance has the name of a node kind: what a call means would depend on where one looks first.";
    MISSING_OUTPUT = "TG133" "missing-output" "A graph does not give an output that it must give.";
    BAD_IMAGE = "TG140" "bad-image" "An image is not a PNG of a kind that its use can read.";
    BAD_CHANNEL = "TG141" "bad-channel" "A channel that the image does not have, or that a node cannot choose.";
    EMPTY_SET = "TG142" "empty-set" "A set of textures of which not one file exists.";
    UNKNOWN_RECIPE = "TG143" "unknown-recipe" "`terrane.ron` asks for a recipe that does not exist.";
    UNKNOWN_ARGUMENT = "TG144" "unknown-argument" "A recipe gets an argument that it does not take.";
    MADE_TWICE = "TG145" "made-twice" "Two recipes make the same file.";
    UNKNOWN_PARAMETER = "TG146" "unknown-parameter" "A layer sets a parameter that its surface does not have.";
    UNUSED_NODE = "TG150" "unused-node" "Nothing that is drawn depends on a node.";
    UNUSED_PARAMETER = "TG151" "unused-parameter" "A parameter that nothing reads: moving its slider would do nothing.";
    UNUSED_TEXTURE = "TG152" "unused-texture" "A texture that nothing reads.";
    UNUSED_INPUT = "TG153" "unused-input" "An input of an instance that nothing in it reads.";
    IGNORED_CHANNEL = "TG154" "ignored-channel" "A texture's `channel` goes to a node that decides itself which channel it reads.";
    RELIEF_NOT_TRACED = "TG155" "relief-not-traced" "Something of a relief is asked for that no tracer does: the picture would show something else.";
    NO_PROJECT = "TG160" "no-project" "No folder on the way up holds a `terrane.ron`, so that no path can be found.";
}

#[cfg(test)]
mod tests {
    use super::ALL;

    #[test]
    fn ids_and_names_are_unique_and_in_order() {
        assert!(ALL.windows(2).all(|pair| pair[0].0.id < pair[1].0.id));
        let names: std::collections::BTreeSet<_> = ALL.iter().map(|(code, _)| code.name).collect();
        assert_eq!(names.len(), ALL.len());
    }

    #[test]
    fn explanations_are_sentences() {
        assert!(ALL.iter().all(|(_, why)| why.ends_with('.') && why.len() > 20));
    }
}
