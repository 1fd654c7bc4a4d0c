//! The nodes of a random graph: every one could be an author's.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use terrane_codegen::library::{Library, Overload, Port};
use terrane_codegen::value::Type;

use super::genes::Genes;

/// Something that an input may be wired to.
#[derive(Clone)]
pub(super) struct Wire {
    text: String,
    ty: Type,
    unit: Option<String>,
    /// The node that it is a part of.
    node: Option<String>,
}

impl Wire {
    pub(super) fn new(text: impl Into<String>, ty: Type, unit: Option<&str>) -> Self {
        Self { text: text.into(), ty, unit: unit.map(str::to_owned), node: None }
    }

    fn of(self, node: &str) -> Self {
        Self { node: Some(node.to_owned()), ..self }
    }
}

/// Nodes so far, and what can be read.
pub(super) struct Scene<'a, 'g> {
    library: &'a Library,
    pub(super) genes: &'a mut Genes<'g>,
    wires: Vec<Wire>,
    /// Nodes that nothing reads yet.
    unread: BTreeSet<String>,
    textures: &'static [&'static str],
    instances: &'static [&'static str],
    pub(super) text: String,
}

impl<'a, 'g> Scene<'a, 'g> {
    pub(super) fn new(library: &'a Library, genes: &'a mut Genes<'g>, wires: Vec<Wire>) -> Self {
        let (unread, text) = (BTreeSet::new(), String::new());
        Self { library, genes, wires, unread, textures: &[], instances: &[], text }
    }

    /// May call these.
    pub(super) fn calling(self, instances: &'static [&'static str]) -> Self {
        Self { instances, ..self }
    }

    /// May read these.
    pub(super) fn reading(self, textures: &'static [&'static str]) -> Self {
        Self { textures, ..self }
    }

    pub(super) fn nodes(&mut self, most: usize) {
        let count = self.genes.below(most);
        for index in 0..count {
            if self.genes.is_spent() {
                break;
            }
            self.node(&format!("n{index}"));
        }
    }

    fn node(&mut self, name: &str) {
        if !self.instances.is_empty() && self.genes.below(5) == 4 {
            return self.call(name);
        }
        let kinds: Vec<_> = self.library.kinds.values().collect();
        let Some(kind) = self.genes.pick(&kinds) else { return };
        let Some(overload) = self.genes.pick(&kind.overloads) else { return };
        let Some(arguments) = self.arguments(overload) else { return };
        let _ = writeln!(self.text, "        \"{name}\": {}({}),", kind.name, arguments.join(", "));
        // A texture with a channel gives one number, whatever the function returns.
        let is_texture = overload.inputs.iter().any(|port| port.ty == Type::Texture);
        let has_channel = is_texture && !arguments.iter().any(|argument| argument.ends_with(": rock"));
        let ty = if has_channel && overload.output.ty == Type::Vec4 { Type::F32 } else { overload.output.ty.clone() };
        self.result(name, ty, overload);
    }

    fn call(&mut self, name: &str) {
        let instance = self.genes.pick(self.instances).copied().unwrap_or_default();
        let base = self.argument_of(&Type::F32, None, (0.0, 1.0));
        let detail = self.argument_of(&Type::F32, None, (0.0, 1.0));
        let _ = writeln!(self.text, "        \"{name}\": {instance}(base: {base}, detail: {detail}),");
        self.unread.insert(name.to_owned());
        self.wires.push(Wire::new(format!("\"{name}.edge\""), Type::F32, None).of(name));
    }

    fn result(&mut self, name: &str, ty: Type, overload: &Overload) {
        let unit = overload.output.unit.as_deref();
        self.unread.insert(name.to_owned());
        for (letter, _) in "xyzw".chars().zip(0..ty.components().filter(|count| *count > 1).unwrap_or(0)) {
            self.wires.push(Wire::new(format!("\"{name}.{letter}\""), Type::F32, unit).of(name));
        }
        for member in &overload.members {
            let path = format!("\"{name}.{}\"", member.name);
            self.wires.push(Wire::new(path, member.ty.clone(), member.unit.as_deref()).of(name));
        }
        self.wires.push(Wire::new(name, ty, unit).of(name));
    }

    fn arguments(&mut self, overload: &Overload) -> Option<Vec<String>> {
        overload.inputs.iter().map(|port| Some(format!("{}: {}", port.name, self.argument(port)?))).collect()
    }

    fn argument(&mut self, port: &Port) -> Option<String> {
        match &port.ty {
            Type::Texture => self.genes.pick(self.textures).map(|name| (*name).to_owned()),
            Type::Struct(_) => self.wire(&port.ty, None),
            Type::I32 | Type::U32 => {
                let (low, high) = port.range.unwrap_or((0.0, 8.0));
                Some(format!("{}", self.genes.between(low, high.min(8.0).max(low)).round() as i64))
            }
            ty if port.constant => Some(self.literal(ty, port.range.unwrap_or((-2.0, 2.0)))),
            ty => Some(self.argument_of(ty, port.unit.as_deref(), port.range.unwrap_or((-2.0, 2.0)))),
        }
    }

    pub(super) fn argument_of(&mut self, ty: &Type, unit: Option<&str>, range: (f32, f32)) -> String {
        let wired = if self.genes.below(4) == 0 { None } else { self.wire(ty, unit) };
        wired.unwrap_or_else(|| self.literal(ty, range))
    }

    fn wire(&mut self, ty: &Type, unit: Option<&str>) -> Option<String> {
        let fits =
            |wire: &&Wire| wire.ty == *ty && (unit.is_none() || wire.unit.is_none() || wire.unit.as_deref() == unit);
        let found: Vec<&Wire> = self.wires.iter().filter(fits).collect();
        // Mostly what nothing reads yet: a node that no output depends on is not computed, and compared with nothing.
        let unread = |wire: &&Wire| wire.node.as_ref().is_some_and(|node| self.unread.contains(node));
        let fresh: Vec<&Wire> = found.iter().copied().filter(unread).collect();
        let any = fresh.is_empty() || self.genes.below(4) == 0;
        let wire = self.genes.pick(if any { &found } else { &fresh });
        let (text, node) = wire.map(|wire| (wire.text.clone(), wire.node.clone()))?;
        node.map(|node| self.unread.remove(&node));
        Some(text)
    }

    /// For an output: a number spreads over a vector.
    pub(super) fn output(&mut self, ty: &Type) -> String {
        let ty = if self.genes.below(2) == 0 { ty } else { &Type::F32 };
        self.argument_of(ty, None, (0.0, 1.0))
    }

    fn literal(&mut self, ty: &Type, (low, high): (f32, f32)) -> String {
        let count = ty.components().unwrap_or(1);
        let values: Vec<String> = (0..count).map(|_| format!("{:?}", self.genes.between(low, high))).collect();
        if count == 1 { values.join("") } else { format!("({})", values.join(", ")) }
    }
}
