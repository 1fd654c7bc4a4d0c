use super::*;
use crate::heightfield::adversary::{Depth, LANDS, map};
use crate::heightfield::{Border, Heights, Texels};

fn quiet(_: u64, _: u64) {}

/// Small maps of every land, as 8 and 16 bits and floats.
fn maps() -> impl Iterator<Item = Heights> {
    let sizes = [[1, 1], [2, 2], [1, 5], [4, 1], [7, 5], [8, 8], [13, 9]];
    let all = LANDS.into_iter().flat_map(move |land| sizes.map(|size| (land, size)));
    all.flat_map(|one| [(one, Border::Wrap), (one, Border::Clamp)]).enumerate().map(|(at, ((land, size), border))| {
        let depth = if at % 3 == 0 { Depth::Eight } else { Depth::Sixteen };
        let heights = map(land, size, border, depth, at as u64).unwrap();
        let Texels::U16(values) = heights.texels() else { return heights };
        let floats = values.iter().map(|value| f32::from(*value) * 0.037 - 500.0).collect();
        if at % 3 == 1 { heights } else { Heights::new(size, border, Texels::F32(floats)).unwrap() }
    })
}

/// All texels that a tip sees, each where it is: of a map that wraps those of the next tiles too.
fn seen(heights: &Heights) -> Vec<[i64; 2]> {
    let [width, height] = heights.size().map(i64::from);
    let range = |side: i64| if heights.border() == Border::Wrap { -2 * side..3 * side } else { 0..side };
    range(height).flat_map(|y| range(width).map(move |x| [x, y])).collect()
}

/// Whether the ground falls along an edge of the cell that begins at a texel, away from a tip.
fn falls(heights: &Heights, [x, y]: [i64; 2], away: [i64; 2]) -> bool {
    let ways = |away: i64| if away == 0 { vec![1, -1] } else { vec![away.signum()] };
    ways(away[0]).into_iter().flat_map(|i| ways(away[1]).into_iter().map(move |j| (i, j))).any(|(i, j)| {
        let [a, b] = [heights.height(x, y), heights.height(x + i, y)];
        let [c, d] = [heights.height(x, y + j), heights.height(x + i, y + j)];
        a > b || a > c || b > d || c > d
    })
}

fn round(heights: &Heights, seen: &[[i64; 2]], tip: [i64; 2], relaxed: bool) -> f64 {
    let base = heights.height(tip[0], tip[1]);
    let slopes = seen.iter().map(|texel| {
        let away = [texel[0] - tip[0], texel[1] - tip[1]];
        let climb = heights.height(texel[0], texel[1]) - base;
        let counts = climb > 0.0 && (!relaxed || falls(heights, *texel, away));
        if counts { climb / ((away[0] * away[0] + away[1] * away[1]) as f64).sqrt() } else { 0.0 }
    });
    slopes.fold(0.0, f64::max)
}

/// By the definition over cells: every corner, and the middle control point of the cells on the diagonals.
fn square(heights: &Heights, seen: &[[i64; 2]], cell: [i64; 2], ways: &[[i64; 2]]) -> f64 {
    let toward = |way: i64, axis: usize, at: i64| if way > 0 { at >= cell[axis] } else { at <= cell[axis] + 1 };
    let counts = |texel: &&[i64; 2]| ways.iter().any(|way| (0..2).all(|axis| toward(way[axis], axis, texel[axis])));
    let base = heights.corners(cell[0], cell[1]).into_iter().fold(f64::MIN, f64::max);
    let climb = |[x, y]: [i64; 2]| (heights.height(x, y) - base).max(0.0);
    let side = |axis: usize, at: i64| if at < cell[axis] { cell[axis] - at } else { (at - cell[axis] - 1).max(0) };
    let corners = seen.iter().filter(counts).map(|texel| {
        let away = side(0, texel[0]).max(side(1, texel[1]));
        if away == 0 { 0.0 } else { climb(*texel) / away as f64 }
    });
    let inside = |[x, y]: [i64; 2]| {
        let [width, height] = heights.size().map(i64::from);
        heights.border() == Border::Wrap || (0..width).contains(&x) && (0..height).contains(&y)
    };
    let longest = 3 * i64::from(heights.size()[0].max(heights.size()[1]));
    let diagonals = ways.iter().flat_map(|way| (0..longest).map(move |a| (*way, a)));
    let middles = diagonals.map(|(way, a)| {
        let at = |axis: usize, a: i64| cell[axis] + if way[axis] > 0 { 1 + a } else { -a };
        let pair = [[at(0, a + 1), at(1, a)], [at(0, a), at(1, a + 1)]];
        if pair.into_iter().all(inside) { (climb(pair[0]) + climb(pair[1])) / (2 * a + 1) as f64 } else { 0.0 }
    });
    corners.chain(middles).fold(0.0, f64::max)
}

