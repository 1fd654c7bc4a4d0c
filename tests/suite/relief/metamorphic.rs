//! What must not change an outcome: a symmetry of map and ray, whole tiles, the level that a search starts at, the method.

use terrane::measure::Judge;
use terrane::relief::{Outcome, Segment, Traced, Tracer};
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::adversary::{Depth, Land, map};
use terrane_shaderlib::heightfield::{Border, Heights, Ray, Texels};
use terrane_shaderlib::relief::{Method, Placed};

use super::{LIMIT, device, lands};

const EXACT: [Method; 2] = [Method::Walk, Method::MaximumMipmaps];
/// Texels of path between two outcomes that are the same, each of which may be off by half of it.
const TEXELS: f64 = 2e-3;
/// Pairs of outcomes of a ray.
#[derive(Default)]
struct Agreement {
    rays: usize,
    /// Those that differ although no rounding decides what the ray meets.
    apart: Vec<String>,
}

impl Agreement {
    /// Both must be right.
    fn add(&mut self, judges: [&Judge<'_>; 2], traced: [&Traced; 2]) {
        self.rays += 1;
        for (judge, traced) in judges.iter().zip(traced) {
            assert_eq!(judge.fault(traced), None, "{}", judge.describe(traced));
        }
        if !same(judges[0], traced) && !judges.iter().any(|judge| judge.is_decided_by_rounding()) {
            self.apart.push(format!("{} {}", judges[0].describe(traced[0]), judges[1].describe(traced[1])));
        }
    }

    #[track_caller]
    fn assert(&self, what: &str) {
        let (many, first) = (self.apart.len(), self.apart.iter().take(4).collect::<Vec<_>>());
        assert!(self.rays > 1000 && many == 0, "{what}: {many} of {} differ: {first:#?}", self.rays);
    }
}

fn same(judge: &Judge<'_>, [a, b]: [&Traced; 2]) -> bool {
    match (a.outcome, b.outcome) {
        (Outcome::Hit(a), Outcome::Hit(b)) => (a - b).abs() * judge.fastest() <= TEXELS,
        (a, b) => a == b,
    }
}

/// A method that is compiled once for maps that are traced whole and once for those tile by tile.
struct Compiled<'a>([Tracer<'a>; 2]);

impl Compiled<'_> {
    fn trace(&self, heights: &Heights, placed: &Placed, rays: &[Segment]) -> Vec<Traced> {
        let tracer = self.0[usize::from(placed.tiled)].over(heights, placed).expect("the device takes it");
        tracer.trace(rays).expect("the device answers").0
    }
}

fn placed(heights: &Heights, method: Method) -> Placed {
    Placed::new(heights, method.bounds(), LIMIT).expect("whole steps")
}

/// Runs a check for each exact method.
fn each(mut check: impl FnMut(Method, &Compiled<'_>)) {
    let Some(gpu) = device() else { return };
    let small = [[1, 1], [3, 3]].map(|size| map(Land::Low, size, Border::Wrap, Depth::Sixteen, 0).expect("a map"));
    for method in EXACT {
        check(method, &compiled(&gpu, &small, method));
    }
}

fn compiled<'a>(gpu: &'a Gpu, small: &'a [Heights; 2], method: Method) -> Compiled<'a> {
    let tracer = |heights| Tracer::new(gpu, heights, &placed(heights, method), method).expect("the device takes it");
    Compiled(small.each_ref().map(tracer))
}

/// A symmetry of the square: axes swapped or not, each of them turned round or not.
#[derive(Clone, Copy, Debug)]
struct Symmetry {
    swap: bool,
    flip: [bool; 2],
}

impl Symmetry {
    fn all() -> impl Iterator<Item = Self> {
        (0..8).map(|bits| Self { swap: bits & 4 != 0, flip: [bits & 1 != 0, bits & 2 != 0] })
    }

    fn pair<T: Copy>(self, [x, y]: [T; 2]) -> [T; 2] {
        if self.swap { [y, x] } else { [x, y] }
    }

    /// Texel (i, j) of the new map comes from that which the inverse leads to.
    fn map(self, heights: &Heights) -> Heights {
        let size = self.pair(heights.size());
        let turn = |axis: usize, at: u32| if self.flip[axis] { size[axis] - 1 - at } else { at };
        let texel = |x: u32, y: u32| {
            let [x, y] = self.pair([turn(0, x), turn(1, y)]);
            heights.height(i64::from(x), i64::from(y)) as u16
        };
        let texels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))).map(|(x, y)| texel(x, y)).collect();
        Heights::new(size, heights.border(), Texels::U16(texels)).expect("the size of a map")
    }

    fn ray(self, heights: &Heights, ray: &Ray) -> Ray {
        let size = self.pair(heights.size());
        let [at, along] = [ray.origin, ray.direction].map(|[x, y, _]| self.pair([x, y]));
        let turned = |axis: usize, at: f64| if self.flip[axis] { f64::from(size[axis] - 1) - at } else { at };
        let sign = |axis: usize| if self.flip[axis] { -1.0 } else { 1.0 };
        Ray {
            origin: [turned(0, at[0]), turned(1, at[1]), ray.origin[2]],
            direction: [sign(0) * along[0], sign(1) * along[1], ray.direction[2]],
        }
    }
}

