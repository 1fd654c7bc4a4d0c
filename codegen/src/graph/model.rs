//! A project after resolution: every name is bound, every input has a type, instances are still calls.

use std::collections::BTreeMap;

use crate::diagnostic::{SourceId, Span};
use crate::value::{Literal, Type};

/// Position in [`Graphs::graphs`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GraphId(pub usize);

/// Every graph that a terrain or a surface needs, instances before their users.
#[derive(Clone, Debug, Default)]
pub struct Graphs {
    /// Each file once, whatever number of users it has.
    pub graphs: Vec<Graph>,
}

/// What a graph is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// One material.
    Surface,
    /// A sub-graph, used like a kind.
    Instance,
    /// One number, 0..1, that says where a layer lies.
    Mask,
}

/// One surface, instance or mask file.
#[derive(Clone, Debug)]
pub struct Graph {
    /// The file.
    pub source: SourceId,
    /// Project-relative path of the file.
    pub path: String,
    /// File stem.
    pub name: String,
    /// What it is for.
    pub role: Role,
    /// What the author says of it.
    pub doc: String,
    /// Instances only.
    pub inputs: Vec<InstanceInput>,
    /// Surfaces and masks only. Sorted by name.
    pub parameters: Vec<Parameter>,
    /// Sorted by name.
    pub textures: Vec<Texture>,
    /// In dependency order, ties by name: the order in the file does not matter.
    pub nodes: Vec<Node>,
    /// By name. Surfaces: [`SURFACE_OUTPUTS`]; masks: `mask`; instances: free.
    pub outputs: BTreeMap<String, Output>,
    /// Surfaces only.
    pub relief: Option<Relief>,
}

/// The outputs of a surface: name, number of components, default where one exists.
pub const SURFACE_OUTPUTS: &[(&str, Type, Option<&[f32]>)] = &[
    ("mask", Type::F32, Some(&[1.0])),
    ("albedo", Type::Vec3, None),
    ("normal", Type::Vec3, Some(&[0.0, 0.0, 1.0])),
    ("roughness", Type::F32, Some(&[0.9])),
    ("metallic", Type::F32, Some(&[0.0])),
    ("occlusion", Type::F32, Some(&[1.0])),
    ("height", Type::F32, Some(&[0.5])),
    ("emissive", Type::Vec3, Some(&[0.0, 0.0, 0.0])),
];

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

/// An input of an instance.
#[derive(Clone, Debug)]
pub struct InstanceInput {
    /// Its name.
    pub name: String,
    /// `kind:` in the file; a number where nothing is said.
    pub ty: Type,
    /// Inclusive.
    pub range: Option<(f32, f32)>,
    /// What an unconnected input gets.
    pub default: Option<Literal>,
    /// Unit.
    pub unit: Option<String>,
    /// The name in the file.
    pub span: Span,
}

/// A value that can be tweaked while the shader runs.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// A number, a vector or a colour.
    pub ty: Type,
    /// Whether the vector is a colour, for a host's user interface.
    pub color: bool,
    /// Unit.
    pub unit: Option<String>,
    /// Inclusive.
    pub range: Option<(f32, f32)>,
    /// The value where nobody tweaks.
    pub default: Literal,
    /// What the author says of it.
    pub doc: String,
    /// The name in the file.
    pub span: Span,
}

/// How the bytes of a texture are to be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ColorSpace {
    /// Colours, decoded to linear by the sampler.
    Srgb,
    /// Data.
    Linear,
}

/// What happens outside 0..1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Wrap {
    /// Tiles.
    Repeat,
    /// Keeps the border.
    Clamp,
    /// Tiles, every second one mirrored.
    Mirror,
}

/// How texels become a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Filter {
    /// Trilinear.
    Linear,
    /// The nearest texel of the nearest mip.
    Nearest,
}

