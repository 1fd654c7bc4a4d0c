//! One function of a kind: its parameters as naga sees them, and as they are documented.

use naga::Handle;

use super::Reader;
use super::example::is_example;
use crate::library::codes;
use crate::library::item::{Entry, Item, entries};
use crate::library::kind::{Overload, Port};
use crate::value::Type;

impl Reader<'_> {
    pub(super) fn overload(&mut self, item: &Item) -> Option<Overload> {
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
}
