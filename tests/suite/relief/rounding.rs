//! Rays of which the last digits of f32 decide what they meet.

use terrane::measure::Judge;
use terrane::relief::{Outcome, Traced, Tracer};
use terrane_shaderlib::heightfield::adversary::{Depth, Land, map};
use terrane_shaderlib::heightfield::{Border, Heights, Ray};
use terrane_shaderlib::relief::{Method, Placed};

use super::{LIMIT, Segment, device};

fn checkerboard(size: [u32; 2], variant: u64) -> Heights {
    map(Land::Checkerboard, size, Border::Wrap, Depth::Sixteen, variant).expect("a size")
}

const fn segment(origin: [f64; 3], direction: [f64; 3], end: f64) -> Segment {
    Segment { ray: Ray { origin, direction }, range: (0.0, end) }
}

/// What each method finds.
fn found(heights: &Heights, segment: &Segment) -> Option<Vec<(Method, Traced)>> {
    let gpu = device()?;
    let one = |method: Method| {
        let placed = Placed::new(heights, method.bounds(), LIMIT).expect("whole steps can be placed");
        let tracer = Tracer::new(&gpu, heights, &placed, method).expect("the device takes it");
        (method, tracer.trace(std::slice::from_ref(segment)).expect("the device answers").0[0])
    };
    Some([Method::Walk, Method::Sprint, Method::Leap, Method::Wide, Method::MaximumMipmaps].map(one).into())
}

/// A ray that keeps near the saddles of 1,920 cells and so meets none of their corners. A third is no f32: at its end it runs
/// 2e-5 texels beside itself, on a slope of the whole height in a texel.
const BETWEEN: Segment =
    segment([118.199_218_75, 683.933_593_75, 60_335.269_531_25], [0.105_468_75, -0.035_156_25, -0.914_062_5], 19_094.0);

#[test]
fn after_two_thousand_cells_a_hit_is_that_of_a_ray_beside() {
    let heights = checkerboard([300, 700], 0x0730_e504_d126_97b9);
    let judge = Judge::new(&heights, BETWEEN);
    for (method, traced) in found(&heights, &BETWEEN).into_iter().flatten() {
        assert!(judge.is_beside(&traced), "{method}: {}", judge.describe(&traced));
        // But no ray beside it is stopped before it has gone a cell.
        assert!(!judge.is_beside(&Traced { outcome: Outcome::Hit(1.0), ..traced }));
    }
}

/// A ray that passes tips by thousandths of a step, of which it touches the first at t = 2, or another up to 750 texels on.
const OVER_TIPS: Segment = segment(
    [-48_772_604.054_687_5, 226_209_284.671_875, 65_535.007_812_5],
    [-1.472_656_25, -2.335_937_5, -0.003_906_25],
    883.0,
);

#[test]
fn which_of_many_tips_a_ray_touches_is_decided_by_rounding() {
    let heights = checkerboard([512, 512], 0x14da_a310_d743_fa2b);
    let judge = Judge::new(&heights, OVER_TIPS);
    for (method, traced) in found(&heights, &OVER_TIPS).into_iter().flatten() {
        assert_eq!(judge.fault(&traced), None, "{method}: {}", judge.describe(&traced));
        let distance = judge.distance(&traced).expect("it hits, and does not graze");
        assert!(distance < 5e-4 || judge.is_excused(&traced, distance), "{method}: {}", judge.describe(&traced));
        // Before the first tip and behind the last no hit is excused.
        for t in [1.0, 500.0] {
            assert!(!judge.is_excused(&Traced { outcome: Outcome::Hit(t), ..traced }, 1.0), "{method} at {t}");
        }
    }
}
