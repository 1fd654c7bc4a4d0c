//! A camera that comes nearer in small steps to relief of which it sees many mips, and where it fades: nothing jumps.
//!
//! The pixels of a picture have levels of all kinds, and few cross a border in one step. Those that have the same level before
//! a step are therefore taken together, whichever step it is: all of them cross a border, or none.

use std::collections::BTreeMap;
use std::ops::Range;

use glam::DVec3;
use terrane::render::{Camera, Gpu, NEAR};

use super::device;
use super::plain::{IMAGE, MIDDLE, Plain, SHAPE, Shape, rough, sights};

/// Pixels without which a level says nothing.
const ENOUGH: usize = 60;

/// Of the median of neighbouring levels: the step that a step of the camera may be. Noise stays below 1.5.
const LARGEST: f64 = 2.0;

/// Of 255: how much brighter or darker a level may become on the whole. Noise stays below 3.
const BRIGHTER: f64 = 5.0;

/// Where a camera goes.
struct Path {
    relief: Shape,
    /// From the place that it comes nearer to, metres to where it begins.
    away: DVec3,
    /// Its steps to a level; half a level is a whole number of them.
    steps: f64,
    /// Pictures on the way.
    frames: u32,
}

/// Along the ground, with four levels in one picture.
const ALONG: Path = Path { relief: SHAPE, away: DVec3::new(0.3, 3.2, 5.5), steps: 64.0, frames: 12 };

/// Down to stones so shallow that they are only looked at.
const DOWN: Path =
    Path { relief: Shape { depth: 0.02, ..SHAPE }, away: DVec3::new(0.5, 7.9, 0.8), steps: 256.0, frames: 7 };

/// One pixel of a picture.
struct Seen {
    level: f64,
    /// Metres over the ground, over the depth of the relief.
    height: f64,
    /// 0..255.
    light: f64,
}

/// What a step changes where pixels have one level.
struct Change {
    level: f64,
    /// The median of how far heights move.
    moved: f64,
    /// The mean of how much brighter it becomes.
    brighter: f64,
}

impl Path {
    /// Nearer by the same share of the way with every step.
    fn camera(&self, step: u32) -> Camera {
        let target = MIDDLE + DVec3::new(0.37, 0.0, 0.21);
        let eye = target + self.away * (-f64::from(step) / self.steps).exp2();
        Camera { eye: eye.to_array(), target: target.to_array(), fov: 52.0 }
    }

    fn frame(&self, gpu: &Gpu, plain: &Plain, step: u32) -> Vec<Seen> {
        let camera = self.camera(step);
        let view = camera.view(IMAGE[0], IMAGE[1]).expect("a good camera");
        let found = plain.render(gpu, camera);
        let greens = found.image.pixels.chunks_exact(3).map(|pixel| f64::from(pixel[1]));
        let pixels = sights(&view).into_iter().zip(found.depth).zip(greens);
        let seen = pixels.map(|((sight, met), light)| {
            let along = NEAR / f64::from(met) / sight.ray.dot(view.forward);
            Seen { level: sight.level, height: (view.eye.y + sight.ray.y * along) / self.relief.depth, light }
        });
        seen.collect()
    }

    /// All changes on the way, level by level.
    fn changes(&self, gpu: &Gpu, plain: &Plain) -> Vec<Change> {
        let frames: Vec<Vec<Seen>> = (0..self.frames).map(|step| self.frame(gpu, plain, step)).collect();
        let mut levels: BTreeMap<i64, Vec<(f64, f64)>> = BTreeMap::new();
        for (before, after) in frames.iter().zip(&frames[1..]).flat_map(|(before, after)| before.iter().zip(after)) {
            let change = ((after.height - before.height).abs(), after.light - before.light);
            levels.entry((before.level * self.steps).floor() as i64).or_default().push(change);
        }
        let known = levels.into_iter().filter(|(_, all)| all.len() >= ENOUGH);
        known.map(|(level, all)| change(level as f64 / self.steps, &all)).collect()
    }
}

fn change(level: f64, all: &[(f64, f64)]) -> Change {
    let brighter = all.iter().map(|one| one.1).sum::<f64>() / all.len() as f64;
    Change { level, moved: median(all.iter().map(|one| one.0)), brighter }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Levels at which something jumps, in words.
fn jumps(changes: &[Change]) -> Vec<String> {
    let around = |at: usize| {
        let near = changes[at.saturating_sub(8)..(at + 9).min(changes.len())].iter();
        median(near.filter(|one| one.level != changes[at].level).map(|one| one.moved)).max(0.001)
    };
    let told = changes.iter().enumerate().filter_map(|(at, one)| {
        let times = one.moved / around(at);
        let jumps = times > LARGEST || one.brighter.abs() > BRIGHTER;
        jumps.then(|| {
            format!("level {:.2}: heights move {times:.2} times as far, light by {:.2}", one.level, one.brighter)
        })
    });
    told.collect()
}

#[track_caller]
fn expect_steady(path: &Path, levels: Range<f64>) {
    let Some(gpu) = device() else { return };
    let changes = path.changes(&gpu, &Plain::new(&rough(64), path.relief));
    let (first, last) = (changes[0].level, changes[changes.len() - 1].level);
    assert!(first < levels.start && last > levels.end, "levels from {first} to {last}");
    assert!(changes.len() as f64 > 0.98 * (last - first) * path.steps, "only {} levels", changes.len());
    assert_eq!(jumps(&changes), Vec::<String>::new());
}

/// A level where something jumps once the shader says another thing.
#[track_caller]
fn expect_jump(path: &Path, [from, to]: [&str; 2], level: &str) {
    let Some(gpu) = device() else { return };
    let plain = Plain::new(&rough(64), path.relief).replaced(from, to);
    let jumps = jumps(&path.changes(&gpu, &plain));
    assert!(jumps.iter().any(|jump| jump.starts_with(level)), "{jumps:#?}");
}

#[test]
fn nothing_jumps_on_the_way_to_relief() {
    expect_steady(&ALONG, 0.0..3.2);
}

#[test]
fn nothing_jumps_on_the_way_down_to_relief_that_is_only_looked_at() {
    expect_steady(&DOWN, 0.95..1.05);
}

#[test]
fn a_step_between_mips_is_found_out() {
    let step = ["return saturate(2.0 * fract(level) - 1.0);", "return step(0.5, fract(level));"];
    expect_jump(&ALONG, step, "level 0.50");
}

#[test]
fn a_look_at_one_mip_alone_is_found_out() {
    expect_jump(
        &DOWN,
        ["return select(part, 1.0 - part, coarser == 0i);", "return select(0.0, 1.0, coarser == 0i);"],
        "level 1.00",
    );
}
