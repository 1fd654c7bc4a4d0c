//! Values, folded where their arguments are known.

use super::Builder;
use crate::diagnostic::Span;
use crate::graph::model::{Access, FrameField};
use crate::library::Library;
use crate::program::fold;
use crate::program::{Op, Origin, Value, ValueId};
use crate::value::{Literal, Type};

impl Builder<'_> {
    pub(super) fn sample(&mut self, of: ValueId, uv: ValueId, channel: u8, path: String, span: Span) -> ValueId {
        let texel = self.call("texture", vec![of, uv], Type::Vec4);
        self.program.pool.name(texel, Origin { path, span });
        self.component(texel, channel)
    }

    pub(super) fn component(&mut self, value: ValueId, channel: u8) -> ValueId {
        let name = ["x", "y", "z", "w"][usize::from(channel.min(3))];
        self.access(value, Access::Swizzle(name.into()))
    }

    pub(super) fn call(&mut self, function: &str, inputs: Vec<ValueId>, ty: Type) -> ValueId {
        let known = || inputs.iter().map(|input| self.program.pool.literal(*input)).collect::<Option<Vec<_>>>();
        if let Some(folder) = &self.folder
            && let Some(literal) = known().and_then(|arguments| folder.call(function, &arguments, &ty))
        {
            return self.literal(literal);
        }
        self.program.pool.add(Value { op: Op::Call(function.to_owned()), inputs, ty })
    }

    pub(super) fn access(&mut self, value: ValueId, access: Access) -> ValueId {
        if let (Some(literal), Access::Swizzle(swizzle)) = (self.program.pool.literal(value), &access)
            && let Some(part) = fold::swizzle(literal, swizzle)
        {
            return self.literal(part);
        }
        let ty = access_type(self.library, &self.program.pool.get(value).ty, &access);
        self.program.pool.add(Value { op: Op::Access(access), inputs: vec![value], ty })
    }

    pub(super) fn widen(&mut self, value: ValueId, count: u8) -> ValueId {
        if let Some([number]) = self.program.pool.literal(value).map(|literal| literal.values()).as_deref() {
            return self.literal(Literal::floats(&vec![*number; usize::from(count)]));
        }
        let ty = Type::floats(usize::from(count)).unwrap_or(Type::F32);
        self.program.pool.add(Value { op: Op::Widen, inputs: vec![value], ty })
    }

    pub(super) fn product(&mut self, a: ValueId, b: ValueId, path: &str, span: Span) -> ValueId {
        let one = Some(Literal::f32(1.0));
        match (self.program.pool.literal(a), self.program.pool.literal(b)) {
            (literal, _) if literal == one => b,
            (_, literal) if literal == one => a,
            _ => {
                let value = self.program.pool.add(Value { op: Op::Product, inputs: vec![a, b], ty: Type::F32 });
                self.program.pool.name(value, Origin { path: format!("{path}/mask"), span });
                value
            }
        }
    }

    pub(super) fn literal(&mut self, literal: Literal) -> ValueId {
        self.leaf(Op::Literal(literal), literal.ty())
    }

    pub(super) fn frame(&mut self, field: FrameField) -> ValueId {
        self.leaf(Op::Frame(field), field.ty())
    }

    pub(super) fn leaf(&mut self, op: Op, ty: Type) -> ValueId {
        self.program.pool.add(Value { op, inputs: Vec::new(), ty })
    }
}

fn access_type(library: &Library, ty: &Type, access: &Access) -> Type {
    match (ty, access) {
        (Type::Struct(name), Access::Member(member)) => {
            let found = library.structs.get(name).and_then(|members| members.iter().find(|port| port.name == *member));
            found.map_or(Type::F32, |port| port.ty.clone())
        }
        (_, Access::Swizzle(swizzle)) => Type::floats(swizzle.len()).unwrap_or(Type::F32),
        (other, Access::Member(_)) => other.clone(),
    }
}
