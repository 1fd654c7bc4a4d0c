//! The values of two programs of the same graphs, compared node by node.

use std::collections::BTreeMap;

use naga::TypeInner;
use terrane_codegen::compile::Compiled;
use terrane_codegen::emit::probe;
use terrane_codegen::graph::model::FrameField;
use terrane_codegen::library::Library;
use terrane_codegen::machine::{Count, F32, Load, Machine, Sample, Textures, Value};
use terrane_codegen::program::Program;

/// Points at which values are compared.
const POINTS: usize = 5;

/// The components of each node's value at every point, by graph path; integers by their bits.
#[derive(Default)]
struct Values {
    computed: BTreeMap<String, Vec<Vec<f32>>>,
    folded: BTreeMap<String, Vec<Vec<f32>>>,
}

/// How many nodes both programs compute; each has the same value in both, but for the sign of zero.
pub(crate) fn compare(library: &Library, optimised: &Compiled, plain: &Compiled) -> Result<usize, String> {
    let (left, right) = (values(library, optimised)?, values(library, plain)?);
    let mut compared = 0;
    for (path, value) in left.computed.iter().chain(&left.folded) {
        // A value that is shared with a dead node has that node's path as well; on its own the dead node is not computed.
        if let Some(other) = right.computed.get(path) {
            agree(path, value, other, plain)?;
            compared += 1;
        }
    }
    Ok(compared)
}

fn agree(path: &str, value: &[Vec<f32>], other: &[Vec<f32>], plain: &Compiled) -> Result<(), String> {
    let same = |a: &f32, b: &f32| a == b || a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    let equal = value.iter().flatten().zip(other.iter().flatten()).all(|(a, b)| same(a, b));
    if equal && value.len() == other.len() {
        return Ok(());
    }
    Err(format!("`{path}` is {value:?}, and {other:?} without optimisation\n{}", plain.core.text))
}

fn values(library: &Library, compiled: &Compiled) -> Result<Values, String> {
    let (program, probe) = (&compiled.program, probe(library, &compiled.program, &compiled.patch));
    let module = naga::front::wgsl::parse_str(&probe.shader.text).map_err(|error| error.to_string())?;
    let flags = naga::valid::ValidationFlags::all();
    let mut validator = naga::valid::Validator::new(flags, naga::valid::Capabilities::empty());
    let info = validator.validate(&module).map_err(|error| error.to_string())?;
    let textures = Painted(program);
    let machine = Machine::new(&module, &info, &textures);
    let (result, _) = machine
        .call::<F32>("terrane_probe", &arguments(&module, compiled), POINTS)
        .map_err(|error| format!("{error:?}\n{}", probe.shader.text))?;

    let mut found = Values::default();
    let mut at = 0;
    for id in &probe.members {
        let count = components(&module, program.pool.get(*id).ty.wgsl());
        let parts = (at..at + count).map(|component| lane(&result, component)).collect::<Vec<_>>();
        at += count;
        for origin in program.pool.origins(*id) {
            found.computed.insert(origin.path.clone(), parts.clone());
        }
    }
    for id in program.pool.ids() {
        let Some(literal) = program.pool.literal(id) else { continue };
        let parts: Vec<Vec<f32>> = literal.values().iter().map(|value| vec![*value; POINTS]).collect();
        for origin in program.pool.origins(id) {
            found.folded.insert(origin.path.clone(), parts.clone());
        }
    }
    Ok(found)
}

fn lane(value: &Value<F32>, component: usize) -> Vec<f32> {
    let at = |point| match value.float_at(component, point) {
        Some(float) => float,
        None => value.int_at(component, point).map_or(f32::NAN, f32::from_bits),
    };
    (0..POINTS).map(at).collect()
}

/// How many scalars a type has.
fn components(module: &naga::Module, name: &str) -> usize {
    match name {
        "f32" | "i32" | "u32" => 1,
        "vec2f" => 2,
        "vec3f" => 3,
        "vec4f" => 4,
        _ => module
            .types
            .iter()
            .find(|(_, ty)| ty.name.as_deref() == Some(name))
            .map_or(0, |(_, ty)| scalars(module, &ty.inner)),
    }
}

fn scalars(module: &naga::Module, inner: &TypeInner) -> usize {
    match inner {
        TypeInner::Scalar(_) => 1,
        TypeInner::Vector { size, .. } => *size as usize,
        TypeInner::Matrix { columns, rows, .. } => *columns as usize * *rows as usize,
        TypeInner::Struct { members, .. } => {
            members.iter().map(|member| scalars(module, &module.types[member.ty].inner)).sum()
        }
        _ => 0,
    }
}

