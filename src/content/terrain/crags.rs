//! Ribs and gullies of bare rock: what frost and falling stone carve into steep ground, finer than rivers do.

use rayon::prelude::*;

use super::super::color::step;
use super::super::noise::Noise;
use super::land::Land;

/// How rough the rock is.
#[derive(Clone, Copy, Debug)]
pub struct Crags {
    /// Another seed, other ribs.
    pub seed: u32,
    /// Metres between the largest ribs.
    pub apart: f32,
    /// Metres from the foot of the largest gullies to the crest of the ribs beside them.
    pub depth: f32,
    /// Rise over run below which the rock is smooth, and from which on it is as rough as it gets.
    pub steep: (f32, f32),
}

/// Carves ribs into what is steep and not buried; `debris` is metres of loose ground, cell by cell.
pub fn carve(land: &mut Land, debris: &[f32], crags: &Crags) {
    let extent = land.cell * land.size as f32;
    let cells = ((extent / crags.apart) as u32).max(1);
    // Down to two cells of the map: finer is no shape.
    let octaves = ((crags.apart / (2.0 * land.cell)) as u32).max(1).ilog2() + 1;
    let ribs = Noise::new(crags.seed, cells, octaves).gain(0.55);
    let steepness = land.steepness();
    let size = land.size;
    land.height.par_iter_mut().enumerate().for_each(|(index, height)| {
        let bare = step(crags.steep.0, crags.steep.1, steepness[index]) * (1.0 - debris[index]).clamp(0.0, 1.0);
        if bare > 0.0 {
            let (u, v) = (index % size, index / size);
            let centre = |at: usize| (at as f32 + 0.5) / size as f32;
            *height += crags.depth * bare * (ribs.ridged(centre(u), centre(v)) - 0.5);
        }
    });
}
