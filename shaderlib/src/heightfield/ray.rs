//! A ray, and where it meets the ground.

/// A ray: `origin + t direction`. Both count in texels from the centre of the first, and in steps of height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where t is 0: x and y in texels, z in steps.
    pub origin: [f64; 3],
    /// How far 1 of t leads. Any length, 0 too.
    pub direction: [f64; 3],
}

/// The first point of a ray that is not above the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// How far along the ray, in lengths of its direction.
    pub t: f64,
    /// The cell, unwrapped: beyond the first tile of a wrapped map it goes on counting.
    pub cell: [i64; 2],
    /// The point in the cell, 0..1 along each side.
    pub uv: [f64; 2],
}

/// A ray in fixed point, for arithmetic that is exact. All of it counts in 1/256: of a texel, and of a step of height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FixedRay {
    /// Where t is 0.
    pub origin: [i64; 3],
    /// How far 1 of t leads.
    pub direction: [i32; 3],
}

impl Ray {
    /// The point at t.
    #[must_use]
    pub fn at(&self, t: f64) -> [f64; 3] {
        [0, 1, 2].map(|axis| t.mul_add(self.direction[axis], self.origin[axis]))
    }
}

impl From<FixedRay> for Ray {
    /// The same ray: exactly, if its origin is below 2^53 in every coordinate.
    fn from(fixed: FixedRay) -> Self {
        let (origin, direction) = (fixed.origin, fixed.direction);
        Self { origin: origin.map(|at| at as f64 / 256.0), direction: direction.map(|at| f64::from(at) / 256.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fixed_point_is_converted_exactly() {
        let ray = Ray::from(FixedRay { origin: [257, -1, 1 << 52], direction: [-64, 3, 0] });
        assert_eq!(ray.origin, [1.003_906_25, -0.003_906_25, (1_u64 << 44) as f64]);
        assert_eq!(ray.direction, [-0.25, 0.011_718_75, 0.0]);
        assert_eq!(ray.at(4.0), [0.003_906_25, 0.042_968_75, (1_u64 << 44) as f64]);
    }
}
