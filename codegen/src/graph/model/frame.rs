//! What a host gives to every graph.

use crate::value::Type;

/// What a host gives to every graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FrameField {
    /// `position: Place`: where on the terrain, with screen gradients; never a large float.
    Position,
    /// `terrain_uv: Coord`: 0..1 over the whole terrain.
    TerrainUv,
    /// `height: f32`: metres.
    Height,
    /// `slope: f32`: 1 − normal.y; 0 is flat, 1 is a wall.
    Slope,
    /// `normal: vec3f`: of the ground, in world space, y up.
    Normal,
    /// `curvature: f32`: 1/m; positive on ridges, negative in hollows.
    Curvature,
    /// `distance: f32`: metres from the eye.
    Distance,
    /// `sun: vec3f`: unit vector to the sun.
    Sun,
}

impl FrameField {
    /// Every field, its name in graphs and in `TerrainIn`, and its unit.
    pub const ALL: &[(Self, &str, Option<&str>)] = &[
        (Self::Position, "position", None),
        (Self::TerrainUv, "terrain_uv", None),
        (Self::Height, "height", Some("m")),
        (Self::Slope, "slope", None),
        (Self::Normal, "normal", None),
        (Self::Curvature, "curvature", Some("1/m")),
        (Self::Distance, "distance", Some("m")),
        (Self::Sun, "sun", None),
    ];

    /// Its name in graphs and in `TerrainIn`.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(field, ..)| *field == self).map_or("", |(_, name, _)| name)
    }

    /// Its type.
    pub fn ty(self) -> Type {
        match self {
            Self::Position => Type::Struct("Place".into()),
            Self::TerrainUv => Type::Struct("Coord".into()),
            Self::Height | Self::Slope | Self::Curvature | Self::Distance => Type::F32,
            Self::Normal | Self::Sun => Type::Vec3,
        }
    }
}
