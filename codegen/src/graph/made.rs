//! The files that `terrane.ron` asks terrane to make.

use std::collections::BTreeMap;

use super::file::{Entry, MadeEntry, ProjectFile};
use super::image::ImageHeader;
use super::recipe::{Argument, Makes, RECIPES, Recipe, recipe};
use super::resolve::bad_path;
use super::syntax::Number;
use super::{codes, path, suggest};
use crate::diagnostic::{Diagnostic, Span};

/// A call of a recipe, checked and complete.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    /// The key in `terrane.ron`: a file, or the beginning of the names of several.
    pub path: String,
    /// What is called.
    pub recipe: &'static Recipe,
    /// Every argument of the recipe.
    pub arguments: BTreeMap<&'static str, f64>,
    /// What it makes, by path.
    pub files: Vec<(String, ImageHeader)>,
    /// The entry in the file.
    pub span: Span,
}

/// Checks every call against its recipe.
pub(super) fn made(file: &ProjectFile, findings: &mut Vec<Diagnostic>) -> Vec<Made> {
    let mut all: Vec<Made> = Vec::new();
    let mut makers: BTreeMap<String, Span> = BTreeMap::new();
    for entry in &file.made {
        let Some(made) = entry.value.as_ref().and_then(|call| one(entry, call, findings)) else { continue };
        for (file, _) in &made.files {
            if let Some(first) = makers.insert(file.clone(), entry.name.span) {
                let message = format!("`{file}` is made twice");
                let finding = Diagnostic::error(codes::MADE_TWICE, entry.name.span, message);
                findings.push(finding.also(first, "the first time here"));
            }
        }
        all.push(made);
    }
    all.sort_by(|a, b| a.path.cmp(&b.path));
    all
}

fn one(entry: &Entry<MadeEntry>, call: &MadeEntry, findings: &mut Vec<Diagnostic>) -> Option<Made> {
    let path = path::normalise(&entry.name.name)
        .map_err(|why| findings.push(bad_path(&entry.name.name, why, entry.name.span)))
        .ok();
    let recipe = recipe(&call.recipe.name);
    if recipe.is_none() {
        let message = format!("there is no recipe `{}`", call.recipe.name);
        let mut finding = Diagnostic::error(codes::UNKNOWN_RECIPE, call.recipe.span, message);
        finding.help = suggest::help(&call.recipe.name, RECIPES.iter().map(|recipe| recipe.name));
        findings.push(finding);
    }
    let (path, recipe) = (path?, recipe?);
    let arguments = arguments(recipe, call, findings)?;
    extension(&path, recipe, entry.name.span).map_err(|finding| findings.push(finding)).ok()?;
    let files = recipe.makes.files(&path, arguments["size"] as u32);
    Some(Made { path, recipe, arguments, files, span: entry.span })
}

fn extension(path: &str, recipe: &Recipe, span: Span) -> Result<(), Diagnostic> {
    let (message, help) = match (recipe.makes, path.ends_with(".png")) {
        (Makes::HeightMap, false) => (format!("`{path}` is no file of a height map"), format!("write \"{path}.png\"")),
        (Makes::Material, true) => {
            let base = path.trim_end_matches(".png");
            let files: Vec<String> = recipe.makes.files(base, 16).into_iter().map(|(file, _)| file).collect();
            (
                format!("`{}` makes several files", recipe.name),
                format!("write \"{base}\" for {}", suggest::list(&files)),
            )
        }
        _ => return Ok(()),
    };
    Err(Diagnostic::error(codes::WRONG_SHAPE, span, message).help(help))
}

fn arguments(
    recipe: &'static Recipe,
    call: &MadeEntry,
    findings: &mut Vec<Diagnostic>,
) -> Option<BTreeMap<&'static str, f64>> {
    let mut values: BTreeMap<&'static str, f64> =
        recipe.arguments.iter().map(|argument| (argument.name, argument.default)).collect();
    let before = findings.len();
    for (name, number) in &call.arguments {
        match recipe.arguments.iter().find(|argument| argument.name == name.name) {
            Some(argument) => {
                let value = argument_value(argument, number, findings);
                values.extend(value.map(|value| (argument.name, value)));
            }
            None => {
                let message = format!("`{}` has no argument `{}`", recipe.name, name.name);
                let mut finding = Diagnostic::error(codes::UNKNOWN_ARGUMENT, name.span, message);
                finding.help = suggest::help(&name.name, recipe.arguments.iter().map(|argument| argument.name));
                findings.push(finding);
            }
        }
    }
    (findings.len() == before).then_some(values)
}

fn argument_value(argument: &Argument, number: &Number, findings: &mut Vec<Diagnostic>) -> Option<f64> {
    let (low, high) = argument.range;
    if !(low..=high).contains(&number.value) {
        let message = format!("`{}` is {}, its range is {low}..{high}", argument.name, number.text);
        findings.push(Diagnostic::error(codes::OUT_OF_RANGE, number.span, message).help(argument.doc));
        return None;
    }
    if argument.whole && !number.is_whole() {
        let message = format!("`{}` is {}, it should be a whole number", argument.name, number.text);
        findings.push(Diagnostic::error(codes::LOSSY_NUMBER, number.span, message).help(argument.doc));
        return None;
    }
    Some(number.value)
}
