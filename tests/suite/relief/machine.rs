//! Relief methods on the machine, in f32 and in f64, against the reference and the device.

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use terrane::measure::Judge;
use terrane::relief::{Outcome, Segment, Setup, Traced, Tracer, shader, tiled_shader};
use terrane_codegen::machine::domain::Cell;
use terrane_codegen::machine::{Count, Domain, F32, F64, Load, Machine, Sample, Textures, Value};
use terrane_shaderlib::heightfield::Heights;
use terrane_shaderlib::relief::{Field, Method, Placed, Plane};

use super::{LIMIT, device, lands};

/// The textures of a placed map: 0 its heights, 1 its bounds.
pub(super) struct Placement<'a>(pub(super) &'a Placed);

impl Placement<'_> {
    fn plane(&self, texture: u32) -> Option<&Plane> {
        [&self.0.heights, &self.0.bounds].get(texture as usize).copied()
    }
}

impl Textures for Placement<'_> {
    fn sample(&self, _: &Sample) -> Option<[f64; 4]> {
        None
    }

    fn load(&self, load: &Load) -> Option<[f64; 4]> {
        let plane = self.plane(load.texture)?;
        let texel = || {
            let at = [u32::try_from(load.at[0]).ok()?, u32::try_from(load.at[1]).ok()?];
            plane.texel(usize::try_from(load.level).ok()?, at)
        };
        Some(texel().unwrap_or([0, 0, 0, 1]).map(f64::from))
    }

    fn size(&self, texture: u32, level: u32) -> Option<[u32; 2]> {
        self.plane(texture).map(|plane| plane.size.map(|side| (side >> level).max(1)))
    }

    fn count(&self, texture: u32) -> Option<Count> {
        self.plane(texture).map(|plane| Count { layers: 1, levels: plane.mips() as u32 })
    }
}

/// A method's shader as naga sees it, for maps that are traced whole and for those tile by tile.
struct Shaders([(naga::Module, ModuleInfo); 2]);

impl Shaders {
    fn new(method: Method) -> Self {
        // The entry point calls the method itself; the machine calls a function.
        let call = method.call("relief_heights", "relief_bounds", "tiles", "ray");
        let whole = format!("fn relief_found(tiles: ReliefField, ray: ReliefRay) -> ReliefHit {{ return {call}; }}");
        Self([shader(method) + &whole, tiled_shader(method)].map(|text| {
            let module = naga::front::wgsl::parse_str(&text).expect("Tint and the device take it");
            let info = Validator::new(ValidationFlags::all(), Capabilities::all()).validate(&module);
            (module, info.expect("Tint and the device take it"))
        }))
    }

    /// What the machine finds.
    fn trace<D: Domain>(&self, heights: &Heights, placed: &Placed, rays: &[Segment]) -> Vec<Traced>
    where
        D::Float: Into<f64>,
        D::Int: Into<u32> + Cell,
    {
        let (module, info) = &self.0[usize::from(placed.tiled)];
        let textures = Placement(placed);
        let mut machine = Machine::new(module, info, &textures);
        machine.set_iteration_limit(2 * LIMIT);
        machine.bind("relief_heights", 0).expect("the shader has it");
        machine.bind("relief_bounds", 1).expect("the shader has it");
        let setups: Vec<Option<Setup>> = rays.iter().map(|ray| Setup::new(heights, placed.range, ray)).collect();
        let sent: Vec<Setup> = setups.iter().flatten().copied().collect();
        let found = (!sent.is_empty()).then(|| {
            let arguments = [field(&placed.fields[0]), rays_of(&sent)];
            machine.call::<D>("relief_found", &arguments, sent.len()).unwrap_or_else(|error| panic!("{error}")).0
        });
        let mut next = 0..;
        let traced = setups.iter().map(|setup| match (setup, &found) {
            (Some(setup), Some(found)) => traced(setup, found, next.next().expect("endless")),
            _ => Traced { outcome: Outcome::Miss, cell: [0; 2], steps: 0, leaves: 0 },
        });
        traced.collect()
    }
}

/// `ReliefField`.
fn field<D: Domain>(field: &Field) -> Value<D> {
    let pairs = [field.wrap, field.last, field.corner].map(|pair| Value::integers(&[pair]));
    let rest = [Value::i32(&[field.top]), Value::u32(&[field.limit]), Value::integers(&[[field.mip, field.layer]])];
    let last = [Value::integers(&[field.patches]), Value::i32(&[field.unit]), Value::integers(&[field.coarse])];
    Value::join(pairs.into_iter().chain(rest).chain(last))
}

