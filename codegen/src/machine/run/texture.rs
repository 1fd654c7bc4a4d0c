//! Texture reads: the host is asked for active lanes only.

use super::super::program::{Bank, Footprint, Load, Sample};
use super::Run;
use super::active::Active;
use super::frame::Frame;
use super::lane::View;
use crate::machine::domain::Domain;
use crate::machine::error::MachineError;
use crate::machine::texture;

type Result<T> = std::result::Result<T, MachineError>;

impl<D: Domain> Run<'_, D> {
    pub(super) fn sample(&mut self, frame: &mut Frame<D>, active: &Active, sample: &Sample) -> Result<()> {
        let mut failed = None;
        let mut texels = vec![[0.0; 4]; frame.lanes];
        active.each(|lane| {
            let request = request(frame, sample, lane);
            match self.textures.sample(&request) {
                Some(texel) => texels[lane] = texel,
                None => failed = Some(request.texture),
            }
        });
        self.known_texture(frame, failed)?;
        for (channel, to) in sample.to.iter().enumerate() {
            let out = frame.floats[*to as usize].overwrite(texels.len());
            active.each(|lane| out[lane] = D::measured(texels[lane][channel]));
        }
        Ok(())
    }

    pub(super) fn load(&mut self, frame: &mut Frame<D>, active: &Active, load: &Load) -> Result<()> {
        let mut failed = None;
        let mut texels = vec![[0.0; 4]; frame.lanes];
        active.each(|lane| {
            let int = |index: u32| D::known(frame.int(index).at(lane)).unwrap_or(0) as i32;
            let request = texture::Load {
                texture: frame.handles[load.texture as usize],
                at: load.at.map(int),
                layer: load.layer.map_or(0, int),
                level: load.level.map_or(0, int),
            };
            match self.textures.load(&request) {
                Some(texel) => texels[lane] = texel,
                None => failed = Some(request.texture),
            }
        });
        self.known_texture(frame, failed)?;
        for (channel, to) in load.to.iter().enumerate() {
            if load.bank == Bank::Float {
                let out = frame.floats[*to as usize].overwrite(texels.len());
                active.each(|lane| out[lane] = D::measured(texels[lane][channel]));
            } else {
                let out = frame.ints[*to as usize].overwrite(texels.len());
                active.each(|lane| out[lane] = D::int(texels[lane][channel] as i64 as u32));
            }
        }
        Ok(())
    }

    pub(super) fn size(
        &mut self,
        frame: &mut Frame<D>,
        active: &Active,
        to: &[u32],
        texture: u32,
        level: Option<u32>,
    ) -> Result<()> {
        let texture = frame.handles[texture as usize];
        let level = level.map_or(View::One(D::int(0)), |level| frame.int(level));
        let ask = |level| self.textures.size(texture, D::known(level).unwrap_or(0));
        let mut sizes = vec![Some([0, 0]); if matches!(level, View::One(_)) { 1 } else { frame.lanes }];
        match level {
            View::One(level) => sizes[0] = ask(level),
            View::Many(levels) => active.each(|lane| sizes[lane] = ask(levels[lane])),
        }
        let Some(sizes) = sizes.into_iter().collect::<Option<Vec<_>>>() else {
            return self.known_texture(frame, Some(texture));
        };
        for (axis, to) in to.iter().enumerate() {
            let lane = &mut frame.ints[*to as usize];
            match sizes[..] {
                [size] => lane.set(D::int(size[axis])),
                _ => lane.overwrite(sizes.len()).iter_mut().zip(&sizes).for_each(|(to, size)| *to = D::int(size[axis])),
            }
        }
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
        let unknown = || MachineError::Texture { function: self.name(frame).to_owned(), texture };
        self.textures.count(texture).ok_or_else(unknown)
    }

    fn known_texture(&self, frame: &Frame<D>, failed: Option<u32>) -> Result<()> {
        match failed {
            Some(texture) => Err(MachineError::Texture { function: self.name(frame).to_owned(), texture }),
            None => Ok(()),
        }
    }
}

fn request<D: Domain>(frame: &Frame<D>, sample: &Sample, lane: usize) -> texture::Sample {
    let float = |index: u32| D::middle(frame.float(index).at(lane));
    texture::Sample {
        texture: frame.handles[sample.texture as usize],
        sampler: frame.handles[sample.sampler as usize],
        layer: sample.layer.map_or(0, |layer| D::known(frame.int(layer).at(lane)).unwrap_or(0) as i32),
        uv: sample.uv.map(float),
        offset: sample.offset,
        footprint: match sample.footprint {
            Footprint::Finest => texture::Footprint::Level(0.0),
            Footprint::Level(level) => texture::Footprint::Level(float(level)),
            Footprint::Gradient { ddx, ddy } => {
                texture::Footprint::Gradient { ddx: ddx.map(float), ddy: ddy.map(float) }
            }
        },
    }
}