#[test]
fn symmetries_of_the_square_change_nothing() {
    each(|method, compiled| {
        let mut agreement = Agreement::default();
        for (heights, rays) in lands(24, 11) {
            let plain = compiled.trace(&heights, &placed(&heights, method), &rays);
            for symmetry in Symmetry::all().skip(1) {
                let turned = symmetry.map(&heights);
                let sent: Vec<Segment> =
                    rays.iter().map(|one| Segment { ray: symmetry.ray(&heights, &one.ray), ..*one }).collect();
                let found = compiled.trace(&turned, &placed(&turned, method), &sent);
                for index in 0..rays.len() {
                    let judges = [Judge::new(&heights, rays[index]), Judge::new(&turned, sent[index])];
                    agreement.add(judges.each_ref(), [&plain[index], &found[index]]);
                }
            }
        }
        agreement.assert(&method.to_string());
    });
}

#[test]
fn whole_tiles_change_no_bit() {
    each(|method, compiled| {
        let mut count = 0;
        for (heights, rays) in lands(24, 12).filter(|(heights, _)| heights.border() == Border::Wrap) {
            let placed = placed(&heights, method);
            let plain = compiled.trace(&heights, &placed, &rays);
            for tiles in [[1, 0], [-3, 7], [1_000_000, -1_000_000]] {
                let away = [0, 1].map(|axis| tiles[axis] * i64::from(heights.size()[axis]));
                let moved = |Segment { ray, range }: &Segment| {
                    let [x, y, z] = ray.origin;
                    Segment { ray: Ray { origin: [x + away[0] as f64, y + away[1] as f64, z], ..*ray }, range: *range }
                };
                let found = compiled.trace(&heights, &placed, &rays.iter().map(moved).collect::<Vec<_>>());
                for (plain, found) in plain.iter().zip(&found) {
                    let is_hit = matches!(plain.outcome, Outcome::Hit(_));
                    let cell = [0, 1].map(|axis| plain.cell[axis] + if is_hit { away[axis] } else { 0 });
                    assert_eq!(*found, Traced { cell, ..*plain }, "{method}, {tiles:?} tiles away");
                    count += usize::from(is_hit);
                }
            }
        }
        assert!(count > 1000, "only {count} hits");
    });
}

#[test]
fn the_coarsest_level_changes_nothing() {
    each(|method, compiled| {
        let mut agreement = Agreement::default();
        for (heights, rays) in lands(24, 13) {
            let mut placed = placed(&heights, method);
            let plain = compiled.trace(&heights, &placed, &rays);
            for top in 0..placed.fields[0].top {
                placed.fields[0].top = top;
                let found = compiled.trace(&heights, &placed, &rays);
                for index in 0..rays.len() {
                    let judge = Judge::new(&heights, rays[index]);
                    agreement.add([&judge; 2], [&plain[index], &found[index]]);
                }
            }
        }
        agreement.assert(&method.to_string());
    });
}

#[test]
fn exact_methods_agree() {
    let Some(gpu) = device() else { return };
    let small = [[1, 1], [3, 3]].map(|size| map(Land::Low, size, Border::Wrap, Depth::Sixteen, 0).expect("a map"));
    let compiled = EXACT.map(|method| compiled(&gpu, &small, method));
    let mut agreement = Agreement::default();
    for (heights, rays) in lands(120, 14) {
        let [a, b] = [0, 1].map(|index| compiled[index].trace(&heights, &placed(&heights, EXACT[index]), &rays));
        for index in 0..rays.len() {
            let judge = Judge::new(&heights, rays[index]);
            agreement.add([&judge; 2], [&a[index], &b[index]]);
        }
    }
    agreement.assert("walk and maximum mipmaps");
}