/// A texture as a graph declares it.
#[derive(Clone, Debug)]
pub struct Texture {
    /// Its name.
    pub name: String,
    /// Project-relative, normalised, inside the root; a PNG.
    pub file: String,
    /// How to read it.
    pub color: ColorSpace,
    /// Index of the one channel that is meant; a node that returns the texel then returns this number.
    pub channel: Option<u8>,
    /// Outside 0..1.
    pub wrap: Wrap,
    /// Filter.
    pub filter: Filter,
    /// 1..16.
    pub anisotropy: u8,
    /// Width and height, from the PNG's header or the recipe that makes it.
    pub size: (u32, u32),
    /// Bits per channel of the file: 8 or 16.
    pub depth: u8,
    /// The name in the file.
    pub span: Span,
}

/// What a node calls.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Callee {
    /// A function of the library, after overload resolution.
    Function {
        /// Kind name.
        kind: String,
        /// Position in [`crate::library::Kind::overloads`].
        overload: usize,
    },
    /// Another graph.
    Instance(GraphId),
}

/// One node.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its name.
    pub name: String,
    /// What it calls.
    pub callee: Callee,
    /// One for each input port of the callee, in its order.
    pub inputs: Vec<Input>,
    /// Component of the result that a texture's `channel` picks.
    pub channel: Option<u8>,
    /// Type of the result, after `channel`. For an instance with several outputs a wire must pick one by path.
    pub ty: Option<Type>,
    /// The whole `"name": kind(…)` entry.
    pub span: Span,
    /// The name alone.
    pub name_span: Span,
}

/// What an input port gets.
#[derive(Clone, Debug)]
pub struct Input {
    /// Where the value comes from.
    pub value: InputValue,
    /// Members and swizzles behind it, in order: `"stone.rgb"` has one.
    pub access: Vec<Access>,
    /// A number that goes to a vector port is spread over so many components.
    pub widen: Option<u8>,
    /// Type at the port, after access and widening.
    pub ty: Type,
    /// The argument in the file; the node's name for defaults.
    pub span: Span,
}

/// Where a value comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum InputValue {
    /// Written in the graph.
    Literal(Literal),
    /// The port's default.
    Default(Literal),
    /// Result of a node, by position in [`Graph::nodes`].
    Node(usize),
    /// Output of an instance node.
    NodeOutput {
        /// Position in [`Graph::nodes`].
        node: usize,
        /// Output of the instance.
        output: String,
    },
    /// From the host.
    Frame(FrameField),
    /// Position in [`Graph::parameters`].
    Parameter(usize),
    /// Position in [`Graph::inputs`].
    InstanceInput(usize),
    /// Position in [`Graph::textures`]; only at texture ports.
    Texture(usize),
}

/// A step from a value to a part of it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Access {
    /// Member of a struct.
    Member(String),
    /// One to four of `xyzw`, in letters `xyzw` whatever the author wrote.
    Swizzle(String),
}

impl Access {
    /// As it is written behind the dot.
    pub fn name(&self) -> &str {
        match self {
            Self::Member(name) | Self::Swizzle(name) => name,
        }
    }
}

/// An output of a graph.
#[derive(Clone, Debug)]
pub struct Output {
    /// The value.
    pub input: Input,
    /// Its unit, where one is known.
    pub unit: Option<String>,
    /// The name in the file.
    pub span: Span,
}

/// The displaced surface of a material.
#[derive(Clone, Debug)]
pub struct Relief {
    /// Position in [`Graph::textures`].
    pub texture: usize,
    /// A `Coord`.
    pub uv: Input,
    /// Metres from height 1 down to height 0.
    pub depth: f32,
    /// The entry in the file.
    pub span: Span,
}

/// How a layer's mask is given beside the surface's own.
#[derive(Clone, Debug)]
pub enum LayerMask {
    /// Everywhere.
    Full,
    /// Red channel of an image over the whole terrain.
    Painted(Texture),
    /// A mask graph.
    Graph(GraphId),
}

/// One material on a terrain.
#[derive(Clone, Debug)]
pub struct Layer {
    /// A surface.
    pub surface: GraphId,
    /// By parameter name; checked against type and range.
    pub parameters: BTreeMap<String, Literal>,
    /// Multiplies the surface's own mask.
    pub mask: LayerMask,
    /// The entry in the file.
    pub span: Span,
}

