//! What cones promise about rays, and what published ones do not keep.

use terrane_shaderlib::heightfield::adversary::{Depth, LANDS, Land, Random, map};
use terrane_shaderlib::heightfield::cones::{ConeMap, Cones, report};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};

fn build(heights: &Heights, cones: Cones) -> ConeMap {
    ConeMap::new(heights, cones, &|_, _| ())
}

fn maps() -> impl Iterator<Item = Heights> {
    let all = LANDS.into_iter().flat_map(|land| [[32, 32], [17, 31]].map(|size| (land, size)));
    let bordered = all.flat_map(|one| [(one, Border::Wrap), (one, Border::Clamp)]);
    bordered.enumerate().map(|(at, ((land, size), border))| {
        map(land, size, border, Depth::Sixteen, at as u64).expect("a size that maps have")
    })
}

/// A number in 0..1, often on an end.
fn unit(random: &mut Random) -> f64 {
    (random.between(-8, 72) as f64 / 64.0).clamp(0.0, 1.0)
}

/// A place up to so many texels away along each axis, inside a map that ends.
fn place(random: &mut Random, heights: &Heights, from: [f64; 2], most: i64) -> [f64; 2] {
    [0, 1].map(|axis| {
        let at = from[axis] + random.between(-most * 64, most * 64) as f64 / 64.0;
        let last = f64::from(heights.size()[axis]) - 1.0;
        if heights.border() == Border::Wrap { at } else { at.clamp(0.0, last) }
    })
}

#[test]
fn robust_cones_stand_free_of_the_bilinear_surface() {
    let mut random = Random::new(1);
    let mut close = 0;
    for heights in maps() {
        let cones = build(&heights, Cones::Robust);
        let [columns, rows] = heights.cells();
        for _ in 0..20_000 {
            let cell = [columns, rows].map(|count| random.between(0, i64::from(count) - 1));
            let tip = heights.corners(cell[0], cell[1]).into_iter().fold(0.0, f64::max);
            let from = cell.map(|cell| cell as f64 + unit(&mut random));
            let most = random.one_of(&[1, 3, 40]);
            let to = place(&mut random, &heights, from, most);
            let across = (to[0] - from[0]).abs().max((to[1] - from[1]).abs());
            let cone = tip + cones.slope(cell[0] as u32, cell[1] as u32) * across;
            let ground = heights.surface(to[0], to[1]);
            // Both sides are sums of a few products in f64.
            assert!(ground <= cone + 1e-6, "{:?} {cell:?} {from:?} {to:?}: {ground} over {cone}", heights.size());
            close += u32::from(across > 0.5 && ground > cone - 0.01 * (cone - tip) && ground > tip);
        }
    }
    assert!(close > 500, "cones are narrow for nothing: {close} places are near one");
}

#[test]
fn the_published_cone_reaches_into_the_bilinear_surface() {
    // Three texels a cone from the first one just touches: the patch between them lies over it.
    let texels = vec![0, 1000, 1000, 1414];
    let heights = Heights::new([2, 2], Border::Clamp, Texels::U16(texels)).unwrap();
    let slope = build(&heights, Cones::Step).slope(0, 0);
    assert!((1000.0..1001.0).contains(&slope), "as steep as to the nearer two: {slope}");
    let ground = heights.surface(0.5, 0.5);
    assert!(ground - slope * 0.5_f64.sqrt() > 140.0, "a ray at 45 degrees is 146 steps in the ground: {ground}");
}

#[test]
fn filtered_between_texels_the_published_cone_is_not_even_safe_from_texels() {
    let heights = map(Land::Noise, [32, 32], Border::Wrap, Depth::Sixteen, 7).unwrap();
    let cones = build(&heights, Cones::Step);
    let mut random = Random::new(3);
    let through = (0..2000).filter(|_| {
        let [x, y] = [(); 2].map(|()| random.between(0, 30));
        // Halfway between two texels, with half the sum of their heights and of their ratios.
        let tip = heights.surface(x as f64 + 0.5, y as f64);
        let ratio = (1.0 / cones.slope(x as u32, y as u32) + 1.0 / cones.slope(x as u32 + 1, y as u32)) / 2.0;
        let near = (x - 2..x + 4).flat_map(|i| (y - 2..y + 3).map(move |j| [i, j]));
        near.into_iter().any(|[i, j]| {
            let away = (i as f64 - x as f64 - 0.5).hypot((j - y) as f64);
            heights.height(i, j) > tip + away / ratio + 1.0
        })
    });
    assert!(through.count() > 500);
}

/// Texels along a line from a tip, with a ray that falls: how often it comes out of the ground inside the cone.
fn comes_out(heights: &Heights, slope: f64, tip: [i64; 2], way: [i64; 2], start: f64, fall: f64) -> bool {
    let base = heights.height(tip[0], tip[1]);
    let length = (way[0] as f64).hypot(way[1] as f64);
    let mut under = false;
    for step in 1..40 {
        let [x, y] = [0, 1].map(|axis| tip[axis] + step * way[axis]);
        let inside = (0..i64::from(heights.size()[0])).contains(&x) && (0..i64::from(heights.size()[1])).contains(&y);
        let ray = base + start - fall * step as f64;
        if heights.border() == Border::Clamp && !inside || ray < base + slope * length * step as f64 {
            return false;
        }
        let ground = heights.height(x, y);
        if under && ray > ground {
            return true;
        }
        under |= ray < ground;
    }
    false
}

#[test]
fn no_ray_comes_out_of_the_ground_in_a_relaxed_cone() {
    let mut random = Random::new(5);
    let (mut wider, mut narrow) = (0, 0);
    for heights in maps() {
        let (relaxed, published) = (build(&heights, Cones::Relaxed), build(&heights, Cones::Step));
        for _ in 0..5000 {
            let tip = heights.size().map(|side| random.between(0, i64::from(side) - 1));
            let way = [(); 2].map(|()| random.between(-3, 3));
            let [start, fall] = [65_536, 4096].map(|most| random.between(1, most) as f64);
            let slopes = [&relaxed, &published].map(|cones| cones.slope(tip[0] as u32, tip[1] as u32));
            if way != [0, 0] {
                let out = comes_out(&heights, slopes[0], tip, way, start, fall);
                assert!(!out, "{:?} {tip:?} {way:?} {start} {fall}", heights.size());
                // The test can fail: in a cone of no slope it does.
                narrow += u32::from(comes_out(&heights, 0.0, tip, way, start, fall));
            }
            assert!(slopes[0] <= slopes[1], "steeper than the published one");
            wider += u32::from(slopes[0] < 0.9 * slopes[1]);
        }
    }
    assert!(wider > 10_000 && narrow > 1000, "{wider} {narrow}");
}

#[test]
fn the_report_tells_bytes_and_time_and_progress_ends_with_all() {
    use std::sync::atomic::{AtomicU64, Ordering};
    let heights = map(Land::Hills, [32, 32], Border::Wrap, Depth::Sixteen, 7).unwrap();
    let (calls, whole, ends) = (AtomicU64::new(0), AtomicU64::new(0), AtomicU64::new(0));
    let reports = report(&heights, &|done, total| {
        calls.fetch_add(1, Ordering::Relaxed);
        if done == total {
            whole.fetch_add(total, Ordering::Relaxed);
            ends.fetch_add(1, Ordering::Relaxed);
        }
    });
    assert!(reports.iter().all(|report| report.bytes_per_texel == 2.0 && !report.time.is_zero()));
    assert_eq!((calls.into_inner(), ends.into_inner()), (whole.into_inner(), 3));
}
