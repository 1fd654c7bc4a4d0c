//! How shaders read a mip by the size of its map, and how the host has placed it.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use terrane_codegen::diagnostic::Sources;
use terrane_codegen::library::Library;
use terrane_codegen::machine::{F32, Machine, Value};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::{Bounds, Field, LARGE, Placed};

use super::machine::Placement;

const FIELD: &str = "
fn field(size: vec2i, mip: i32) -> ReliefField {
    var layer = DisplacedLayer();
    layer.size = size;
    return displaced_field(layer, mip);
}
";

/// The words of a field in the order of its members, without those that are not a matter of the size.
fn placement(field: &Field) -> Vec<i32> {
    let Field { wrap, last, corner, top, mip, patches, coarse, .. } = *field;
    [wrap, last, corner, [top, mip], patches, coarse].concat()
}

#[test]
fn shaders_read_mips_where_the_host_has_placed_them() {
    let library = Library::load(&mut Sources::default(), &[]).expect("the shipped library is right");
    let items = library.closure(FIELD);
    let text: String = items.iter().map(|item| library.slice(*item).to_owned() + "\n").chain([FIELD.into()]).collect();
    let module = naga::front::wgsl::parse_str(&text).expect("the library is right");
    let info = Validator::new(ValidationFlags::all(), Capabilities::all()).validate(&module).expect("as before");
    for size in [[1, 1], [4, 16], [256, 64], [LARGE, LARGE], [2 * LARGE, LARGE], [LARGE, LARGE / 2]] {
        let texels = Texels::U8(vec![0; (size[0] * size[1]) as usize]);
        let heights = Heights::new(size, Border::Wrap, texels).expect("a map of every size");
        let placed = Placed::new(&heights, Bounds::None, 1).expect("whole steps");
        let textures = Placement(&placed);
        for (mip, field) in placed.fields.iter().enumerate() {
            let machine = Machine::new(&module, &info, &textures);
            let arguments = [Value::integers(&[size.map(|side| side as i32)]), Value::i32(&[mip as i32])];
            let found = machine.call::<F32>("field", &arguments, 1).unwrap_or_else(|error| panic!("{error}")).0;
            let int = |at: usize| found.int_at(at, 0).expect("all of it is whole numbers") as i32;
            // Behind `top` stands the limit, behind `mip` the layer, behind `patches` the unit.
            let members = [0, 1, 2, 3, 4, 5, 6, 8, 10, 11, 13, 14].map(int);
            assert_eq!(members.to_vec(), placement(field), "{size:?}, mip {mip}");
        }
    }
}
