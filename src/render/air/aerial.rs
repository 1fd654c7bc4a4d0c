//! The light of the air between the eye and the ground, by cells of the camera's frustum.

use glam::DVec3;
use rayon::prelude::*;

use super::atmosphere::Atmosphere;
use super::march::Gathered;
use crate::render::camera::View;

/// Cells across, down and along. Hillaire 2020, section 5.4, with twice its cells on each axis across.
pub const AERIAL_CELLS: [u32; 3] = [64, 36, 32];

/// Steps of a ray between two cells.
const STEPS: u32 = 3;

/// Radiance scattered towards the eye by the air before a cell's far side, for a sun of irradiance 1.
#[derive(Clone, Debug)]
pub struct Aerial {
    /// Across first, then down, then along. Cell k along ends at ((k + 1) / cells)² of `reach`.
    pub cells: Vec<DVec3>,
    /// Metres to the far side of the last cells.
    pub reach: f64,
}

impl Aerial {
    /// The air before a camera up to `reach` metres.
    #[must_use]
    pub fn new(atmosphere: &Atmosphere, view: &View, reach: f64) -> Self {
        let [across, down, along] = AERIAL_CELLS;
        let rays: Vec<Vec<DVec3>> = (0..across * down)
            .into_par_iter()
            .map(|index| {
                // Cell middles at the picture's very edges: texels are interpolated between middles.
                let x = f64::from(index % across) / f64::from(across - 1);
                let y = f64::from(index / across) / f64::from(down - 1);
                along_ray(atmosphere, view.eye.y, view.ray(x, y), reach)
            })
            .collect();
        let cells = (0..along as usize).flat_map(|k| rays.iter().map(move |ray| ray[k])).collect();
        Self { cells, reach }
    }
}

fn along_ray(atmosphere: &Atmosphere, height: f64, direction: DVec3, reach: f64) -> Vec<DVec3> {
    let mut gathered = Gathered::NOTHING;
    let distance = |step: u32| reach * (f64::from(step) / f64::from(AERIAL_CELLS[2] * STEPS)).powi(2);
    (0..AERIAL_CELLS[2] * STEPS)
        .filter_map(|step| {
            atmosphere.cross(&mut gathered, height, direction, distance(step), distance(step + 1));
            ((step + 1) % STEPS == 0).then_some(gathered.light)
        })
        .collect()
}
