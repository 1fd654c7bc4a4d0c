//! How near rings count what is some way off.

use std::ops::Range;

use super::super::map::Cones;
use super::super::mirror::{Mirror, mirrors};
use super::super::rings::{Ring, rings};
use crate::heightfield::Border;

/// For each column and each row of a map one over the least distance at which rectangles of changed texels inside it can count for a
/// cone there, in texels: for a place the smaller of both holds. It is infinite where both hold what has changed, and 0 where a cone is not
/// narrowed by what lies that way. No cone changes unless the highest of these texels and of those beside them, before or after, is
/// as steep by such a distance from its tip as the cone is.
#[must_use]
pub fn shares(cones: Cones, border: Border, size: [u32; 2], texels: &[[Range<u32>; 2]]) -> [Vec<f64>; 2] {
    let wrap = border == Border::Wrap;
    let counted = Counted::new(cones, wrap, size);
    [0, 1].map(|axis| {
        let side = i64::from(size[axis]);
        // Cells begin a texel before; and what falls to a texel begins there.
        let span = |texels: &[Range<u32>; 2]| {
            [i64::from(texels[axis].start) - 1, i64::from(texels[axis].end) - i64::from(cones.are_square())]
        };
        let share = |at, texels| counted.share(axis, ways(at, span(texels), side, wrap));
        (0..side).map(|at| texels.iter().map(|texels| share(at, texels)).fold(0.0, f64::max)).collect()
    })
}

/// How far it is toward larger numbers and toward smaller ones to what lies between two, of a side that may repeat.
fn ways(at: i64, [first, last]: [i64; 2], side: i64, wrap: bool) -> [Option<usize>; 2] {
    if wrap {
        if (at - first).rem_euclid(side) <= last - first {
            return [Some(0); 2];
        }
        return [first - at, at - last].map(|way| Some(way.rem_euclid(side) as usize));
    }
    let way = |nearest: i64, farthest: i64| (farthest >= 0).then_some(nearest.max(0) as usize);
    [way(first - at, last - at), way(at - last, at - first)]
}

/// How what is some way off counts.
struct Counted {
    mirrors: &'static [Mirror],
    /// One over the least distance at which something that far off counts.
    ahead: Vec<f64>,
    /// The sides of the nodes of each level, and the share of its first ring: a cone toward one side is narrowed there by what lies
    /// to the other side as well, as far as its own node goes.
    behind: Vec<(usize, f64)>,
}

impl Counted {
    fn new(cones: Cones, wrap: bool, size: [u32; 2]) -> Self {
        let farthest = size[0].max(size[1]) as usize - 1;
        let (mut ahead, mut behind) = (vec![f64::INFINITY], Vec::new());
        if cones.are_square() {
            let levels = rings(wrap, size);
            ahead.extend((1..=farthest).map(|away| share(&levels, away)));
            let far = levels.iter().enumerate().skip(1).filter_map(|(level, rings)| Some((1 << level, rings.first()?)));
            behind.extend(far.map(|(node, ring)| (node, f64::from(ring.share))));
        } else {
            ahead.extend((1..=farthest).map(|away| 1.0 / away as f64));
        }
        Self { mirrors: mirrors(cones), ahead, behind }
    }

    /// Of the mirrors the largest share.
    fn share(&self, axis: usize, ways: [Option<usize>; 2]) -> f64 {
        let toward = |mirror: &Mirror| {
            let [ahead, behind] = if mirror[axis] { [ways[1], ways[0]] } else { ways };
            let ahead = ahead.map_or(0.0, |away| self.ahead[away]);
            let node = behind.and_then(|away| self.behind.iter().find(|(node, _)| *node > away));
            ahead.max(node.map_or(0.0, |(_, share)| *share))
        };
        self.mirrors.iter().map(toward).fold(0.0, f64::max)
    }
}

/// The largest share of a ring that something so many cells off can lie in, or what counts in the middle of its diagonal.
fn share(levels: &[Vec<Ring>], away: usize) -> f64 {
    let of = |(level, rings): (usize, &Vec<Ring>)| {
        // It is so many nodes off, or one more.
        let ring = rings.iter().find(|ring| ring.reach >= away >> level)?;
        Some(f64::from(ring.share.max(2.0 * ring.middle)))
    };
    levels.iter().enumerate().filter_map(of).fold(0.0, f64::max)
}
