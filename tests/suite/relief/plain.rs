//! A flat plain whose ground is one relief, seen from any place.

use std::fs;
use std::path::Path;

use glam::DVec3;
use tempfile::TempDir;
use terrane::render::material::Material;
use terrane::render::{
    Camera, Gpu, HeightField, Image, Object, Preview, Progress, RenderScene, Rendered, Searched, View, render_preview,
    render_with_depth, search_scene,
};
use terrane::scene::material;
use terrane_codegen::compile::{Compiled, Compiler};
use terrane_codegen::diagnostic::render;
use terrane_codegen::graph::Project;
use terrane_codegen::graph::model::{ReliefMethod, ReliefTrace};
use terrane_codegen::program::Options;
use terrane_shaderlib::heightfield::adversary::Random;
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::hosts::{self, Host};
use terrane_shaderlib::relief::Method;

/// Metres on a side of the plain.
const SIDE: f64 = 256.0;

/// The middle of the plain.
pub(super) const MIDDLE: DVec3 = DVec3::new(SIDE / 2.0, 0.0, SIDE / 2.0);

/// A relief and how it is traced.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    /// Metres of one tile.
    pub(super) tile: f64,
    /// Metres.
    pub(super) depth: f64,
    /// Metres from the eye to where it begins to fade and where it is gone.
    pub(super) fade: (f64, f64),
    /// `None` is what a terrain has where it wants the best.
    pub(super) method: Option<Method>,
    /// The node that gives its normals; `None` where the surface says nothing.
    pub(super) normal: Option<&'static str>,
}

/// A map that is as rough at every scale: blocks of 1 to 16 texels, each kind with a fifth of the height.
pub(super) fn rough(side: u32) -> Heights {
    rough_over([side; 2])
}

/// The same over sides that differ.
pub(super) fn rough_over([width, height]: [u32; 2]) -> Heights {
    let mut random = Random::new(5);
    let blocks = [1, 2, 4, 8, 16];
    let drawn = blocks.map(|_| (0..width * height).map(|_| random.between(0, 13_107) as u16).collect::<Vec<_>>());
    let sum = |x: u32, y: u32| {
        let layers = blocks.iter().zip(&drawn);
        layers.map(|(block, drawn)| drawn[(y / block * width + x / block) as usize]).sum()
    };
    let texels = (0..width * height).map(|at| sum(at % width, at / width)).collect();
    Heights::new([width, height], Border::Wrap, Texels::U16(texels)).expect("a map")
}

/// Pixels across and down.
pub(super) const IMAGE: [u32; 2] = [64, 128];

/// Deep stones, 32 texels to a metre where the map has 64.
pub(super) const SHAPE: Shape = Shape { tile: 2.0, depth: 0.25, fade: (20.0, 36.0), method: None, normal: None };

/// The part of the bytes of two pictures that differ by more than this.
pub(super) fn other(a: &[u8], b: &[u8], than: u8) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).filter(|(a, b)| a.abs_diff(**b) > than).count() as f64 / a.len() as f64
}

/// From over the finest mips of [`rough`] to the fourth at the upper border, some of them between two.
pub(super) const SLOPING: Camera =
    Camera { eye: [MIDDLE.x, 3.2, MIDDLE.z], target: [MIDDLE.x + 0.3, 0.0, MIDDLE.z - 5.5], fov: 52.0 };

/// What a pixel looks at.
pub(super) struct Sight {
    /// Its ray, of length 1.
    pub(super) ray: DVec3,
    /// Metres to the ground.
    pub(super) ground: f64,
    /// log2 of the texels that it is wide there.
    pub(super) level: f64,
}

/// All pixels, row by row, over a map of 64 texels.
pub(super) fn sights(view: &View) -> Vec<Sight> {
    let [width, height] = IMAGE.map(f64::from);
    let sight = |index: u32| {
        let [x, y] = [index % IMAGE[0], index / IMAGE[0]].map(|at| f64::from(at) + 0.5);
        let ray = view.ray(x / width, y / height);
        let ground = view.eye.y / -ray.y;
        let pixel = 2.0 * view.half[0] / width * ground;
        Sight { ray, ground, level: (pixel * 64.0 / SHAPE.tile).log2() }
    };
    (0..IMAGE[0] * IMAGE[1]).map(sight).collect()
}

