//! What the machine asks of its host: texels.

/// The host's textures and samplers, by the ids that it passed as arguments or bound to global variables.
pub trait Textures: Sync {
    /// A filtered sample; `None` if there is no such texture or sampler.
    fn sample(&self, sample: &Sample) -> Option<[f64; 4]>;

    /// One texel, integers as their value; zero outside the texture, `None` if there is no such texture.
    fn load(&self, load: &Load) -> Option<[f64; 4]>;

    /// Width and height of a mip level in texels, `None` if there is no such texture.
    fn size(&self, texture: u32, level: u32) -> Option<[u32; 2]>;

    /// The bounds of all values that a sample may have whose coordinates are known up to ranges, whatever the filter's
    /// weights and its choice of levels; `None` if there is no such texture.
    ///
    /// Only [`Accept`](super::domain::Accept) asks. The default knows nothing.
    fn region(&self, region: &Region) -> Option<[Within; 4]> {
        self.whole(region.texture)
    }

    /// The bounds of all texels; `None` if there is no such texture. The default knows nothing.
    fn whole(&self, texture: u32) -> Option<[Within; 4]> {
        self.count(texture).map(|_| [Within { low: f64::NEG_INFINITY, high: f64::INFINITY }; 4])
    }

    /// How many array layers and mip levels, `None` if there is no such texture.
    fn count(&self, texture: u32) -> Option<Count>;
}

/// How many layers and levels a texture has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// Array layers.
    pub layers: u32,
    /// Mip levels.
    pub levels: u32,
}

/// `textureSampleLevel` or `textureSampleGrad` at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<F = f64, I = i32> {
    /// The host's id.
    pub texture: u32,
    /// The host's id.
    pub sampler: u32,
    /// Array layer; 0 for plain textures. To be clamped by the host.
    pub layer: I,
    /// Texture coordinates; 0..1 is the texture.
    pub uv: [F; 2],
    /// Added to the texel coordinates.
    pub offset: [i32; 2],
    /// How wide the sample is.
    pub footprint: Footprint<F>,
}

/// How wide a sample is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Footprint<F = f64> {
    /// A mip level, 0 the finest.
    Level(F),
    /// Change of the coordinates per pixel.
    Gradient {
        /// To the right.
        ddx: [F; 2],
        /// Down.
        ddy: [F; 2],
    },
}

/// `textureLoad` at one point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Load<I = i32> {
    /// The host's id.
    pub texture: u32,
    /// Column and row.
    pub at: [I; 2],
    /// Array layer; 0 for plain textures.
    pub layer: I,
    /// Mip level.
    pub level: I,
}

/// A range of numbers, in order.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Within {
    /// The smallest.
    pub low: f64,
    /// The largest.
    pub high: f64,
}

/// Samples with coordinates in ranges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// The host's id.
    pub texture: u32,
    /// The host's id.
    pub sampler: u32,
    /// The first and the last array layer. To be clamped by the host.
    pub layers: (i32, i32),
    /// Texture coordinates; 0..1 is the texture.
    pub uv: [Within; 2],
    /// Added to the texel coordinates.
    pub offset: [i32; 2],
    /// How wide the samples are.
    pub footprint: Footprint<Within>,
}

/// No textures at all: for functions that read none.
#[derive(Clone, Copy, Debug)]
pub struct NoTextures;

impl Textures for NoTextures {
    fn sample(&self, _: &Sample) -> Option<[f64; 4]> {
        None
    }

    fn load(&self, _: &Load) -> Option<[f64; 4]> {
        None
    }

    fn size(&self, _: u32, _: u32) -> Option<[u32; 2]> {
        None
    }

    fn count(&self, _: u32) -> Option<Count> {
        None
    }
}
