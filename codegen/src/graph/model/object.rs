//! Solids that stand on a terrain.

/// A solid on a terrain, of one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Its shape.
    pub solid: Solid,
    /// Its middle: metres from the terrain's north-west corner, x east, y up, z south.
    pub center: [f32; 3],
    /// What its middle's y counts from.
    pub from: HeightFrom,
    /// Linear, 0..1.
    pub albedo: [f32; 3],
    /// 0 is a mirror's, 1 is chalk's.
    pub roughness: f32,
}

/// The shape of an object, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// `sphere(…)`
    Sphere {
        /// Radius.
        radius: f32,
    },
    /// `box(…)`
    Box {
        /// Extent to the east, up and to the south, before it is turned.
        size: [f32; 3],
        /// Degrees clockwise, seen from above.
        turn: f32,
    },
    /// `column(…)`, a cylinder that stands upright.
    Column {
        /// Radius.
        radius: f32,
        /// From its foot to its top.
        height: f32,
    },
}

/// Where heights of an object begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HeightFrom {
    /// As for the camera.
    Zero,
    /// The height map under its middle; relief lies below.
    Ground,
}
