//! `ReliefField` of `wgsl/relief/relief.wgsl`.

/// How a shader reads one mip of a map, and its bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// Sides less 1 of a map that wraps, powers of two; −1 for one that does not.
    pub wrap: [i32; 2],
    /// The last column and row of texels.
    pub last: [i32; 2],
    /// What is added to a cell before it is shifted to a node of a level: that is its texel in the image of bounds. A level of
    /// n nodes a side then lies in rows n to 2n, and its mips beside each other.
    pub corner: [i32; 2],
    /// The coarsest level.
    pub top: i32,
    /// Nodes that may be visited before a search is given up.
    pub limit: u32,
    /// The mip of the heights.
    pub mip: i32,
    /// The layer of the textures.
    pub layer: i32,
    /// Where the first patch of the mip stands in an image of patches or of cells.
    pub patches: [i32; 2],
    /// log2 of the steps of height to a step of a wide node's base.
    pub unit: i32,
    /// Where the first coarse node of the mip stands in an image of cells; −1 where a search does not begin there.
    pub coarse: [i32; 2],
}

impl Field {
    /// The words of a uniform buffer.
    #[must_use]
    pub fn words(&self) -> [i32; 16] {
        let Self { wrap, last, corner, top, limit, mip, layer, patches, unit, coarse } = *self;
        // A limit beyond 2^31 keeps its bits.
        let [[a, b], [c, d], [e, f], [g, h], [i, j]] = [wrap, last, corner, patches, coarse];
        [a, b, c, d, e, f, top, limit as i32, mip, layer, g, h, unit, 0, i, j]
    }
}
