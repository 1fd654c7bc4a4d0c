//! A picture of running water, for masks.

use super::super::field::Field;
use super::flow::Flow;
use super::land::Land;

/// Where water gathers: 0 on ridges, 1 in the largest river, even steps for equal factors of area.
pub fn water(land: &Land, flow: &Flow) -> Field {
    let most = flow.area.iter().copied().fold(0.0, f32::max);
    let least = land.cell * land.cell * 16.0;
    let scale = 1.0 / libm::logf(most / least).max(1e-3);
    let data = flow.area.iter().map(|&area| (libm::logf(area / least) * scale).clamp(0.0, 1.0)).collect();
    Field { size: land.size, data }
}
