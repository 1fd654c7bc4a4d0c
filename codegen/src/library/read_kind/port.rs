//! Ports: a type that flows along a wire, and a line that documents it.

use naga::{Handle, TypeInner};

use super::Reader;
use crate::library::codes;
use crate::library::item::{Entry, Item, entries};
use crate::library::kind::Port;
use crate::library::port_line::{self, PortLine};
use crate::value::Type;

impl Reader<'_> {
    /// A texture port `of` is three parameters: `of_texture` (`of` alone is reserved in WGSL), `of_sampler`, `of_layer`.
    pub(super) fn inputs(&mut self, scanned: &[Entry], types: &[Handle<naga::Type>]) -> Vec<Port> {
        let mut ports = Vec::new();
        let mut index = 0;
        while index < scanned.len() {
            let mut entry = scanned[index].clone();
            index += 1;
            let Some(ty) = self.port_type(types[index - 1], &entry) else { continue };
            if ty == Type::Texture {
                let parameter = entry.name.clone();
                entry.name = parameter.strip_suffix("_texture").unwrap_or_default().to_owned();
                let names: Vec<_> = scanned[index..].iter().take(2).map(|entry| entry.name.clone()).collect();
                let companions = [format!("{}_sampler", entry.name), format!("{}_layer", entry.name)];
                if entry.name.is_empty() || names != companions {
                    self.error(
                        codes::PORT_TYPE,
                        entry.name_range.clone(),
                        format!("`{parameter}` is no texture port"),
                        "declare `NAME_texture: texture_2d_array<f32>, NAME_sampler: sampler, NAME_layer: i32` in this order",
                    );
                }
                index += 2;
            }
            ports.extend(self.port(&entry, ty));
        }
        ports
    }

    pub(super) fn port(&mut self, entry: &Entry, ty: Type) -> Option<Port> {
        let line = match port_line::parse(&entry.doc) {
            Ok(line) => line,
            Err(problem) => {
                let message = format!("port `{}`: {problem}", entry.name);
                self.error(
                    codes::PORT_UNDOCUMENTED,
                    entry.name_range.clone(),
                    message,
                    "for example `/// How much of it. 0..1 = 1.0`",
                );
                return None;
            }
        };
        let default = line.default.as_ref().map(|values| port_line::literal(values, &ty));
        let outside = |value: f32| line.range.is_some_and(|(low, high)| value < low || value > high);
        if default == Some(None) || default.flatten().is_some_and(|literal| literal.values().into_iter().any(outside)) {
            let message = format!("the default of `{}` is no {ty} in its range", entry.name);
            self.error(codes::PORT_DEFAULT, entry.name_range.clone(), message, "a number, or `(x, y, z)` for a vector");
        }
        let PortLine { doc, unit, constant, range, .. } = line;
        Some(Port { name: entry.name.clone(), ty, doc, unit, range, default: default.flatten(), constant })
    }

    pub(super) fn members(&mut self, item: &Item) -> Vec<Port> {
        let found = self.library.module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(&item.name));
        let Some(TypeInner::Struct { members, .. }) = found.map(|(_, ty)| ty.inner.clone()) else { return Vec::new() };
        let scanned = entries(&self.library.text, item.list.clone());
        let pairs: Vec<_> = scanned.iter().zip(members).collect();
        pairs
            .into_iter()
            .filter_map(|(entry, member)| {
                let ty = self.member_type(member.ty)?;
                self.port(entry, ty)
            })
            .collect()
    }

    pub(super) fn port_type(&mut self, handle: Handle<naga::Type>, entry: &Entry) -> Option<Type> {
        let ty = wire_type(&self.library.module, handle);
        if ty.is_none() {
            let message = format!("`{}` has a type that cannot flow along a wire", entry.name);
            self.error(
                codes::PORT_TYPE,
                entry.name_range.clone(),
                message,
                "f32, i32, u32, vec2f, vec3f, vec4f, a struct, or texture_2d_array<f32>",
            );
        }
        ty
    }

    /// Members that no wire can carry (a lattice's `vec2i`) stay inside the library.
    fn member_type(&mut self, handle: Handle<naga::Type>) -> Option<Type> {
        wire_type(&self.library.module, handle)
    }
}

fn wire_type(module: &naga::Module, handle: Handle<naga::Type>) -> Option<Type> {
    use naga::{ImageClass, ImageDimension, Scalar, ScalarKind, VectorSize};
    let ty = &module.types[handle];
    Some(match ty.inner {
        TypeInner::Scalar(Scalar::F32) => Type::F32,
        TypeInner::Scalar(Scalar::I32) => Type::I32,
        TypeInner::Scalar(Scalar::U32) => Type::U32,
        TypeInner::Vector { size: VectorSize::Bi, scalar: Scalar::F32 } => Type::Vec2,
        TypeInner::Vector { size: VectorSize::Tri, scalar: Scalar::F32 } => Type::Vec3,
        TypeInner::Vector { size: VectorSize::Quad, scalar: Scalar::F32 } => Type::Vec4,
        TypeInner::Struct { .. } => Type::Struct(ty.name.clone()?),
        TypeInner::Image {
            dim: ImageDimension::D2,
            arrayed: true,
            class: ImageClass::Sampled { kind: ScalarKind::Float, multi: false },
        } => Type::Texture,
        _ => return None,
    })
}
