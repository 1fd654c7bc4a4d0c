//! Where the picture is taken from.

use glam::{DMat4, DVec3, DVec4, Mat4};

use super::error::{RenderError, Result};

/// A pinhole camera. x east, y up, z south, metres from the terrain's north-west corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where from.
    pub eye: [f64; 3],
    /// A point in the middle of the picture.
    pub target: [f64; 3],
    /// Vertical field of view in degrees.
    pub fov: f64,
}

/// Metres in front of the eye that are not drawn. With a reversed depth that has no far plane, precision does not
/// depend on it (Reed, "Depth Precision Visualized", 2015).
pub const NEAR: f64 = 0.25;

/// A camera with its picture's shape: axes, matrix, and size of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Eye in metres.
    pub eye: DVec3,
    /// Unit vector to the right of the picture.
    pub right: DVec3,
    /// Unit vector to the top of the picture.
    pub up: DVec3,
    /// Unit vector into the picture.
    pub forward: DVec3,
    /// Half the picture's width and height at a distance of 1.
    pub half: [f64; 2],
}

impl Camera {
    /// The camera for a picture of that many pixels.
    ///
    /// # Errors
    /// [`RenderError::Scene`] where eye and target coincide, a number is not finite or the field of view is not within
    /// 1..150 degrees.
    pub fn view(&self, width: u32, height: u32) -> Result<View> {
        let (eye, target) = (DVec3::from(self.eye), DVec3::from(self.target));
        if !(eye.is_finite() && target.is_finite()) {
            return Err(RenderError::Scene("camera: eye and target must be finite".into()));
        }
        if !(1.0..=150.0).contains(&self.fov) {
            return Err(RenderError::Scene(format!(
                "camera: a field of view of {} is not in 1..150 degrees",
                self.fov
            )));
        }
        let Some(forward) = (target - eye).try_normalize() else {
            return Err(RenderError::Scene("camera: the target must not be the eye".into()));
        };
        // Straight up or down, east is to the right.
        let right = forward.cross(DVec3::Y).try_normalize().unwrap_or(DVec3::X);
        let tall = (self.fov.to_radians() * 0.5).tan();
        let half = [tall * f64::from(width) / f64::from(height), tall];
        Ok(View { eye, right, up: right.cross(forward), forward, half })
    }
}

impl View {
    /// From metres relative to the eye to clip space: depth 1 at [`NEAR`], 0 at infinity.
    #[must_use]
    pub fn clip_from_eye(&self) -> Mat4 {
        let view = DMat4::from_cols(
            self.right.extend(0.0),
            self.up.extend(0.0),
            (-self.forward).extend(0.0),
            DVec3::ZERO.extend(1.0),
        )
        .transpose();
        let project = DMat4::from_cols(
            DVec4::new(1.0 / self.half[0], 0.0, 0.0, 0.0),
            DVec4::new(0.0, 1.0 / self.half[1], 0.0, 0.0),
            DVec4::new(0.0, 0.0, 0.0, -1.0),
            DVec4::new(0.0, 0.0, NEAR, 0.0),
        );
        (project * view).as_mat4()
    }

    /// Unit vector through a point of the picture; (0, 0) is its left upper and (1, 1) its right lower corner.
    #[must_use]
    pub fn ray(&self, across: f64, down: f64) -> DVec3 {
        let right = (2.0 * across - 1.0) * self.half[0];
        let up = (1.0 - 2.0 * down) * self.half[1];
        (self.forward + self.right * right + self.up * up).normalize()
    }

    /// Pixels per radian near the middle of a picture that is `height` pixels tall.
    #[must_use]
    pub fn pixels_per_radian(&self, height: u32) -> f64 {
        f64::from(height) / (2.0 * self.half[1])
    }

    /// The planes of the frustum, as inward normals of planes through the eye: left, right, top, bottom, near.
    #[must_use]
    pub fn planes(&self) -> [DVec3; 5] {
        let [wide, tall] = self.half;
        [
            (self.forward * wide + self.right).normalize(),
            (self.forward * wide - self.right).normalize(),
            (self.forward * tall - self.up).normalize(),
            (self.forward * tall + self.up).normalize(),
            self.forward,
        ]
    }
}

/// Unit vector to the sun: degrees clockwise from north (−z) and above the horizon.
#[must_use]
pub fn sun_direction(azimuth: f64, elevation: f64) -> DVec3 {
    let (sin, cos) = azimuth.to_radians().sin_cos();
    let (up, flat) = elevation.to_radians().sin_cos();
    DVec3::new(sin * flat, up, -cos * flat)
}
