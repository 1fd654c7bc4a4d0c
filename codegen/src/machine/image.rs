//! Textures in memory, filtered in `f64`: for tests, and for hosts that have nothing better.

mod filter;
mod region;

use super::texture::{Count, Load, Region, Sample, Textures, Within};

/// A texture array with its mip levels.
#[derive(Clone, Debug)]
pub struct Image {
    /// How far a filtered value may be off whatever the weights, for the precision of the format.
    doubt: f64,
    layers: u32,
    /// The finest first.
    levels: Vec<Level>,
}

/// One mip level of all layers.
#[derive(Clone, Debug)]
struct Level {
    width: u32,
    height: u32,
    /// Layer by layer, row by row.
    texels: Vec<[f64; 4]>,
}

impl Image {
    /// A texture of one level from its texels, layer by layer, row by row.
    ///
    /// # Panics
    /// If a size is 0, or the texels are not `width * height * layers`.
    pub fn new(width: u32, height: u32, layers: u32, texels: Vec<[f64; 4]>) -> Self {
        let image = Self { doubt: 0.0, layers, levels: vec![Level { width, height, texels }] };
        assert!(width > 0 && height > 0 && layers > 0, "a texture has texels");
        assert_eq!(image.levels[0].texels.len(), width as usize * height as usize * layers as usize, "texels");
        image
    }

    /// With values that may be off by so much when they are filtered: an eight-bit format may be filtered in eight bits.
    #[must_use]
    pub fn with_doubt(self, doubt: f64) -> Self {
        Self { doubt, ..self }
    }

    /// With the next coarser mip level: half the size, rounded down, at least 1.
    ///
    /// # Panics
    /// If the texels are not as many as that.
    #[must_use]
    pub fn with_level(mut self, texels: Vec<[f64; 4]>) -> Self {
        let finer = &self.levels[self.levels.len() - 1];
        let (width, height) = ((finer.width / 2).max(1), (finer.height / 2).max(1));
        assert_eq!(texels.len(), width as usize * height as usize * self.layers as usize, "texels of the level");
        self.levels.push(Level { width, height, texels });
        self
    }

    /// With all coarser levels, each texel the mean of the up to four that it covers.
    #[must_use]
    pub fn with_mean_levels(mut self) -> Self {
        loop {
            let finer = &self.levels[self.levels.len() - 1];
            if finer.width == 1 && finer.height == 1 {
                return self;
            }
            let texels = finer.halved(self.layers);
            self = self.with_level(texels);
        }
    }
}

impl Level {
    fn texel(&self, layer: u32, x: u32, y: u32) -> [f64; 4] {
        self.texels[((layer * self.height + y) * self.width + x) as usize]
    }

    fn halved(&self, layers: u32) -> Vec<[f64; 4]> {
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let mut texels = Vec::new();
        for layer in 0..layers {
            for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
                let at = |dx: u32, dy: u32| {
                    self.texel(layer, (2 * x + dx).min(self.width - 1), (2 * y + dy).min(self.height - 1))
                };
                let four = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
                texels.push(std::array::from_fn(|channel| four.iter().map(|texel| texel[channel]).sum::<f64>() / 4.0));
            }
        }
        texels
    }
}

/// What a coordinate outside 0..1 means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// The texture again.
    Repeat,
    /// Its edge.
    Clamp,
    /// The texture again, every second time reversed.
    Mirror,
}

impl Wrap {
    /// The column or row that a texel coordinate means.
    fn place(self, at: i64, size: u32) -> u32 {
        let size = i64::from(size);
        let place = match self {
            Self::Repeat => at.rem_euclid(size),
            Self::Clamp => at.clamp(0, size - 1),
            Self::Mirror => {
                let twice = at.rem_euclid(2 * size);
                if twice < size { twice } else { 2 * size - 1 - twice }
            }
        };
        place as u32
    }
}

/// How a texture is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampler {
    /// In both directions.
    pub wrap: Wrap,
    /// Between texels: linear, else nearest.
    pub linear: bool,
    /// Between mip levels: linear, else nearest.
    pub linear_levels: bool,
    /// How many samples an implementation may take along a footprint; 1 for none but the one at the coordinates. The
    /// filters here take one; what others may make of more is in the bounds of a region.
    pub anisotropy: u16,
}

/// Textures and samplers by number.
#[derive(Clone, Debug, Default)]
pub struct Images {
    /// Id 0 first.
    pub images: Vec<Image>,
    /// Id 0 first.
    pub samplers: Vec<Sampler>,
}

impl Textures for Images {
    fn sample(&self, sample: &Sample) -> Option<[f64; 4]> {
        let image = self.images.get(sample.texture as usize)?;
        let sampler = self.samplers.get(sample.sampler as usize)?;
        Some(filter::sample(image, *sampler, sample))
    }

    fn load(&self, load: &Load) -> Option<[f64; 4]> {
        let image = self.images.get(load.texture as usize)?;
        let level = usize::try_from(load.level).ok().and_then(|level| image.levels.get(level));
        let Some(level) = level else { return Some([0.0; 4]) };
        let inside = |at: i32, size: u32| u32::try_from(at).ok().filter(|at| *at < size);
        let [x, y] = load.at;
        match (inside(x, level.width), inside(y, level.height), inside(load.layer, image.layers)) {
            (Some(x), Some(y), Some(layer)) => Some(level.texel(layer, x, y)),
            _ => Some([0.0; 4]),
        }
    }

    fn size(&self, texture: u32, level: u32) -> Option<[u32; 2]> {
        let image = self.images.get(texture as usize)?;
        let level = image.levels.get(level as usize).or(image.levels.last())?;
        Some([level.width, level.height])
    }

    fn count(&self, texture: u32) -> Option<Count> {
        let image = self.images.get(texture as usize)?;
        Some(Count { layers: image.layers, levels: image.levels.len() as u32 })
    }

    fn region(&self, region: &Region) -> Option<[Within; 4]> {
        let image = self.images.get(region.texture as usize)?;
        let sampler = self.samplers.get(region.sampler as usize)?;
        Some(region::bounds(image, *sampler, region))
    }

    fn whole(&self, texture: u32) -> Option<[Within; 4]> {
        // A read outside the texture gives zero.
        let texels = self.images.get(texture as usize)?.levels.iter().flat_map(|level| &level.texels);
        Some(region::hull(texels.copied().chain([[0.0; 4]])))
    }
}