/// The plain's project and its shaders.
pub(super) struct Plain {
    folder: TempDir,
    lit: Compiled,
    searched: Compiled,
    field: HeightField,
    objects: Vec<Object>,
}

impl Plain {
    /// A relief of 16 bits, which tiles.
    pub(super) fn new(heights: &Heights, shape: Shape) -> Self {
        Self::layered(&[heights], shape).unwrap_or_else(|findings| panic!("{findings}"))
    }

    /// Several that all have the same share of the ground, or why they cannot be compiled.
    pub(super) fn layered(maps: &[&Heights], shape: Shape) -> Result<Self, String> {
        let folder = tempfile::tempdir().expect("a writable temporary folder");
        for inside in ["graphs/surfaces", "graphs/terrains"] {
            fs::create_dir_all(folder.path().join(inside)).expect("a new folder");
        }
        let write = |path: &str, text: String| fs::write(folder.path().join(path), text).expect("a writable folder");
        write("terrane.ron", "Project(version: 1)\n".into());
        for (index, heights) in maps.iter().enumerate() {
            write(&format!("graphs/surfaces/relief_{index}.ron"), surface(index, maps.len(), shape));
            grey(&folder.path().join(format!("relief_{index}.png")), heights.size(), &texels(heights));
        }
        write("graphs/terrains/plain.ron", terrain(maps.len(), shape));
        grey(&folder.path().join("plain.png"), [4; 2], &[0; 16]);
        let lit = compile(&folder, &hosts::terrain())?;
        let searched = compile(&folder, &hosts::searched())?;
        let field = HeightField::new([4; 2], [SIDE / 4.0; 2], vec![0.0; 16]).expect("a flat map");
        Ok(Self { folder, lit, searched, field, objects: Vec::new() })
    }

    /// The same with objects on it.
    pub(super) fn furnished(mut self, objects: &[Object]) -> Self {
        self.lit = compile(&self.folder, &hosts::furnished()).unwrap_or_else(|findings| panic!("{findings}"));
        self.objects = objects.to_vec();
        self
    }

    /// The same with another text in place of one of its shader's.
    pub(super) fn replaced(mut self, from: &str, to: &str) -> Self {
        assert_eq!(self.lit.host.text.matches(from).count(), 1, "`{from}` is not what the shader says");
        self.lit.host.text = self.lit.host.text.replace(from, to);
        self
    }

    /// What is seen, and how far it is away.
    pub(super) fn render(&self, gpu: &Gpu, camera: Camera) -> Rendered {
        let material = material(&self.lit, self.folder.path());
        render_with_depth(gpu, &self.scene(camera, &self.lit, &material), Progress::Hidden).expect("it can be drawn")
    }

    /// What the search finds.
    pub(super) fn search(&self, gpu: &Gpu, camera: Camera) -> Searched {
        let material = material(&self.searched, self.folder.path());
        search_scene(gpu, &self.scene(camera, &self.searched, &material), Progress::Hidden).expect("it can be drawn")
    }

    /// Its first surface alone.
    pub(super) fn preview(&self, gpu: &Gpu, method: Method, host: &Host) -> Image {
        let mut project = open(&self.folder);
        let answer = project.surface("graphs/surfaces/relief_0.ron");
        let (graphs, surface, _) = answer.unwrap_or_else(|found| panic!("{}", render(&found, &project.sources, false)));
        let (library, sources) = (&project.library, &project.sources);
        let trace = ReliefTrace { method: ReliefMethod::Fixed(method), ..ReliefTrace::ALONE };
        let compiler = Compiler { library, sources, host, options: Options::default() };
        let compiled = compiler.surface(&graphs, surface, trace);
        let compiled = compiled.unwrap_or_else(|found| panic!("{}", render(&found, sources, false)));
        let material = &material(&compiled, self.folder.path());
        let preview = Preview { shader: &compiled.host.text, material, size: 4.0, image: [192, 108], supersampling: 1 };
        render_preview(gpu, &preview, Progress::Hidden).expect("it can be drawn")
    }

