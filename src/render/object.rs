//! Solids that stand on a terrain.

use glam::DVec3;
use terrane_shaderlib::hosts;

use super::error::{RenderError, Result};

/// A solid of one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Its shape.
    pub solid: Solid,
    /// Its middle: metres from the terrain's north-west corner, x east, y up, z south.
    pub center: [f64; 3],
    /// Linear, 0..1.
    pub albedo: [f32; 3],
    /// 0..1.
    pub roughness: f32,
}

/// A shape, in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// A sphere.
    Sphere {
        /// Radius.
        radius: f64,
    },
    /// A cuboid that stands upright.
    Box {
        /// Extent along its own axes: to the east, up and to the south, before it is turned.
        size: [f64; 3],
        /// Degrees clockwise, seen from above.
        turn: f64,
    },
    /// A cylinder that stands upright.
    Column {
        /// Radius.
        radius: f64,
        /// From its foot to its top.
        height: f64,
    },
}

impl Solid {
    /// Half its extent along its own axes.
    pub(super) fn half_size(&self) -> DVec3 {
        match *self {
            Self::Sphere { radius } => DVec3::splat(radius),
            Self::Box { size, .. } => DVec3::from(size) * 0.5,
            Self::Column { radius, height } => DVec3::new(radius, height * 0.5, radius),
        }
    }

    /// Radius of the smallest sphere around it.
    pub(super) fn around(&self) -> f64 {
        let half = self.half_size();
        match self {
            Self::Sphere { radius } => *radius,
            Self::Box { .. } => half.length(),
            Self::Column { .. } => half.x.hypot(half.y),
        }
    }

    /// Degrees clockwise, seen from above.
    pub(super) fn turn(&self) -> f64 {
        match self {
            Self::Box { turn, .. } => *turn,
            Self::Sphere { .. } | Self::Column { .. } => 0.0,
        }
    }
}

/// Refuses what cannot be drawn.
pub(super) fn validate(objects: &[Object]) -> Result<()> {
    let refuse = |reason: String| Err(RenderError::Scene(format!("objects: {reason}")));
    if objects.len() > hosts::WGPU_OBJECTS {
        return refuse(format!("there are {}, at most {} can be drawn", objects.len(), hosts::WGPU_OBJECTS));
    }
    for (index, object) in objects.iter().enumerate() {
        let half = object.solid.half_size();
        if !(half.is_finite() && half.min_element() > 0.0 && object.solid.turn().is_finite()) {
            return refuse(format!("the extent of number {index} is not positive, or not finite"));
        }
        let look = object.albedo.iter().chain([&object.roughness]);
        if !DVec3::from(object.center).is_finite() || look.clone().any(|value| !(0.0..=1.0).contains(value)) {
            return refuse(format!("number {index} is not at a finite place, or its material is not in 0..1"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn object(solid: Solid) -> Object {
        Object { solid, center: [0.0; 3], albedo: [0.5; 3], roughness: 0.5 }
    }

    #[track_caller]
    fn refused(objects: &[Object], why: &str) {
        let error = validate(objects).expect_err("refused").to_string();
        assert!(error.contains(why), "{error}");
    }

    #[test]
    fn what_cannot_be_drawn_is_refused() {
        let good = object(Solid::Sphere { radius: 1.0 });
        validate(&[good; hosts::WGPU_OBJECTS]).expect("as many as there may be");
        refused(&[good; hosts::WGPU_OBJECTS + 1], "at most 16");
        refused(&[good, object(Solid::Column { radius: 1.0, height: 0.0 })], "extent of number 1");
        refused(&[object(Solid::Box { size: [1.0; 3], turn: f64::NAN })], "extent of number 0");
        refused(&[Object { center: [f64::INFINITY; 3], ..good }], "finite place");
        refused(&[Object { roughness: 1.5, ..good }], "0..1");
    }

    #[test]
    fn a_solid_lies_in_the_sphere_around_it() {
        assert_eq!(Solid::Sphere { radius: 2.0 }.around(), 2.0);
        assert_eq!(Solid::Column { radius: 3.0, height: 8.0 }.around(), 5.0);
        assert_eq!(Solid::Box { size: [2.0, 4.0, 4.0], turn: 30.0 }.around(), 3.0);
    }
}
