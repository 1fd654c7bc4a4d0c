//! What may not depend on how a map lies, where it lies, and how long a direction is.

use terrane_shaderlib::heightfield::adversary::Case;
use terrane_shaderlib::heightfield::{Border, FixedRay, Heights, Hit, Ray, Texels, first_hit};

use super::cases::each;
use super::judge::{Verdict, judge};

/// One of the eight ways to lay a square: the axes swapped, then each turned round.
#[derive(Clone, Copy, Debug)]
struct Symmetry {
    swap: bool,
    turn: [bool; 2],
}

const SYMMETRIES: [Symmetry; 8] = {
    let mut all = [Symmetry { swap: false, turn: [false; 2] }; 8];
    let mut at = 0;
    while at < 8 {
        all[at] = Symmetry { swap: at & 1 != 0, turn: [at & 2 != 0, at & 4 != 0] };
        at += 1;
    }
    all
};

impl Symmetry {
    /// A point, or a direction if `last` is 0, in a map that has its last texels there.
    fn of<T: Copy + std::ops::Sub<Output = T>>(self, [x, y]: [T; 2], last: [T; 2]) -> [T; 2] {
        let (place, last) = if self.swap { ([y, x], [last[1], last[0]]) } else { ([x, y], last) };
        [0, 1].map(|axis| if self.turn[axis] { last[axis] - place[axis] } else { place[axis] })
    }

    fn map(self, map: &Heights) -> Heights {
        let [width, height] = map.size();
        let size = if self.swap { [height, width] } else { [width, height] };
        let mut texels = vec![0; (width * height) as usize];
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let [to_x, to_y] = self.of([x, y], [width - 1, height - 1]);
            texels[(to_y * size[0] + to_x) as usize] = map.height(i64::from(x), i64::from(y)) as u16;
        }
        Heights::new(size, map.border(), Texels::U16(texels)).expect("as many texels as before")
    }

    fn ray(self, ray: &Ray, map: &Heights) -> Ray {
        let last = map.size().map(|side| f64::from(side) - 1.0);
        let ([x, y, z], [dx, dy, dz]) = (ray.origin, ray.direction);
        let ([x, y], [dx, dy]) = (self.of([x, y], last), self.of([dx, dy], [0.0; 2]));
        Ray { origin: [x, y, z], direction: [dx, dy, dz] }
    }
}

/// Whether two answers are one, to the rounding of t and of what leads to it.
fn same(one: Option<Hit>, other: Option<Hit>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => (one.t - other.t).abs() <= 1e-9 * one.t.max(1e-3),
        (None, None) => true,
        _ => false,
    }
}

/// Two answers that are not the same may both be right, but only where the ray almost touches.
fn touches(map: &Heights, case: &Case, answers: [Option<Hit>; 2]) -> bool {
    answers.into_iter().any(|hit| judge(map, case, hit) == Ok(Verdict::Touch))
}

fn range(case: &Case) -> (f64, f64) {
    (0.0, case.end as f64)
}

#[test]
fn the_eight_symmetries_of_the_square() {
    let mut seen = 0;
    each(2, |map, aim, case, hit| {
        let symmetry = SYMMETRIES[seen % 8];
        seen += 1;
        let (turned, ray) = (symmetry.map(map), symmetry.ray(&case.ray, map));
        let other = first_hit(&turned, &ray, range(&case));
        // The judge knows the map as it lay before: of a hit on the turned one it is told only when.
        let other = other.map(|other| Hit { t: other.t, ..hit.unwrap_or(other) });
        let right = same(hit, other) || touches(map, &case, [hit, other]);
        assert!(right, "{aim:?} {symmetry:?} {case:?}: {hit:?} {other:?}");
    });
}

#[test]
fn a_wrapped_map_is_the_same_in_every_tile() {
    let mut tiles = 1_i64;
    each(2, |map, aim, case, hit| {
        if map.border() == Border::Clamp {
            return;
        }
        tiles = (tiles * 48_271 + 12_345) % 1_000_003;
        let cells = [tiles, 3 - tiles / 2].map(|tiles| tiles - 500_000);
        let cells = [0, 1].map(|axis| cells[axis] * i64::from(map.size()[axis]));
        let mut ray = case.ray;
        for (at, cells) in ray.origin.iter_mut().zip(cells) {
            *at += cells as f64;
        }
        let moved = first_hit(map, &ray, range(&case));
        let back = moved.map(|hit| Hit { cell: [0, 1].map(|axis| hit.cell[axis] - cells[axis]), ..hit });
        assert_eq!(back, hit, "{aim:?} {case:?} {cells:?} cells away");
    });
}

#[test]
fn the_length_of_a_direction_is_only_a_unit_of_t() {
    each(2, |map, aim, case, hit| {
        // The smallest numbers are no longer themselves, and a rounded direction may pass by a clamped map's corner.
        let tiny = case.ray.direction.iter().any(|rate| rate.abs() < 1e-250 && *rate != 0.0);
        for (scale, exact) in [(0.125, !tiny), (2_f64.powi(40), !tiny), (3.0, false), (1e-7, false)] {
            if scale == 1e-7 && map.border() == Border::Clamp {
                continue;
            }
            let ray = Ray { direction: case.ray.direction.map(|rate| rate * scale), ..case.ray };
            let other = first_hit(map, &ray, (0.0, case.end as f64 / scale)).map(|hit| Hit { t: hit.t * scale, ..hit });
            let right = if exact { hit == other } else { same(hit, other) || touches(map, &case, [hit, other]) };
            assert!(right, "{aim:?} {case:?} × {scale}: {hit:?} {other:?}");
        }
    });
}

#[test]
fn a_range_begins_where_an_origin_would() {
    each(2, |map, aim, case, _| {
        let later = case.end / 3;
        let FixedRay { origin, direction } = case.fixed;
        let fixed =
            FixedRay { origin: [0, 1, 2].map(|axis| origin[axis] + later * i64::from(direction[axis])), direction };
        let ray = Ray { origin: Ray::from(fixed).origin, ..case.ray };
        let moved = Case { ray, fixed, end: case.end - later };
        let ranged = first_hit(map, &case.ray, (later as f64, case.end as f64));
        let ranged = ranged.map(|hit| Hit { t: hit.t - later as f64, ..hit });
        let begun = first_hit(map, &moved.ray, range(&moved));
        let right = same(ranged, begun) || touches(map, &moved, [ranged, begun]);
        assert!(right, "{aim:?} {case:?} from {later}: {ranged:?} {begun:?}");
    });
}