/// One argument for each parameter of the probe, by its name.
fn arguments(module: &naga::Module, compiled: &Compiled) -> Vec<Value<F32>> {
    let function = module
        .functions
        .iter()
        .map(|(_, function)| function)
        .find(|function| function.name.as_deref() == Some("terrane_probe"));
    let names =
        function.into_iter().flat_map(|function| &function.arguments).filter_map(|argument| argument.name.clone());
    names.map(|name| argument(&name, compiled)).collect()
}

fn argument(name: &str, compiled: &Compiled) -> Value<F32> {
    let program = &compiled.program;
    match name {
        "terrain" => Value::join(compiled.manifest.inputs.iter().map(|input| frame(&input.name))),
        "parameters" => Value::join(
            program
                .parameters
                .iter()
                .flat_map(|parameter| parameter.default.values().into_iter().map(|value| Value::f32(&[value; POINTS]))),
        ),
        name => {
            let array = program.arrays.iter().position(|array| array.name() == name);
            Value::handle(array.unwrap_or(0) as u32)
        }
    }
}

/// Each frame field at every point: flat and steep, near and far from the corner.
fn frame(name: &str) -> Value<F32> {
    let field = FrameField::ALL.iter().find(|(_, known, _)| *known == name).map(|(field, ..)| *field);
    let gradient = |x: f32, z: f32| Value::vector(&[[x, 0.1, z]; POINTS]);
    match field.expect("the manifest names frame fields") {
        FrameField::Position => Value::join([
            Value::integers(&[[0, 0], [16_384, -16_384], [1_000_000, 3], [-7, 99_999], [256, 512]]),
            Value::vector(&[
                [0.0, 0.0, 0.0],
                [1.5, 20.0, 60.25],
                [33.3, 500.0, 0.1],
                [63.9, 80.0, 12.0],
                [7.0, 3.0, 31.0],
            ]),
            gradient(0.02, 0.0),
            gradient(0.0, 0.03),
        ]),
        FrameField::TerrainUv => Value::join([
            Value::vector(&[[0.0, 0.0], [0.25, 0.75], [0.5, 0.1], [1.0, 1.0], [0.33, 0.66]]),
            Value::vector(&[[1e-4, 0.0]; POINTS]),
            Value::vector(&[[0.0, 1e-4]; POINTS]),
        ]),
        FrameField::Height => Value::f32(&[0.0, 20.0, 500.0, 80.0, 3.0]),
        FrameField::Slope => Value::f32(&[0.0, 0.1, 0.5, 0.9, 0.3]),
        FrameField::Curvature => Value::f32(&[0.0, 0.2, -0.2, 0.01, -1.0]),
        FrameField::Distance => Value::f32(&[0.5, 10.0, 200.0, 3000.0, 50.0]),
        FrameField::Normal => {
            Value::vector(&[[0.0, 1.0, 0.0], [0.6, 0.8, 0.0], [0.0, 0.8, 0.6], [0.0, 0.6, -0.8], [0.48, 0.6, 0.64]])
        }
        FrameField::Sun => Value::vector(&[[0.48, 0.6, 0.64]; POINTS]),
    }
}

/// Textures whose texels depend on the file alone, whatever layer it lies in.
struct Painted<'a>(&'a Program);

impl Painted<'_> {
    fn texel(&self, texture: u32, layer: i32, at: [f64; 2]) -> Option<[f64; 4]> {
        let files = &self.0.arrays.get(texture as usize)?.files;
        let file = files.get(usize::try_from(layer).ok()?.min(files.len() - 1))?;
        let seed = file.bytes().fold(7.0, |sum, byte| sum * 1.7 % 97.0 + f64::from(byte));
        // Any smooth function does: both programs read the same one.
        let wave = |turn: f64| 0.5 + 0.5 * (std::f64::consts::TAU * (at[0] * turn + at[1]) + seed).sin();
        Some([wave(1.0), wave(2.0), wave(3.0), wave(4.0)].map(|value| f64::from(value as f32)))
    }
}

impl Textures for Painted<'_> {
    fn sample(&self, sample: &Sample) -> Option<[f64; 4]> {
        self.texel(sample.texture, sample.layer, sample.uv)
    }

    fn load(&self, load: &Load) -> Option<[f64; 4]> {
        self.texel(load.texture, load.layer, load.at.map(|at| f64::from(at) / 64.0))
    }

    fn size(&self, texture: u32, _: u32) -> Option<[u32; 2]> {
        self.0.arrays.get(texture as usize).map(|array| [array.size.0, array.size.1])
    }

    fn count(&self, texture: u32) -> Option<Count> {
        self.0.arrays.get(texture as usize).map(|array| Count { layers: array.files.len() as u32, levels: 1 })
    }
}
