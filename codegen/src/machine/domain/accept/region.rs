//! Texture reads: any value between those that the host may hold where the read may fall.

use super::{Integers, Interval};
use crate::machine::texture::{Footprint, Load, Region, Sample, Textures, Within};

/// WGSL states no accuracy for filters, and hardware differs in weights and in the choice of levels: whatever lies
/// between the texels that may take part is accepted.
pub(super) fn sample(textures: &dyn Textures, sample: &Sample<Interval, Integers>) -> Option<[Interval; 4]> {
    let span = |x: Interval| {
        let (low, high) = x.bounds();
        Within { low, high }
    };
    let (first, last) = sample.layer.signed_bounds();
    let region = Region {
        texture: sample.texture,
        sampler: sample.sampler,
        layers: (first, last),
        uv: sample.uv.map(span),
        offset: sample.offset,
        footprint: match sample.footprint {
            Footprint::Level(level) => Footprint::Level(span(level)),
            Footprint::Gradient { ddx, ddy } => Footprint::Gradient { ddx: ddx.map(span), ddy: ddy.map(span) },
        },
    };
    Some(textures.region(&region)?.map(interval))
}

/// All combinations of few coordinates; any texel where they are not few.
pub(super) fn load(textures: &dyn Textures, load: &Load<Integers>) -> Option<[Interval; 4]> {
    match texels(textures, load)? {
        Some(texels) => Some(joined(&texels, |value| Interval::rounded(value, value), Interval::join)),
        None => Some(textures.whole(load.texture)?.map(interval)),
    }
}

/// As [`load`], for textures of integers.
pub(super) fn load_int(textures: &dyn Textures, load: &Load<Integers>) -> Option<[Integers; 4]> {
    match texels(textures, load)? {
        Some(texels) => Some(joined(&texels, |value| Integers::one(value as i64 as u32), Integers::join)),
        None => Some([Integers::ANY; 4]),
    }
}

/// `None` if the texture is unknown, `Some(None)` if the coordinates are too many.
fn texels(textures: &dyn Textures, load: &Load<Integers>) -> Option<Option<Vec<[f64; 4]>>> {
    let parts = [load.at[0], load.at[1], load.layer, load.level];
    let mut places = vec![Vec::new()];
    for part in &parts {
        let Some(values) = part.values() else { return Some(None) };
        places = places
            .iter()
            .flat_map(|place: &Vec<i32>| {
                values.iter().map(move |value| place.iter().copied().chain([*value as i32]).collect())
            })
            .collect();
    }
    let read = |place: &Vec<i32>| {
        textures.load(&Load { texture: load.texture, at: [place[0], place[1]], layer: place[2], level: place[3] })
    };
    places.iter().map(read).collect::<Option<Vec<_>>>().map(Some)
}

fn joined<T: Copy>(texels: &[[f64; 4]], of: impl Fn(f64) -> T, join: impl Fn(T, T) -> T) -> [T; 4] {
    let first = texels[0].map(&of);
    texels[1..].iter().fold(first, |all, texel| std::array::from_fn(|i| join(all[i], of(texel[i]))))
}

fn interval(within: Within) -> Interval {
    Interval::rounded(within.low, within.high)
}
