//! The shader library on the machine.

use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_codegen::machine::probe::arguments;
use terrane_codegen::machine::{Accept, F32, F64, Image, Images, Machine, NoTextures, Sampler, Value, Wrap};

#[test]
fn every_function_of_the_library_can_be_evaluated() {
    let library = Library::load(&mut Sources::default(), &[]).expect("the shipped library is right");
    let machine = Machine::new(&library.module, &library.info, &NoTextures);
    let functions = library.module.functions.iter().filter_map(|(_, function)| function.name.as_deref());
    let wrong: Vec<String> =
        functions.filter_map(|name| machine.supports(name).err()).map(|error| error.to_string()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The texture of the library's examples: texel (x, y) of 4 x 4 is (x / 3, y / 3, (x + y) % 2, 1).
fn example() -> Images {
    let texel = |i: u32| [f64::from(i % 4) / 3.0, f64::from(i / 4) / 3.0, f64::from((i % 4 + i / 4) % 2), 1.0];
    Images {
        images: vec![Image::new(4, 4, 1, (0..16).map(texel).collect())],
        samplers: vec![Sampler { wrap: Wrap::Repeat, linear: true, linear_levels: true, anisotropy: 1 }],
    }
}

const POINTS: usize = 300;

#[test]
fn both_precisions_of_every_node_are_accepted() {
    let library = Library::load(&mut Sources::default(), &[]).expect("the shipped library is right");
    let images = example();
    let machine = Machine::new(&library.module, &library.info, &images);
    let (mut all, mut bounded) = (0, 0);
    for overload in library.kinds.values().flat_map(|kind| &kind.overloads) {
        let function = overload.function.as_str();
        let arguments = arguments(overload, POINTS, 1).expect("the types of ports are known");
        let double: Vec<Value<F64>> = arguments.iter().map(Value::to).collect();
        let wide: Vec<Value<Accept>> = arguments.iter().map(Value::to).collect();
        let (single, _) = machine.call::<F32>(function, &arguments, POINTS).expect("it runs");
        let (double, _) = machine.call::<F64>(function, &double, POINTS).expect("it runs");
        let (accepted, _) = machine.call::<Accept>(function, &wide, POINTS).expect("it runs");
        for (i, point) in (0..single.components.len()).flat_map(|i| (0..POINTS).map(move |point| (i, point))) {
            let Some(interval) = accepted.float_at(i, point) else { continue };
            let (single, double) = (single.float_at(i, point).expect("f32"), double.float_at(i, point).expect("f64"));
            assert!(interval.accepts(single), "{function}, {i} at {point}: {single:?} is not in {interval:?}");
            assert!(interval.holds(double), "{function}, {i} at {point}: {double:?} is not in {interval:?}");
            all += 1;
            bounded += u32::from(!interval.is_unbounded());
        }
        report(function, &accepted);
    }
    assert!(bounded * 100 > all * 99, "only {bounded} of {all} results of nodes have bounds");
}

/// For the eye: how many results are unbounded, and how wide the others are.
fn report(function: &str, accepted: &Value<Accept>) {
    let intervals = (0..accepted.components.len())
        .flat_map(|i| (0..POINTS).filter_map(move |point| accepted.float_at(i, point)))
        .collect::<Vec<_>>();
    let mut widths: Vec<f32> = intervals
        .iter()
        .filter(|interval| !interval.is_unbounded())
        .map(|interval| interval.high() - interval.low())
        .collect();
    widths.sort_by(f32::total_cmp);
    let at = |share: usize| widths.get(widths.len() * share / 100).copied().unwrap_or_default();
    let unbounded = 100 * (intervals.len() - widths.len()) / intervals.len().max(1);
    println!("{function:28} unbounded {unbounded:3} %, width median {:.1e}, 90 % {:.1e}", at(50), at(90));
}
