//! Leaves outside the picture are not drawn.

use glam::DVec3;

use super::bounds::Bounds;
use super::select::{Patch, node_box};
use crate::render::camera::View;
use crate::render::height_field::HeightField;

/// The leaves whose box meets the frustum, nearest first.
#[must_use]
pub fn visible(field: &HeightField, bounds: &Bounds, view: &View, leaves: &[Patch]) -> Vec<Patch> {
    let planes = view.planes();
    let mut kept: Vec<(f64, Patch)> = leaves
        .iter()
        .filter_map(|patch| {
            let bounds = node_box(field, bounds, patch.tile, patch.level, patch.node());
            let [low, high] = bounds.map(|corner| corner - view.eye);
            let inside = planes.iter().all(|plane| farthest(*plane, low, high).dot(*plane) >= 0.0);
            inside.then(|| (DVec3::ZERO.distance_squared(DVec3::ZERO.clamp(low, high)), *patch))
        })
        .collect();
    kept.sort_by(|(near, a), (far, b)| near.total_cmp(far).then_with(|| (a.tile, a.texel).cmp(&(b.tile, b.texel))));
    kept.into_iter().map(|(_, patch)| patch).collect()
}

/// The corner of a box that lies farthest along a direction.
fn farthest(direction: DVec3, low: DVec3, high: DVec3) -> DVec3 {
    DVec3::select(direction.cmpge(DVec3::ZERO), high, low)
}
