//! What the machine asks of its host: texels.

/// The host's textures and samplers, by the ids that it passed as arguments or bound to global variables.
pub trait Textures: Sync {
    /// A filtered sample; `None` if there is no such texture or sampler.
    fn sample(&self, sample: &Sample) -> Option<[f64; 4]>;

    /// One texel, integers as their value; zero outside the texture, `None` if there is no such texture.
    fn load(&self, load: &Load) -> Option<[f64; 4]>;

    /// Width and height of a mip level in texels, `None` if there is no such texture.
    fn size(&self, texture: u32, level: u32) -> Option<[u32; 2]>;

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
pub struct Sample {
    /// The host's id.
    pub texture: u32,
    /// The host's id.
    pub sampler: u32,
    /// Array layer; 0 for plain textures. To be clamped by the host.
    pub layer: i32,
    /// Texture coordinates; 0..1 is the texture.
    pub uv: [f64; 2],
    /// Added to the texel coordinates.
    pub offset: [i32; 2],
    /// How wide the sample is.
    pub footprint: Footprint,
}

/// How wide a sample is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Footprint {
    /// A mip level, 0 the finest.
    Level(f64),
    /// Change of the coordinates per pixel.
    Gradient {
        /// To the right.
        ddx: [f64; 2],
        /// Down.
        ddy: [f64; 2],
    },
}

/// `textureLoad` at one point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Load {
    /// The host's id.
    pub texture: u32,
    /// Column and row.
    pub at: [i32; 2],
    /// Array layer; 0 for plain textures.
    pub layer: i32,
    /// Mip level.
    pub level: i32,
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