/// How materials meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blend {
    /// Strict order, each mask over what lies below.
    Over,
    /// The highest surface wins (Drobot 1.7.3).
    HeightMax,
    /// Every surface within a band under the highest takes part.
    HeightSoft {
        /// In units of height, 0.001..1.
        band: f32,
    },
}

/// The height map of a terrain.
#[derive(Clone, Debug)]
pub struct HeightMap {
    /// Project-relative; a grey PNG, 8 or 16 bit.
    pub file: String,
    /// Texels.
    pub texels: (u32, u32),
    /// Metres on x and z.
    pub size: (f32, f32),
    /// Metres at 0 and at full white.
    pub range: (f32, f32),
    /// The entry in the file.
    pub span: Span,
}

/// A terrain file.
#[derive(Clone, Debug)]
pub struct Terrain {
    /// The file.
    pub source: SourceId,
    /// Project-relative path.
    pub path: String,
    /// File stem.
    pub name: String,
    /// What the author says of it.
    pub doc: String,
    /// Its shape.
    pub height: HeightMap,
    /// Side of a patch in metres.
    pub patch: f32,
    /// Bottom to top; at least one.
    pub layers: Vec<Layer>,
    /// How they meet.
    pub blend: Blend,
    /// How the displaced surface is traced; without it relief is shaded as normal mapping.
    pub relief: Option<ReliefTrace>,
    /// Whether the terrain throws shadows on itself.
    pub shadow: Shadow,
    /// Whether the displaced surface throws shadows on itself.
    pub relief_shadow: ReliefShadow,
    /// Directions of the sky's occlusion by the terrain, 0 for none.
    pub occlusion: u32,
}

/// How a terrain traces the displaced surface of its materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReliefTrace {
    /// Which tracer.
    pub method: ReliefMethod,
    /// Where along the ray the masks are evaluated.
    pub weights: ReliefWeights,
    /// Metres from the eye: where relief begins to fade into normal mapping, and where it is gone.
    pub fade: (f32, f32),
}

/// Which tracer finds the displaced surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ReliefMethod {
    /// The fastest that keeps its error, on this map and platform.
    Auto {
        /// Texels of the height map, 0.001..64.
        max_error: f32,
    },
}

/// Where along a ray the masks of the layers are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefWeights {
    /// Once, where the ray enters: cheap, layers may float at seams.
    Entry,
    /// At every step, exact.
    AlongRay,
}

/// The sun's shadow at the scale of a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefShadow {
    /// None.
    Off,
    /// A ray to the middle of the sun.
    Hard,
    /// A cone: the further the blocker, the softer.
    Cone,
}

/// The sun's shadow at terrain scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadow {
    /// None.
    Off,
    /// A horizon for each texel, in the sun's direction.
    Horizon,
}

/// A picture to be taken.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The file.
    pub source: SourceId,
    /// Project-relative path.
    pub path: String,
    /// File stem.
    pub name: String,
    /// What the author says of it.
    pub doc: String,
    /// Its terrain.
    pub terrain: Terrain,
    /// Width and height in pixels.
    pub image: (u32, u32),
    /// Where from, where to.
    pub camera: Camera,
    /// Degrees: clockwise from north (−z), and above the horizon.
    pub sun: Sun,
    /// Preetham's turbidity, 1.8..10: 2 is arctic air, 10 is haze.
    pub turbidity: f32,
    /// Stops.
    pub exposure: f32,
}

/// Metres from the terrain's north-west corner (x east, y up, z south) and degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Eye.
    pub eye: [f32; 3],
    /// A point in the middle of the picture.
    pub target: [f32; 3],
    /// Vertical field of view.
    pub fov: f32,
}

/// Direction to the sun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sun {
    /// Degrees clockwise from north.
    pub azimuth: f32,
    /// Degrees above the horizon.
    pub elevation: f32,
}
