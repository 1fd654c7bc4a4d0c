//! How a texel narrows a cone.

use super::quadrant::{Apex, Quadrant, Rule};

/// Round cones from a texel: Dummer's, and the relaxed ones.
pub(super) struct Round;

/// Square cones from a cell, safe over the bilinear surface.
pub(super) struct Square;

impl Rule for Round {
    fn reaches(&self, climb: f64, away: [i32; 2], slope: f64) -> bool {
        climb * climb > slope * slope * squared(away)
    }

    fn slope(&self, quadrant: &Quadrant, apex: &Apex, texel: [i32; 2]) -> f64 {
        let climb = quadrant.height(texel).unwrap_or(f64::NEG_INFINITY) - apex.height;
        if climb > 0.0 { climb / squared(apex.away(texel)).sqrt() } else { 0.0 }
    }
}

fn squared([x, y]: [i32; 2]) -> f64 {
    f64::from(x) * f64::from(x) + f64::from(y) * f64::from(y)
}

impl Rule for Square {
    fn reaches(&self, climb: f64, [x, y]: [i32; 2], slope: f64) -> bool {
        // Half a texel nearer than it is: so near is the middle of the two texels beside a diagonal.
        climb > slope * (f64::from(x.max(y)) - 0.5)
    }

    /// Distances are those to the cell, the larger of both axes. Over a cell that no diagonal crosses they are linear along one
    /// axis and constant along the other, and the surface is linear along either: what is true at the corners is true
    /// between them. Over one on the diagonal, from (a, a) to (a + 1, a + 1), both are quadratics along the diagonal; their
    /// middle control points, half the sum of the two corners beside it and a + 1/2, have to compare as well.
    fn slope(&self, quadrant: &Quadrant, apex: &Apex, texel: [i32; 2]) -> f64 {
        let away = apex.away(texel);
        let farther = away[0].max(away[1]);
        let climb = |texel: [i32; 2]| quadrant.height(texel).map_or(0.0, |height| (height - apex.height).max(0.0));
        if farther == 0 {
            return 0.0;
        }
        let own = climb(texel);
        let corner = [0, 1].map(|axis| texel[axis] - away[axis]);
        let beside = (away[0] - away[1]).abs() == 1 && corner == [0, 1].map(|axis| apex.at[axis] + apex.extent);
        let other = if beside { climb([corner[0] + away[1], corner[1] + away[0]]) } else { 0.0 };
        let middle = if beside { (own + other) / f64::from(away[0] + away[1]) } else { 0.0 };
        middle.max(own / f64::from(farther))
    }
}
