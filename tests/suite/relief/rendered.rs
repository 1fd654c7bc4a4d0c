//! Displaced ground in a rendered scene against f64: where the ray of every pixel meets it, and the depth that is written.

use glam::DVec3;
use terrane::render::{Camera, Gpu, NEAR, View};
use terrane_shaderlib::heightfield::{Border, Heights, Ray, Texels, first_hit};

use super::device;
use super::plain::{IMAGE, MIDDLE, Plain, SHAPE, SLOPING, Shape, Sight, rough, sights};

/// Texels of the map that rounding may take at 99 of 100 pixels.
const CLOSE: f64 = 0.01;

/// The part of a pixel by which a ray may be beside its own: GPUs place corners on a grid so fine, a CPU does not.
fn subpixel(gpu: &Gpu) -> f64 {
    if gpu.name().contains("Cpu") { 0.0 } else { 1.0 / 256.0 }
}

/// Never faded.
pub(super) const WHOLE: Shape = Shape { fade: (500.0, 600.0), ..SHAPE };

/// Low over the ground, every texel wider than a pixel.
pub(super) const GRAZING: Camera =
    Camera { eye: [MIDDLE.x, 1.0, MIDDLE.z], target: [MIDDLE.x + 1.3, 0.0, MIDDLE.z + 4.5], fov: 14.0 };

/// The map and its mips, each the mean of four texels of the one before.
pub(super) fn mips(map: Heights) -> Vec<Heights> {
    let halved = |finer: &Heights| {
        let side = finer.size()[0] / 2;
        let mean =
            |at: u32| finer.corners(i64::from(at % side) * 2, i64::from(at / side) * 2).iter().sum::<f64>() / 4.0;
        let texels = (0..side * side).map(|at| mean(at) as f32).collect();
        (side > 0).then(|| Heights::new([side; 2], Border::Wrap, Texels::F32(texels)).expect("a map"))
    };
    std::iter::successors(Some(map), halved).collect()
}

/// Metres from the ground along a ray of length 1 to the relief of one mip.
pub(super) fn under(mips: &[Heights], mip: usize, ground: DVec3, ray: DVec3) -> f64 {
    let rate = f64::from(mips[mip].size()[0]) / WHOLE.tile;
    let steps = 65_535.0 / WHOLE.depth;
    let origin = [ground.x * rate - 0.5, ground.z * rate - 0.5, 65_535.0];
    let sent = Ray { origin, direction: [ray.x * rate, ray.z * rate, ray.y * steps] };
    let bottom = WHOLE.depth / -ray.y;
    first_hit(&mips[mip], &sent, (0.0, bottom)).map_or(bottom, |hit| hit.t)
}

/// The same between the two mips that fit a pixel.
fn between(mips: &[Heights], level: f64, ground: DVec3, ray: DVec3) -> f64 {
    let level = level.clamp(0.0, (mips.len() - 1) as f64);
    let (mip, part) = (level.floor() as usize, (2.0 * level.fract() - 1.0).max(0.0));
    let fine = under(mips, mip, ground, ray);
    if part > 0.0 { fine + part * (under(mips, mip + 1, ground, ray) - fine) } else { fine }
}

/// What a pixel sees.
struct Truth {
    /// Metres under the ground along the ray.
    under: f64,
    /// log2 of the texels that it is wide.
    level: f64,
    /// Metres along the ray that the grid of the corners makes of the ground.
    beside: f64,
}

/// Pixel by pixel; all see the ground.
fn truths(gpu: &Gpu, view: &View) -> Vec<Truth> {
    let mips = mips(rough(64));
    let part = subpixel(gpu) * 2.0 * view.half[1] / f64::from(IMAGE[1]);
    let truth = |sight: &Sight| Truth {
        under: between(&mips, sight.level, view.eye + sight.ray * sight.ground, sight.ray),
        level: sight.level,
        beside: part * sight.ground * sight.ray.x.hypot(sight.ray.z) / -sight.ray.y,
    };
    sights(view).iter().map(truth).collect()
}

/// One pixel of a hundred may be off by more than rounding, and one of 500 by more than a tenth of a texel.
#[track_caller]
fn expect_close(found: impl Iterator<Item = f64>, truths: &[Truth], what: &str) {
    let texels = 64.0 / WHOLE.tile;
    let off = found.zip(truths).map(|(found, truth)| ((found - truth.under).abs() - truth.beside).max(0.0) * texels);
    let mut off: Vec<f64> = off.collect();
    assert_eq!(off.len(), truths.len(), "{what}: pixels without relief");
    off.sort_by(f64::total_cmp);
    let (p99, wrong) = (off[off.len() * 99 / 100], off.iter().filter(|off| **off > 0.1).count());
    assert!(p99 < CLOSE && wrong <= off.len() / 500, "{what}: p99 {p99} texels, {wrong} of {} pixels off", off.len());
}

/// Metres under the ground along the ray, from the depth that is written.
fn written(plain: &Plain, gpu: &Gpu, camera: Camera, view: &View) -> Vec<f64> {
    let depth = plain.render(gpu, camera).depth;
    let along = |(sight, depth): (&Sight, &f32)| NEAR / f64::from(*depth) / sight.ray.dot(view.forward) - sight.ground;
    sights(view).iter().zip(&depth).map(along).collect()
}

#[test]
fn relief_in_a_grazing_view_is_where_the_reference_has_it() {
    let Some(gpu) = device() else { return };
    let plain = Plain::new(&rough(64), WHOLE);
    let view = GRAZING.view(IMAGE[0], IMAGE[1]).expect("a good camera");
    let truths = truths(&gpu, &view);
    assert!(truths.iter().all(|truth| truth.level <= 0.5), "coarser than the first mip");
    let mean = truths.iter().map(|truth| truth.under).sum::<f64>() / truths.len() as f64 * 64.0 / WHOLE.tile;
    assert!(mean > 8.0, "only {mean} texels under the ground");
    let searched = plain.search(&gpu, GRAZING);
    assert!(searched.done.iter().all(|done| *done), "searches that were given up");
    expect_close(searched.distance.iter().flatten().map(|found| f64::from(*found)), &truths, "found");
    expect_close(written(&plain, &gpu, GRAZING, &view).into_iter(), &truths, "written");
}

#[test]
fn relief_between_mips_is_between_what_the_reference_finds_on_them() {
    let Some(gpu) = device() else { return };
    let view = SLOPING.view(IMAGE[0], IMAGE[1]).expect("a good camera");
    let truths = truths(&gpu, &view);
    let blended = truths.iter().filter(|truth| truth.level > 0.5 && truth.level.fract() > 0.5).count();
    assert!(blended > truths.len() / 5 && truths.iter().any(|truth| truth.level > 3.0), "{blended} between mips");
    let plain = Plain::new(&rough(64), WHOLE);
    expect_close(written(&plain, &gpu, SLOPING, &view).into_iter(), &truths, "written");
}
