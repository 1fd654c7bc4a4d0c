//! Texture reads: the host is asked for active lanes only.

use super::super::program::{Bank, Footprint, Load, Sample};
use super::Run;
use super::active::Active;
use super::flow::Result;
use super::frame::{Floats, Frame, InBank, Ints};
use super::lane::View;
use crate::machine::domain::{Cell, Domain};
use crate::machine::error::MachineError;
use crate::machine::texture;

impl<D: Domain> Run<'_, D> {
    pub(super) fn sample(&mut self, frame: &mut Frame<D>, active: &Active, sample: &Sample) -> Result<()> {
        let texture = frame.handles[sample.texture as usize];
        let read = |lane| D::sample(self.textures, &sample_request(frame, sample, lane));
        let texels = self.texels(frame, active, texture, read)?;
        spread::<D, Floats, 4>(frame, active, sample.to, &texels);
        Ok(())
    }

    pub(super) fn load(&mut self, frame: &mut Frame<D>, active: &Active, load: &Load) -> Result<()> {
        let texture = frame.handles[load.texture as usize];
        let request = |lane| load_request(frame, load, lane);
        if load.bank == Bank::Float {
            let texels = self.texels(frame, active, texture, |lane| D::load(self.textures, &request(lane)))?;
            spread::<D, Floats, 4>(frame, active, load.to, &texels);
        } else {
            let texels = self.texels(frame, active, texture, |lane| D::load_int(self.textures, &request(lane)))?;
            spread::<D, Ints, 4>(frame, active, load.to, &texels);
        }
        Ok(())
    }

    /// What the host says for each active lane.
    fn texels<T: Cell, const N: usize>(
        &self,
        frame: &Frame<D>,
        active: &Active,
        texture: u32,
        read: impl Fn(usize) -> Option<[T; N]>,
    ) -> Result<Vec<[T; N]>> {
        let mut texels = vec![[T::default(); N]; frame.lanes];
        let mut known = true;
        active.each(|lane| match read(lane) {
            Some(texel) => texels[lane] = texel,
            None => known = false,
        });
        if known { Ok(texels) } else { Err(self.unknown_texture(frame, texture)) }
    }

    pub(super) fn size(
        &mut self,
        frame: &mut Frame<D>,
        active: &Active,
        to: [u32; 2],
        texture: u32,
        level: Option<u32>,
    ) -> Result<()> {
        let texture = frame.handles[texture as usize];
        let read = |lane| {
            let level = level.map_or(View::One(D::int(0)), |level| frame.int(level)).at(lane);
            // A level that is not known has a size that is not known either.
            match D::candidates(level).as_deref() {
                Some([level]) => self.textures.size(texture, *level).map(|size| size.map(D::int)),
                _ => self.textures.size(texture, 0).map(|_| [D::any_int(); 2]),
            }
        };
        let sizes = self.texels(frame, active, texture, read)?;
        spread::<D, Ints, 2>(frame, active, to, &sizes);
        Ok(())
    }

    pub(super) fn layers(&mut self, frame: &mut Frame<D>, to: u32, texture: u32) -> Result<()> {
        let count = self.texture_count(frame, texture)?;
        frame.ints[to as usize].set(D::int(count.layers));
        Ok(())
    }

    pub(super) fn levels(&mut self, frame: &mut Frame<D>, to: u32, texture: u32) -> Result<()> {
        let count = self.texture_count(frame, texture)?;
        frame.ints[to as usize].set(D::int(count.levels));
        Ok(())
    }

    fn texture_count(&self, frame: &Frame<D>, texture: u32) -> Result<texture::Count> {
        let texture = frame.handles[texture as usize];
        self.textures.count(texture).ok_or_else(|| self.unknown_texture(frame, texture))
    }

    fn unknown_texture(&self, frame: &Frame<D>, texture: u32) -> MachineError {
        MachineError::Texture { function: self.name(frame).to_owned(), texture }
    }
}

/// One channel to each register.
fn spread<D: Domain, B: InBank<D>, const N: usize>(
    frame: &mut Frame<D>,
    active: &Active,
    to: [u32; N],
    texels: &[[B::Item; N]],
) {
    for (channel, to) in to.iter().enumerate() {
        let out = B::lanes_mut(frame)[*to as usize].overwrite(texels.len());
        active.each(|lane| out[lane] = texels[lane][channel]);
    }
}

fn sample_request<D: Domain>(frame: &Frame<D>, sample: &Sample, lane: usize) -> texture::Sample<D::Float, D::Int> {
    let float = |index: u32| frame.float(index).at(lane);
    texture::Sample {
        texture: frame.handles[sample.texture as usize],
        sampler: frame.handles[sample.sampler as usize],
        layer: sample.layer.map_or(D::int(0), |layer| frame.int(layer).at(lane)),
        uv: sample.uv.map(float),
        offset: sample.offset,
        footprint: match sample.footprint {
            Footprint::Finest => texture::Footprint::Level(D::float(0.0)),
            Footprint::Level(level) => texture::Footprint::Level(float(level)),
            Footprint::Gradient { ddx, ddy } => {
                texture::Footprint::Gradient { ddx: ddx.map(float), ddy: ddy.map(float) }
            }
        },
    }
}

fn load_request<D: Domain>(frame: &Frame<D>, load: &Load, lane: usize) -> texture::Load<D::Int> {
    let int = |index: u32| frame.int(index).at(lane);
    texture::Load {
        texture: frame.handles[load.texture as usize],
        at: load.at.map(int),
        layer: load.layer.map_or(D::int(0), int),
        level: load.level.map_or(D::int(0), int),
    }
}
