//! How layers meet, as WGSL statements.

use super::names::{Names, layer_word};
use super::text::{Place, Shader};
use crate::graph::model::Blend;
use crate::patch::{Scope, Specialization};
use crate::program::{Program, ProgramLayer, ValueId};
use crate::value::Literal;

/// Writes the body of `terrane_surface`.
pub(super) struct Composer<'a> {
    pub(super) program: &'a Program,
    pub(super) patch: &'a Specialization,
    pub(super) names: &'a Names<'a>,
    pub(super) shader: &'a mut Shader,
}

/// The members of `TerrainOut`, in order.
pub(super) const OUTPUTS: [&str; 6] = ["albedo", "normal", "roughness", "metallic", "occlusion", "emissive"];

impl Composer<'_> {
    /// Every statement of the body.
    pub(super) fn body(&mut self) {
        self.values(Scope::Root);
        if self.patch.layers.len() > 1 {
            self.sums();
            match self.program.blend {
                Blend::Over => self.over(),
                Blend::HeightMax | Blend::HeightSoft { .. } => self.by_height(),
            }
            self.shader.line("");
        }
        self.result();
    }

    fn layer(&self, index: usize) -> &ProgramLayer {
        &self.program.layers[self.patch.layers[index]]
    }

    fn word(&self, index: usize, word: &str) -> String {
        layer_word(&self.layer(index).name, word)
    }

    /// The values that stand in a scope, those that a later block reads as assignments.
    fn values(&mut self, scope: Scope) {
        let pool = &self.program.pool;
        let exports = if scope == Scope::Root { Vec::new() } else { self.exports(scope) };
        for id in self.patch.scopes.values(pool, scope) {
            let keyword = if exports.contains(&id) { "" } else { "let " };
            let line = format!("{keyword}{} = {};", self.names.name(id), self.names.expression(id));
            self.shader.mapped(Place::Value(id), &line);
        }
    }

    /// Only weighing and painting are blocks apart; every other scope holds those that read from it.
    fn exports(&self, scope: Scope) -> Vec<ValueId> {
        match scope {
            Scope::Weigh(_) => self.patch.scopes.exports(&self.program.pool, scope),
            _ => Vec::new(),
        }
    }

    /// The variables that layers add to.
    fn sums(&mut self) {
        self.shader.line("");
        for name in OUTPUTS.iter().filter(|name| self.patch.blended.contains(*name)) {
            let line = match *name {
                "albedo" | "emissive" => format!("var {name} = vec3f(0.0f);"),
                "normal" => "var slopes = vec2f(0.0f);".to_owned(),
                name => format!("var {name} = 0.0f;"),
            };
            self.shader.line(&line);
        }
        self.shader.line("var weight = 0.0f;");
    }

    fn head(&mut self, index: usize) {
        let layer = self.layer(index);
        let line = format!("// {}: {}", layer.name, layer.path);
        self.shader.line("");
        self.shader.line(&line);
    }

    /// `saturate(mask)`, or the literal itself.
    fn mask(&self, index: usize) -> String {
        let mask = self.layer(index).mask;
        let in_range = |literal: Literal| literal.values().iter().all(|value| (0.0..=1.0).contains(value));
        match self.program.pool.literal(mask) {
            Some(literal) if in_range(literal) => literal.wgsl(),
            _ => format!("saturate({})", self.names.read(mask)),
        }
    }

    /// From the top: each layer takes its part of what is left, and nothing is asked of layers that are covered.
    fn over(&mut self) {
        let count = self.patch.layers.len();
        let mut left: Option<String> = None;
        for index in (1..count).rev() {
            self.head(index);
            self.values(Scope::Cover(index));
            let (weight, under) = (self.word(index, "weight"), self.word(index, "under"));
            let mask = self.mask(index);
            let share = left.as_ref().map_or(mask.clone(), |left| format!("{left} * {mask}"));
            let rest = left.as_deref().unwrap_or("1.0f");
            self.line(index, &format!("let {weight} = {share};"));
            self.guarded(&format!("{weight} > TERRANE_VISIBLE"), |composer| composer.paint(index, &weight));
            self.line(index, &format!("let {under} = {rest} - {weight};"));
            if self.patch.guard {
                self.shader.open(&format!("if {under} > TERRANE_VISIBLE"));
            }
            left = Some(under);
        }
        self.head(0);
        self.values(Scope::Cover(0));
        let left = left.unwrap_or_default();
        self.paint(0, &left);
        if self.patch.guard {
            (1..count).for_each(|_| self.shader.close());
        }
    }

    /// Shares of all layers, then heights, then looks: who shows is known only when all heights are.
    fn by_height(&mut self) {
        self.shares();
        let count = self.patch.layers.len();
        (0..count).rev().for_each(|index| self.weigh(index));
        self.weights();
        for index in (0..count).rev() {
            self.head(index);
            let weight = self.word(index, "weight");
            self.guarded(&format!("{weight} > TERRANE_VISIBLE"), |composer| {
                composer.values(Scope::Paint(index));
                composer.add(index, &weight);
            });
        }
    }

    /// The part of the ground that each layer covers.
    pub(super) fn shares(&mut self) {
        self.shader.line("");
        self.shader.line("// The part of the ground that each layer covers, from the top.");
        let mut left: Option<String> = None;
        for index in (1..self.patch.layers.len()).rev() {
            let (share, under) = (self.word(index, "share"), self.word(index, "under"));
            let mask = self.mask(index);
            let part = left.as_ref().map_or(mask.clone(), |left| format!("{left} * {mask}"));
            let rest = left.as_deref().unwrap_or("1.0f");
            self.line(index, &format!("let {share} = {part};"));
            self.line(index, &format!("let {under} = {rest} - {share};"));
            left = Some(under);
        }
        let share = self.word(0, "share");
        self.line(0, &format!("let {share} = {};", left.unwrap_or_default()));
    }

    fn weigh(&mut self, index: usize) {
        let (share, score) = (self.word(index, "share"), self.word(index, "score"));
        let function = if self.program.blend == Blend::HeightMax { "layer_max_score" } else { "layer_soft_score" };
        let value = format!("{function}({share}, {})", self.names.read(self.layer(index).outputs["height"]));
        let scope = Scope::Weigh(index);
        if !self.patch.guard || self.patch.scopes.values(&self.program.pool, scope).is_empty() {
            self.line(index, &format!("let {score} = {value};"));
            return;
        }
        self.shader.line("");
        for export in self.exports(scope) {
            let line = self.names.variable(export);
            self.shader.mapped(Place::Value(export), &line);
        }
        self.line(index, &format!("var {score} = LAYER_ABSENT;"));
        self.shader.open(&format!("if {share} > TERRANE_VISIBLE"));
        self.values(scope);
        self.line(index, &format!("{score} = {value};"));
        self.shader.close();
    }

    fn weights(&mut self) {
        let count = self.patch.layers.len();
        let words = |composer: &Self, word: &str| -> Vec<String> {
            (0..count).map(|index| composer.word(index, word)).collect()
        };
        let (scores, weights) = (words(self, "score"), words(self, "weight"));
        self.shader.line("");
        if let Blend::HeightSoft { band } = self.program.blend {
            let highest = scores[1..].iter().fold(scores[0].clone(), |all, score| format!("max({all}, {score})"));
            self.shader.line(&format!("let highest_score = {highest};"));
            for index in (0..count).rev() {
                let (share, score) = (self.word(index, "share"), &scores[index]);
                let band = Literal::f32(band).wgsl();
                self.line(
                    index,
                    &format!(
                        "let {}_raw = layer_soft_weight({share}, {score}, highest_score, {band});",
                        weights[index]
                    ),
                );
            }
        } else {
            for index in (0..count).rev() {
                self.line(index, &format!("let {}_raw = layer_max_weight({});", weights[index], scores[index]));
            }
        }
        let raw: Vec<String> = weights.iter().map(|weight| format!("{weight}_raw")).collect();
        self.shader.line(&format!("let raw_sum = {};", raw.join(" + ")));
        for index in (0..count).rev() {
            self.line(index, &format!("let {0} = {0}_raw / raw_sum;", weights[index]));
        }
    }

    fn paint(&mut self, index: usize, weight: &str) {
        self.values(Scope::Paint(index));
        self.add(index, weight);
    }

    fn add(&mut self, index: usize, weight: &str) {
        for name in OUTPUTS.iter().filter(|name| self.patch.blended.contains(*name)) {
            let value = self.names.read(self.layer(index).outputs[name]);
            let line = match *name {
                "normal" => format!("slopes += {weight} * layer_slopes({value});"),
                name => format!("{name} += {weight} * {value};"),
            };
            self.line(index, &line);
        }
        self.line(index, &format!("weight += {weight};"));
    }

    fn guarded(&mut self, condition: &str, inner: impl FnOnce(&mut Self)) {
        if self.patch.guard {
            self.shader.open(&format!("if {condition}"));
            inner(self);
            self.shader.close();
        } else {
            inner(self);
        }
    }

    /// Dividing by the weight that was painted keeps the sum of all parts 1, whatever was skipped.
    fn result(&mut self) {
        let values = OUTPUTS.map(|name| match (self.patch.blended.contains(name), name) {
            (true, "normal") => "layer_normal(slopes / weight)".to_owned(),
            (true, name) => format!("{name} / weight"),
            (false, name) => self.names.read(self.layer(0).outputs[name]),
        });
        self.shader.line(&format!("return TerrainOut({});", values.join(", ")));
    }

    fn line(&mut self, index: usize, line: &str) {
        self.shader.mapped(Place::Layer(self.patch.layers[index]), line);
    }
}
