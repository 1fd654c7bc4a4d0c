//! Maps that wrap though their sides are no powers of two.

use terrane::measure::Judge;
use terrane::relief::{Outcome, Traced, Tracer};
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
    for method in [Method::Walk, Method::Sprint, Method::MaximumMipmaps] {
        let placed = Placed::new(&heights, method.bounds(), LIMIT).expect("whole steps can be placed");
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let (traced, _) = tracer.trace(&[TOUCHES]).expect("the device answers");
        assert_eq!(fault(&heights, &TOUCHES, &traced[0]), None, "{method}");
    }
}

/// A ray that keeps near the saddles of 1,920 cells and so meets none of their corners. A third is no f32: at its end it runs
/// 2e-5 texels beside itself, on a slope of the whole height in a texel.
const BETWEEN: Segment = Segment {
    ray: Ray {
        origin: [118.199_218_75, 683.933_593_75, 60_335.269_531_25],
        direction: [0.105_468_75, -0.035_156_25, -0.914_062_5],
    },
    range: (0.0, 19_094.0),
};

#[test]
fn after_two_thousand_cells_a_hit_is_that_of_a_ray_beside() {
    let Some(gpu) = device() else { return };
    let size = [300, 700];
    let heights = map(Land::Checkerboard, size, Border::Wrap, Depth::Sixteen, 0x0730_e504_d126_97b9).expect("a size");
    let judge = Judge::new(&heights, BETWEEN);
    for method in [Method::Walk, Method::Sprint, Method::Wide] {
        let placed = Placed::new(&heights, method.bounds(), LIMIT).expect("whole steps can be placed");
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let (traced, _) = tracer.trace(&[BETWEEN]).expect("the device answers");
        assert!(judge.is_beside(&traced[0]), "{method}: {}", judge.describe(&traced[0]));
        // But no ray beside it is stopped before it has gone a cell.
        assert!(!judge.is_beside(&Traced { outcome: Outcome::Hit(1.0), ..traced[0] }));
    }
}
