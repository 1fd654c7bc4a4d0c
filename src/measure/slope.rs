//! Which way the surface faces, in texels along all three axes.

use terrane_shaderlib::heightfield::Heights;

/// The normal of a cell's patch, of length 1; `scale` is texels to a step of height.
pub(super) fn normal(heights: &Heights, scale: f64, cell: [i64; 2], [u, v]: [f64; 2]) -> [f64; 3] {
    let [a, b, c, d] = heights.corners(cell[0], cell[1]);
    let east = (b - a) * (1.0 - v) + (d - c) * v;
    let south = (c - a) * (1.0 - u) + (d - b) * u;
    unit([-east * scale, -south * scale, 1.0])
}

/// |n·d|: 1 where a ray of so many texels and steps comes straight onto the surface, 0 where it runs along it.
pub(super) fn facing(normal: [f64; 3], scale: f64, [x, y, z]: [f64; 3]) -> f64 {
    dot(normal, unit([x, y, z * scale])).abs()
}

/// Degrees between two directions of length 1.
pub(super) fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    // Of an arc cosine, small angles would keep half of the digits.
    dot(cross, cross).sqrt().atan2(dot(a, b)).to_degrees()
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = dot(vector, vector).sqrt();
    vector.map(|part| part / length.max(f64::MIN_POSITIVE))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use terrane_shaderlib::heightfield::{Border, Texels};

    use super::*;

    #[test]
    fn normals_lean_away_from_what_rises() {
        let heights = Heights::new([2, 2], Border::Clamp, Texels::U16(vec![0, 4, 0, 4])).unwrap();
        let leaning = normal(&heights, 0.25, [0, 0], [0.3, 0.7]);
        let half = 0.5_f64.sqrt();
        assert!((leaning[0] + half).abs() < 1e-12 && leaning[1] == 0.0 && (leaning[2] - half).abs() < 1e-12);
        assert!((angle(leaning, [0.0, 0.0, 1.0]) - 45.0).abs() < 1e-12);
        assert!((angle([0.0, 1e-9, 1.0], [0.0, 0.0, 1.0]) - 1e-9_f64.to_degrees()).abs() < 1e-20);
        // Against it, and along it.
        assert!((facing(leaning, 0.25, [1.0, 0.0, -4.0]) - 1.0).abs() < 1e-12);
        assert!(facing(leaning, 0.25, [1.0, 0.0, 4.0]) < 1e-12);
    }
}
