//! The texels that narrow a relaxed cone.

use super::mirror::Mirror;

/// The heights of the texels from which the ground falls, in the cell that begins there toward a quadrant, along one of its four
/// edges; of the others minus infinity. Where no edge falls, a ray that falls stays in the ground. Source: Bán, Valasek,
/// Bálint and Vad, "Robust Cone Step Mapping", EGSR 2024, relaxed cones.
pub(super) fn falling([width, height]: [u32; 2], wrap: bool, heights: &[f32], mirror: Mirror) -> Vec<f32> {
    let next = |at: u32, side: u32, back: bool| match (back, wrap) {
        (false, _) if at + 1 < side => Some(at + 1),
        (false, true) => Some(0),
        (true, _) if at > 0 => Some(at - 1),
        (true, true) => Some(side - 1),
        _ => None,
    };
    let at = |x: u32, y: u32| heights[y as usize * width as usize + x as usize];
    let falls = |x: u32, y: u32| {
        // Along a border there is still an edge, if no cell.
        let (x1, y1) = (next(x, width, mirror[0]).unwrap_or(x), next(y, height, mirror[1]).unwrap_or(y));
        let [a, b, c, d] = [at(x, y), at(x1, y), at(x, y1), at(x1, y1)];
        a > b || a > c || b > d || c > d
    };
    let texels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    texels.map(|(x, y)| if falls(x, y) { at(x, y) } else { f32::NEG_INFINITY }).collect()
}