/// The cell whose cone stands at a texel.
fn cell(heights: &Heights, [x, y]: [i64; 2]) -> [i64; 2] {
    let [columns, rows] = heights.cells().map(i64::from);
    [x.min(columns - 1), y.min(rows - 1)]
}

fn differs(cones: Cones, expected: impl Fn(&Heights, &[[i64; 2]], [i64; 2]) -> f64) {
    for heights in maps() {
        let built = ConeMap::new(&heights, cones, &quiet);
        let seen = seen(&heights);
        let [width, height] = heights.size();
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let slope = expected(&heights, &seen, [i64::from(x), i64::from(y)]);
            let found = built.codes[(y * width + x) as usize];
            let what = format!("{cones:?} {:?} {:?} {x} {y}", heights.size(), heights.border());
            match cones {
                Cones::Step | Cones::Relaxed => assert_eq!(found, RATIO.down(built.unit / slope), "{what}"),
                Cones::Robust | Cones::Quadrant(_) => {
                    // What is looked for in f32 may be some roundings steeper.
                    let code =
                        |roundings: f64| SLOPE.up(slope / built.unit * (1.0 + 1.0 / 16384.0) * (1.0 + roundings));
                    assert!((code(0.0)..=code(1e-6)).contains(&found), "{what}: {found} for {}", code(0.0));
                }
            }
            assert!(built.slope(x, y) >= slope, "{cones:?}: wider than it is");
        }
    }
}

#[test]
fn cones_over_texels_are_those_of_the_definition() {
    differs(Cones::Step, |heights, seen, tip| round(heights, seen, tip, false));
}

#[test]
fn relaxed_cones_are_those_of_the_definition() {
    differs(Cones::Relaxed, |heights, seen, tip| round(heights, seen, tip, true));
}

#[test]
fn robust_cones_are_those_of_the_definition() {
    let all = [[1, 1], [1, -1], [-1, 1], [-1, -1]];
    differs(Cones::Robust, |heights, seen, tip| square(heights, seen, cell(heights, tip), &all));
}

#[test]
fn cones_of_a_quadrant_are_those_of_the_definition() {
    for (number, way) in [[1, 1], [-1, 1], [1, -1], [-1, -1]].into_iter().enumerate() {
        let expected = |heights: &Heights, seen: &[[i64; 2]], tip| square(heights, seen, cell(heights, tip), &[way]);
        differs(Cones::Quadrant(number as u8), expected);
    }
}

/// A plain with one peak, far from most of it: larger than what is looked at texel by texel, with a side that is no whole number
/// of nodes.
const PLAIN: ([u32; 2], [u32; 2]) = ([192, 129], [37, 90]);

/// Texels from a cell to the peak along an axis, any way or toward larger numbers alone.
fn away(border: Border, cones: Cones, axis: usize, at: u32) -> Option<i64> {
    let [side, peak, at] = [PLAIN.0[axis], PLAIN.1[axis], at].map(i64::from);
    let images = if border == Border::Wrap { -1..=1 } else { 0..=0 };
    let ways = images.map(|image| peak + image * side - at).filter(|way| cones == Cones::Robust || *way >= 0);
    ways.map(|way| (-way).max(way - 1)).min()
}

#[test]
fn far_away_square_cones_are_never_less_steep_and_hardly_steeper() {
    let (size, peak) = PLAIN;
    let mut texels = vec![0; (size[0] * size[1]) as usize];
    texels[(peak[1] * size[0] + peak[0]) as usize] = u16::MAX;
    for (border, cones) in [Border::Wrap, Border::Clamp]
        .into_iter()
        .flat_map(|one| [Cones::Robust, Cones::Quadrant(0)].map(|two| (one, two)))
    {
        let heights = Heights::new(size, border, Texels::U16(texels.clone())).unwrap();
        let built = ConeMap::new(&heights, cones, &quiet);
        let cells = heights.cells();
        for [x, y] in (0..cells[1]).flat_map(|y| (0..cells[0]).map(move |x| [x, y])) {
            let away = away(border, cones, 0, x).zip(away(border, cones, 1, y)).map_or(0, |(x, y)| x.max(y));
            let slope = if away > 0 { 65535.0 / away as f64 } else { 0.0 };
            let found = built.slope(x, y);
            let most = match (cones, slope > 0.0) {
                // 36 texels counted as 31.5, and a part of a node nearer where the map wraps.
                (Cones::Robust, true) => slope * 1.2,
                (Cones::Robust, false) => 2.0_f64.powi(-14),
                // What lies in the same node, but behind the cell, counts as well.
                _ => f64::MAX,
            };
            assert!((slope..=most).contains(&found), "{border:?} {cones:?} {x} {y}: {found} for {slope}");
        }
    }
}