/// `ReliefRay`.
fn rays_of<D: Domain>(setups: &[Setup]) -> Value<D> {
    Value::join([
        Value::integers(&setups.iter().map(|setup| setup.ray.cell.map(i32::from)).collect::<Vec<_>>()),
        Value::vector(&setups.iter().map(|setup| setup.ray.origin).collect::<Vec<_>>()),
        Value::vector(&setups.iter().map(|setup| setup.ray.direction).collect::<Vec<_>>()),
        Value::f32(&setups.iter().map(|setup| setup.ray.end).collect::<Vec<_>>()),
    ])
}

/// One `ReliefHit`.
fn traced<D: Domain>(setup: &Setup, found: &Value<D>, point: usize) -> Traced
where
    D::Float: Into<f64>,
    D::Int: Into<u32>,
{
    let int = |component: usize| found.int_at(component, point).map_or(0, Into::into);
    let t: f64 = found.float_at(0, point).expect("t is a float").into();
    let outcome = match int(1) {
        0 if setup.is_cut => Outcome::Unresolved,
        0 => Outcome::Miss,
        // The way back takes the t of a device, of which one of f64 has bits that it lacks.
        1 => Outcome::Hit(setup.t(t as f32)),
        _ => Outcome::Unresolved,
    };
    let cell = if matches!(outcome, Outcome::Hit(_)) { setup.cell([int(2) as i32, int(3) as i32]) } else { [0; 2] };
    Traced { outcome, cell, steps: int(4), leaves: int(5) }
}

/// The number of rays, and what is wrong.
fn judge<D: Domain>(method: Method, rays: usize) -> (usize, Vec<String>)
where
    D::Float: Into<f64>,
    D::Int: Into<u32>,
{
    let shaders = Shaders::new(method);
    let (mut count, mut faults) = (0, Vec::new());
    for (heights, sent) in lands(rays, 21) {
        let placed = Placed::new(&heights, method.bounds(), LIMIT).expect("whole steps");
        let traced = shaders.trace::<D>(&heights, &placed, &sent);
        count += sent.len();
        faults.extend(sent.iter().zip(&traced).filter_map(|(segment, traced)| super::fault(&heights, segment, traced)));
    }
    (count, faults)
}

#[test]
fn exact_methods_are_exact_on_the_machine() {
    for method in [Method::Walk, Method::MaximumMipmaps] {
        for (count, faults) in [judge::<F32>(method, 24), judge::<F64>(method, 24)] {
            assert!(count > 5000, "only {count} rays");
            assert!(faults.is_empty(), "{method}: {} of {count}\n{:#?}", faults.len(), &faults[..faults.len().min(4)]);
        }
    }
}

#[test]
fn the_machine_sees_that_linear_search_is_not() {
    let (count, faults) = judge::<F32>(Method::Linear(64, 6), 12);
    assert!(faults.len() > count / 20, "{} of {count}", faults.len());
}

/// Texels of path between what machine and device find: each may round a position by half of it.
const TEXELS: f64 = 2e-3;

#[test]
fn machine_and_device_meet_the_same_ground() {
    let Some(gpu) = device() else { return };
    let method = Method::Walk;
    let shaders = Shaders::new(method);
    let (mut count, mut other) = (0, Vec::new());
    for (heights, sent) in lands(24, 22) {
        let placed = Placed::new(&heights, method.bounds(), LIMIT).expect("whole steps");
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let (device, _) = tracer.trace(&sent).expect("the device answers");
        let machine = shaders.trace::<F32>(&heights, &placed, &sent);
        for ((segment, a), b) in sent.iter().zip(&device).zip(&machine) {
            count += 1;
            let judge = Judge::new(&heights, *segment);
            let near = match (a.outcome, b.outcome) {
                (Outcome::Hit(a), Outcome::Hit(b)) => (a - b).abs() * judge.fastest() <= TEXELS,
                (a, b) => a == b,
            };
            // On a border between cells both are right.
            let apart = (0..2).map(|axis| a.cell[axis].abs_diff(b.cell[axis])).max();
            if (!near || apart > Some(1)) && !judge.is_decided_by_rounding() {
                other.push(format!("{} {b:?}", judge.describe(a)));
            }
        }
    }
    assert!(other.is_empty(), "{} of {count}: {:#?}", other.len(), &other[..other.len().min(4)]);
}
