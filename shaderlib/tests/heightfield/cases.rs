//! The maps and rays that the tests share.

use terrane_shaderlib::heightfield::adversary::{AIMS, Aim, Case, Depth, LANDS, Land, Rays, SIZES, map};
use terrane_shaderlib::heightfield::{Border, Heights, Hit, first_hit};

const SEED: u64 = 20_260_801;

/// Calls `test` with so many rays for each aim, on every land in every size with either border, at either depth.
pub(super) fn each(rays: usize, mut test: impl FnMut(&Heights, Aim, Case, Option<Hit>)) {
    for (at, map) in maps().enumerate() {
        on(&map, SEED ^ at as u64, rays, &mut test);
    }
}

/// The same on maps so large that rays pass thousands of cells.
pub(super) fn each_large(rays: usize, mut test: impl FnMut(&Heights, Aim, Case, Option<Hit>)) {
    for (at, land) in [Land::Needles, Land::Walls, Land::Noise, Land::Hills].into_iter().enumerate() {
        let border = [Border::Wrap, Border::Clamp][at % 2];
        let map = map(land, [1024, 700], border, Depth::Sixteen, SEED).expect("a size that maps have");
        on(&map, SEED ^ at as u64, rays, &mut test);
    }
}

fn on(map: &Heights, seed: u64, rays: usize, test: &mut impl FnMut(&Heights, Aim, Case, Option<Hit>)) {
    let mut source = Rays::new(map, seed);
    for aim in AIMS.into_iter().flat_map(|aim| vec![aim; rays]) {
        let case = source.case(aim);
        test(map, aim, case, first_hit(map, &case.ray, (0.0, case.end as f64)));
    }
}

fn maps() -> impl Iterator<Item = Heights> {
    let lands = LANDS.into_iter().flat_map(|land| SIZES.map(|size| (land, size)));
    let bordered = lands.flat_map(|(land, size)| [Border::Wrap, Border::Clamp].map(|border| (land, size, border)));
    bordered.enumerate().map(|(at, (land, size, border))| {
        let depth = [Depth::Sixteen, Depth::Sixteen, Depth::Eight][at % 3];
        map(land, size, border, depth, SEED + at as u64).expect("a size that maps have")
    })
}
