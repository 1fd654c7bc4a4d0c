//! What frost breaks from steep rock falls, slides and comes to rest as aprons of scree.
//! Source: Musgrave, Kolb and Mace, "The synthesis and rendering of eroded fractal terrains", 1989 (thermal weathering),
//! with rock and debris as two layers.

use rayon::prelude::*;

use super::land::Land;

/// How rock weathers and debris moves.
#[derive(Clone, Copy, Debug)]
pub struct Weather {
    /// Rise over run above which rock breaks.
    pub rock: f32,
    /// Metres that break in one round from a slope that is 1 steeper than that.
    pub rate: f32,
    /// Rise over run at which debris rests.
    pub rest: f32,
    /// Rounds.
    pub rounds: u32,
}

/// Weathers the land; `debris` is the depth in metres of what lies loose, part of the height.
pub fn weather(land: &mut Land, debris: &mut [f32], weather: &Weather) {
    for _ in 0..weather.rounds {
        break_off(land, debris, weather);
        slide(land, debris, weather.rest);
    }
}

fn break_off(land: &Land, debris: &mut [f32], weather: &Weather) {
    debris.par_iter_mut().enumerate().for_each(|(index, depth)| {
        let (gx, gy) = land.gradient(index);
        let excess = (gx * gx + gy * gy).sqrt() - weather.rock;
        // A cover of debris shields the rock below it.
        *depth += weather.rate * excess.max(0.0) / (1.0 + *depth);
    });
}

fn slide(land: &mut Land, debris: &mut [f32], rest: f32) {
    let moved: Vec<f32> = (0..land.height.len()).into_par_iter().map(|index| gain(land, debris, rest, index)).collect();
    land.height.par_iter_mut().zip(debris.par_iter_mut()).zip(&moved).for_each(|((height, depth), &gain)| {
        *height += gain;
        *depth = (*depth + gain).max(0.0);
    });
}

/// What comes from higher neighbours less what goes to lower ones; both sides of a pair compute the same number.
fn gain(land: &Land, debris: &[f32], rest: f32, index: usize) -> f32 {
    let mut sum = 0.0;
    for (_, other, distance) in land.around(index) {
        let step = rest * land.cell * distance;
        let fall = land.height[other] - land.height[index];
        if fall > step {
            sum += ((fall - step) * 0.09).min(debris[other] * 0.12);
        } else if -fall > step {
            sum -= ((-fall - step) * 0.09).min(debris[index] * 0.12);
        }
    }
    sum
}
