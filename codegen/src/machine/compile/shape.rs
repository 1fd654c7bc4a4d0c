//! How a type falls into scalars.

use naga::{ArraySize, Handle, ScalarKind, Type, TypeInner};

use super::{Bank, Compiler, Result};

impl Compiler<'_> {
    /// The bank of each scalar of a type, in order.
    pub(super) fn banks(&self, ty: &TypeInner) -> Result<Vec<Bank>> {
        let mut banks = Vec::new();
        self.collect(ty, &mut banks)?;
        Ok(banks)
    }

    fn collect(&self, ty: &TypeInner, out: &mut Vec<Bank>) -> Result<()> {
        match ty {
            TypeInner::Scalar(scalar) => out.push(self.bank(*scalar)?),
            TypeInner::Vector { size, scalar } => out.extend(vec![self.bank(*scalar)?; *size as usize]),
            TypeInner::Matrix { columns, rows, scalar } => {
                out.extend(vec![self.bank(*scalar)?; *columns as usize * *rows as usize]);
            }
            TypeInner::Array { base, size: ArraySize::Constant(count), .. } => {
                let element = self.banks(&self.module.types[*base].inner)?;
                (0..count.get()).for_each(|_| out.extend_from_slice(&element));
            }
            TypeInner::Struct { members, .. } => {
                for member in members {
                    self.collect(&self.module.types[member.ty].inner, out)?;
                }
            }
            TypeInner::Image { .. } | TypeInner::Sampler { comparison: false } => out.push(Bank::Handle),
            other => return self.unsupported(format!("a value of type {other:?}")),
        }
        Ok(())
    }

    fn bank(&self, scalar: naga::Scalar) -> Result<Bank> {
        match (scalar.kind, scalar.width) {
            (ScalarKind::Float, 4) => Ok(Bank::Float),
            (ScalarKind::Sint | ScalarKind::Uint, 4) => Ok(Bank::Int),
            (ScalarKind::Bool, _) => Ok(Bank::Truth),
            _ => self.unsupported(format!("a {}-bit {:?}", u32::from(scalar.width) * 8, scalar.kind)),
        }
    }

    /// How many scalars a type has.
    pub(super) fn size(&self, ty: Handle<Type>) -> Result<u32> {
        Ok(self.banks(&self.module.types[ty].inner)?.len() as u32)
    }

    /// How many elements a vector, matrix or array has (or a pointer to one), and how many scalars each.
    pub(super) fn elements(&self, ty: &TypeInner) -> Result<(u32, u32)> {
        match *ty {
            TypeInner::Vector { size, .. } | TypeInner::ValuePointer { size: Some(size), .. } => Ok((size as u32, 1)),
            TypeInner::Matrix { columns, rows, .. } => Ok((columns as u32, rows as u32)),
            TypeInner::Array { base, size: ArraySize::Constant(count), .. } => Ok((count.get(), self.size(base)?)),
            TypeInner::Pointer { base, .. } => self.elements(&self.module.types[base].inner),
            _ => self.unsupported(format!("an index into {ty:?}")),
        }
    }

    /// Where a member, element, column or component stands in its whole (or pointee), and how many scalars it has.
    pub(super) fn part(&self, ty: &TypeInner, index: u32) -> Result<(u32, u32)> {
        match ty {
            TypeInner::Pointer { base, .. } => self.part(&self.module.types[*base].inner, index),
            TypeInner::Struct { members, .. } => {
                let mut offset = 0;
                for member in &members[..index as usize] {
                    offset += self.size(member.ty)?;
                }
                Ok((offset, self.size(members[index as usize].ty)?))
            }
            _ => self.elements(ty).map(|(_, stride)| (index * stride, stride)),
        }
    }
}