    fn scene<'a>(&'a self, camera: Camera, compiled: &'a Compiled, material: &'a Material) -> RenderScene<'a> {
        RenderScene {
            shader: &compiled.host.text,
            material,
            field: &self.field,
            shadow: false,
            occlusion: 0,
            surroundings: false,
            camera,
            sun: [250.0, 35.0],
            turbidity: 3.0,
            exposure: 0.0,
            objects: &self.objects,
            image: IMAGE,
            supersampling: 1,
            tolerance: 1.0,
        }
    }
}

/// The map as the device has it.
fn texels(heights: &Heights) -> Vec<u16> {
    let Texels::U16(texels) = heights.texels() else { panic!("maps of these tests have 16 bits") };
    texels.clone()
}

/// Writes a PNG of 16 bits.
fn grey(path: &Path, [width, height]: [u32; 2], texels: &[u16]) {
    let mut encoder = png::Encoder::new(fs::File::create(path).expect("a writable folder"), width, height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Sixteen);
    let bytes: Vec<u8> = texels.iter().flat_map(|texel| texel.to_be_bytes()).collect();
    encoder.write_header().and_then(|mut to| to.write_image_data(&bytes)).expect("a writable folder");
}

/// One of so many layers; one over others covers what is left to it of the ground.
fn surface(index: usize, count: usize, shape: Shape) -> String {
    let Shape { tile, depth, .. } = shape;
    let tilt = shape.normal.map(|node| format!(r#", "tilt": {node}"#)).unwrap_or_default();
    let normal = shape.normal.map_or("", |_| ", normal: tilt");
    let mask = 1.0 / (index + 1) as f64;
    let mask = if count > 1 { format!(", mask: {mask:?}") } else { String::new() };
    format!(
        r#"Surface(
    version: 1,
    doc: "A relief.",
    textures: {{ "relief": (file: "relief_{index}.png", color: linear, channel: r) }},
    nodes: {{ "uv": planar(position: position, tile: {tile:?}){tilt} }},
    outputs: (albedo: (0.4, 0.4, 0.4){mask}{normal}, relief: (height: relief, uv: uv, depth: {depth:?})),
)
"#
    )
}

fn terrain(layers: usize, shape: Shape) -> String {
    let layer = |index: usize| format!(r#"(surface: "graphs/surfaces/relief_{index}.ron")"#);
    let layers: Vec<String> = (0..layers).map(layer).collect();
    let method = shape.method.map_or_else(|| "auto(max_error: 0.5)".to_owned(), |method| method.to_string());
    format!(
        r#"Terrain(
    version: 1,
    height: (file: "plain.png", size: ({SIDE:?}, {SIDE:?}), range: (0.0, 1.0)),
    layers: [{}],
    relief: (method: {method}, fade: {:?}),
    shadow: (terrain: off, relief: cone),
    occlusion: (terrain: off, relief: directions(4)),
)
"#,
        layers.join(", "),
        shape.fade
    )
}

fn open(folder: &TempDir) -> Project {
    Project::open(folder.path()).unwrap_or_else(|error| panic!("{:?}", error.diagnostics))
}

fn compile(folder: &TempDir, host: &Host) -> Result<Compiled, String> {
    let mut project = open(folder);
    let answer = project.terrain("graphs/terrains/plain.ron");
    let (graphs, terrain, _) = answer.map_err(|found| render(&found, &project.sources, false))?;
    let (library, sources) = (&project.library, &project.sources);
    let compiled = Compiler { library, sources, host, options: Options::default() }.terrain(&graphs, &terrain);
    compiled.map_err(|found| render(&found, sources, false))
}
