//! Graphs: nodes in their order, instances in place of their calls.

use std::collections::BTreeMap;

use super::Builder;
use crate::graph::model::{Callee, Graph, Input, InputValue, Node};
use crate::program::{Op, Origin, ValueId};
use crate::value::Literal;

/// What the names of one graph mean at one place of use.
pub(super) struct Context<'a> {
    pub(super) graph: &'a Graph,
    /// `granite`, or `granite/edge` inside an instance.
    pub(super) path: String,
    /// Values of the instance's inputs.
    arguments: Vec<ValueId>,
    /// Position in [`Program::parameters`](crate::program::Program::parameters) of each parameter.
    parameters: Vec<usize>,
    /// Results of the nodes so far: one value, or an instance's outputs.
    results: Vec<NodeResult>,
}

enum NodeResult {
    Value(ValueId),
    Outputs(BTreeMap<String, ValueId>),
}

impl<'a> Builder<'a> {
    pub(super) fn graph(
        &mut self,
        graph: &'a Graph,
        path: String,
        overrides: &BTreeMap<String, Literal>,
    ) -> Context<'a> {
        let parameters = graph.parameters.iter().map(|parameter| {
            let default = overrides.get(&parameter.name).copied().unwrap_or(parameter.default);
            self.parameter(format!("{path}_{}", parameter.name), parameter, default)
        });
        let parameters = parameters.collect();
        self.nodes(Context { graph, path, arguments: Vec::new(), parameters, results: Vec::new() })
    }

    fn nodes(&mut self, mut context: Context<'a>) -> Context<'a> {
        for node in &context.graph.nodes {
            let result = self.node(&context, node);
            context.results.push(result);
        }
        context
    }

    fn node(&mut self, context: &Context<'a>, node: &Node) -> NodeResult {
        let inputs: Vec<ValueId> = node.inputs.iter().map(|input| self.input(context, input)).collect();
        let path = format!("{}/{}", context.path, node.name);
        match &node.callee {
            Callee::Function { kind, overload } => {
                let overload = &self.library.kinds[kind].overloads[*overload];
                let mut value = self.call(&overload.function, inputs, overload.output.ty.clone());
                self.program.pool.name(value, Origin { path, span: node.span });
                if let Some(channel) = node.channel {
                    value = self.component(value, channel);
                }
                NodeResult::Value(value)
            }
            Callee::Instance(id) => {
                let graph = &self.graphs.graphs[id.0];
                let inner = Context { graph, path, arguments: inputs, parameters: Vec::new(), results: Vec::new() };
                let inner = self.nodes(inner);
                let outputs =
                    graph.outputs.iter().map(|(name, output)| (name.clone(), self.input(&inner, &output.input)));
                NodeResult::Outputs(outputs.collect())
            }
        }
    }

    pub(super) fn input(&mut self, context: &Context<'a>, input: &Input) -> ValueId {
        let mut value = match &input.value {
            InputValue::Literal(literal) | InputValue::Default(literal) => self.literal(*literal),
            InputValue::Node(node) => match &context.results[*node] {
                NodeResult::Value(value) => *value,
                NodeResult::Outputs(outputs) => *outputs.values().next().unwrap_or(&ValueId(0)),
            },
            InputValue::NodeOutput { node, output } => match &context.results[*node] {
                NodeResult::Value(value) => *value,
                NodeResult::Outputs(outputs) => outputs[output],
            },
            InputValue::Frame(field) => self.frame(*field),
            InputValue::Parameter(index) => {
                let ty = context.graph.parameters[*index].ty.clone();
                self.leaf(Op::Parameter(context.parameters[*index]), ty)
            }
            InputValue::InstanceInput(index) => context.arguments[*index],
            InputValue::Texture(index) => self.texture(&context.graph.textures[*index]),
        };
        for access in &input.access {
            value = self.access(value, access.clone());
        }
        match input.widen {
            Some(count) => self.widen(value, count),
            None => value,
        }
    }
}
