//! Texture reads.

use naga::{Expression, Handle, ImageClass, ImageDimension, ImageQuery, SampleLevel, Scalar, ScalarKind};
use naga::{StorageAccess, TypeInner};

use super::super::program::{Footprint, Instruction, Load, Sample};
use super::access::registers;
use super::{Bank, Compiler, Register, Result};

impl Compiler<'_> {
    pub(super) fn image_sample(&mut self, handle: Handle<Expression>) -> Result<Vec<Register>> {
        let function = self.function;
        let Expression::ImageSample {
            image,
            sampler,
            gather: None,
            coordinate,
            array_index,
            offset,
            level,
            depth_ref: None,
            clamp_to_edge: false,
        } = function.expressions[handle]
        else {
            return self.unsupported("a gathering, comparing or edge-clamping texture sample");
        };
        self.plane(image)?;
        let footprint = self.footprint(level)?;
        let offset = offset.map_or(Ok([0, 0]), |offset| self.texel_offset(offset))?;
        let (texture, sampler) = (self.scalar(image)?, self.scalar(sampler)?);
        let layer = array_index.map(|index| self.scalar(index)).transpose()?;
        let uv = self.pair(coordinate)?;
        let to = [(); 4].map(|()| self.allocate(Bank::Float).index);
        self.pending.push(Instruction::Sample(Sample { to, texture, sampler, layer, uv, offset, footprint }));
        Ok(registers(Bank::Float, to))
    }

    fn footprint(&mut self, level: SampleLevel) -> Result<Footprint> {
        Ok(match level {
            SampleLevel::Zero => Footprint::Finest,
            SampleLevel::Exact(level) => Footprint::Level(self.scalar(level)?),
            SampleLevel::Gradient { x, y } => Footprint::Gradient { ddx: self.pair(x)?, ddy: self.pair(y)? },
            SampleLevel::Auto | SampleLevel::Bias(_) => {
                return self.unsupported("a texture sample with implicit derivatives");
            }
        })
    }

    fn pair(&mut self, expression: Handle<Expression>) -> Result<[u32; 2]> {
        match self.indices(expression)?[..] {
            [x, y] => Ok([x, y]),
            _ => self.unsupported("texture coordinates that are not two"),
        }
    }

    fn texel_offset(&mut self, expression: Handle<Expression>) -> Result<[i32; 2]> {
        let pair = self.pair(expression)?;
        let constants = &self.program.constants;
        let find = |index| constants.iter().find(|(register, _)| *register == Register { bank: Bank::Int, index });
        match (find(pair[0]), find(pair[1])) {
            (Some(x), Some(y)) => Ok([x.1 as i32, y.1 as i32]),
            _ => self.unsupported("a texel offset that is not constant"),
        }
    }

    pub(super) fn image_load(
        &mut self,
        image: Handle<Expression>,
        coordinate: Handle<Expression>,
        array_index: Option<Handle<Expression>>,
        level: Option<Handle<Expression>>,
    ) -> Result<Vec<Register>> {
        let kind = self.plane(image)?;
        let bank = if kind == ScalarKind::Float { Bank::Float } else { Bank::Int };
        let (texture, at) = (self.scalar(image)?, self.pair(coordinate)?);
        let layer = array_index.map(|index| self.scalar(index)).transpose()?;
        let level = level.map(|level| self.scalar(level)).transpose()?;
        let to = [(); 4].map(|()| self.allocate(bank).index);
        self.pending.push(Instruction::Load(Load { bank, to, texture, at, layer, level }));
        Ok(registers(bank, to))
    }

    pub(super) fn image_query(&mut self, image: Handle<Expression>, query: ImageQuery) -> Result<Vec<Register>> {
        self.plane(image)?;
        let texture = self.scalar(image)?;
        let mut int = || self.allocate(Bank::Int).index;
        let (instruction, to) = match query {
            ImageQuery::Size { level } => {
                let to = [int(), int()];
                let level = level.map(|level| self.scalar(level)).transpose()?;
                (Instruction::Size { to, texture, level }, to.to_vec())
            }
            ImageQuery::NumLayers => {
                let to = int();
                (Instruction::Layers { to, texture }, vec![to])
            }
            ImageQuery::NumLevels => {
                let to = int();
                (Instruction::Levels { to, texture }, vec![to])
            }
            ImageQuery::NumSamples => return self.unsupported("a multisampled texture"),
        };
        self.pending.push(instruction);
        Ok(registers(Bank::Int, to))
    }

    /// The scalar kind of a two-dimensional texture that is sampled, or a storage texture that is only read.
    fn plane(&self, image: Handle<Expression>) -> Result<ScalarKind> {
        match *self.inner(image) {
            TypeInner::Image { dim: ImageDimension::D2, class: ImageClass::Sampled { kind, multi: false }, .. } => {
                Ok(kind)
            }
            TypeInner::Image { dim: ImageDimension::D2, class: ImageClass::Storage { format, access }, .. }
                if access == StorageAccess::LOAD =>
            {
                Ok(Scalar::from(format).kind)
            }
            ref other => self.unsupported(format!("a texture of type {other:?}")),
        }
    }
}
