//! A small map and one ray over it.

use terrane::relief::{Outcome, Segment, Traced, Tracer};
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::{Border, Heights, Ray, Texels, first_hit};
use terrane_shaderlib::relief::{Method, Placed};

/// Nodes that no search over these maps needs. llvmpipe leaves a loop after 65535 rounds, whatever it says.
pub(super) const ENOUGH: u32 = 1 << 14;
/// Texels by which an exact method may be off here: far more than rounding, far less than any defect.
const CLOSE: f64 = 1e-3;

/// A map that tiles, and a ray with |x| or |y| of its direction 1, so that t counts texels.
pub(super) struct Scene {
    pub(super) heights: Heights,
    pub(super) segment: Segment,
}

impl Scene {
    /// The ray goes on until it is 2 steps below 0.
    pub(super) fn new(size: [u32; 2], height: impl Fn(u32, u32) -> u16, origin: [f64; 3], direction: [f64; 3]) -> Self {
        let texels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y])).map(|[x, y]| height(x, y)).collect();
        let heights = Heights::new(size, Border::Wrap, Texels::U16(texels)).expect("a map");
        let end = (origin[2] + 2.0) / -direction[2];
        Self { heights, segment: Segment { ray: Ray { origin, direction }, range: (0.0, end) } }
    }

    /// Where the ray meets the ground.
    pub(super) fn truth(&self) -> f64 {
        first_hit(&self.heights, &self.segment.ray, self.segment.range).expect("the ground is under every ray").t
    }

    /// How high the ray is at t.
    pub(super) fn height(&self, t: f64) -> f64 {
        self.segment.ray.at(t)[2]
    }

    pub(super) fn trace(&self, gpu: &Gpu, method: Method) -> Traced {
        let placed = Placed::new(&self.heights, method.bounds(), ENOUGH).expect("sides are powers of two");
        let tracer = Tracer::new(gpu, &self.heights, &placed, method).expect("the device takes it");
        tracer.trace(&[self.segment]).expect("the device answers").0[0]
    }

    /// Where a method says that the ray meets the ground.
    #[track_caller]
    pub(super) fn hit(&self, gpu: &Gpu, method: Method) -> f64 {
        match self.trace(gpu, method).outcome {
            Outcome::Hit(t) => t,
            outcome => panic!("{method}: {outcome:?}"),
        }
    }

    #[track_caller]
    pub(super) fn expect_endless(&self, gpu: &Gpu, method: Method) {
        let traced = self.trace(gpu, method);
        assert_eq!((traced.outcome, traced.steps), (Outcome::Unresolved, ENOUGH), "{method}");
    }

    #[track_caller]
    pub(super) fn expect_right(&self, gpu: &Gpu, method: Method) {
        let (found, truth) = (self.hit(gpu, method), self.truth());
        assert!((found - truth).abs() < CLOSE, "{method}: {found}, not {truth}");
    }

    /// A hit so many texels or more behind the true one, but for rounding.
    #[track_caller]
    pub(super) fn expect_late(&self, gpu: &Gpu, method: Method, texels: f64) {
        let (found, truth) = (self.hit(gpu, method), self.truth());
        assert!(found > truth + texels - CLOSE, "{method}: {found}, the truth is {truth}");
    }
}

/// 8 × 8 texels at 0, with a wall of height 600 along one column; a ray that begins a step above it and is on the ground 9.4
/// texels on.
pub(super) fn wall(column: u32, origin: [f64; 2], direction: [f64; 2]) -> Scene {
    let height = move |x, _| if x == column { 600 } else { 0 };
    Scene::new([8, 8], height, [origin[0], origin[1], 601.0], [direction[0], direction[1], -64.0])
}
