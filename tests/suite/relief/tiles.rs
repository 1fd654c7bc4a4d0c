//! Maps that wrap though their sides are no powers of two.

use terrane::relief::Tracer;
use terrane_shaderlib::heightfield::adversary::{Depth, Land, map};
use terrane_shaderlib::heightfield::{Border, Ray};
use terrane_shaderlib::relief::{Method, Placed};

use super::{LIMIT, Segment, device, fault};

/// A ray that touches a saddle which bends so little that a step of height is a thirtieth of a texel there, on a slope of
/// most of the height in one texel: a start that is off by 3e-5 texels in row 610 moves the hit by more than that.
const TOUCHES: Segment = Segment {
    ray: Ray { origin: [117.3125, 622.6875, 802_843.875], direction: [0.824_218_75, -0.824_218_75, -48_149.210_937_5] },
    range: (0.0, 2453.0),
};

#[test]
fn a_start_hundreds_of_cells_into_a_tile_keeps_its_place_in_the_cell() {
    let Some(gpu) = device() else { return };
    let heights = map(Land::Noise, [300, 700], Border::Wrap, Depth::Sixteen, 0xdcfb_f025_7f75_609f).expect("a size");
    assert_eq!(heights.corners(130, 609), [15710.0, 2987.0, 61405.0, 49724.0], "the map is another");
    for method in [Method::Walk, Method::Sprint, Method::Leap, Method::MaximumMipmaps] {
        let placed = Placed::new(&heights, method.bounds(), LIMIT).expect("whole steps can be placed");
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let (traced, _) = tracer.trace(&[TOUCHES]).expect("the device answers");
        assert_eq!(fault(&heights, &TOUCHES, &traced[0]), None, "{method}");
    }
}
