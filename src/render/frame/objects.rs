//! `HostObjects` of shaderlib/hosts/wgpu/objects.wgsl, byte for byte.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use terrane_shaderlib::hosts;

use crate::render::camera::View;
use crate::render::object::{Object, Solid};

/// The uniform block of the solids on a terrain. Members in the order and with the names of the shader's.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct ObjectsUniform {
    list: [One; hosts::WGPU_OBJECTS],
    count: u32,
    unused: [u32; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct One {
    center: [f32; 3],
    shape: u32,
    half_size: [f32; 3],
    roughness: f32,
    albedo: [f32; 3],
    around: f32,
    turn: [f32; 2],
    origin: [i32; 2],
    rest: [f32; 2],
    unused: [u32; 2],
}

impl ObjectsUniform {
    /// For terrain on which nothing stands.
    pub(crate) fn none() -> Self {
        Self::zeroed()
    }

    /// For no more objects than [`hosts::WGPU_OBJECTS`].
    pub(crate) fn new(objects: &[Object], view: &View) -> Self {
        let mut all = Self { count: objects.len() as u32, ..Self::none() };
        for (one, object) in all.list.iter_mut().zip(objects) {
            *one = One::new(object, view);
        }
        all
    }
}

impl One {
    fn new(object: &Object, view: &View) -> Self {
        let (sin, cos) = object.solid.turn().to_radians().sin_cos();
        let [x, _, z] = object.center;
        let origin = [x, z].map(|metres| (metres * 256.0).floor());
        Self {
            center: (DVec3::from(object.center) - view.eye).as_vec3().to_array(),
            shape: match object.solid {
                Solid::Sphere { .. } => 0,
                Solid::Box { .. } => 1,
                Solid::Column { .. } => 2,
            },
            half_size: object.solid.half_size().as_vec3().to_array(),
            roughness: object.roughness,
            albedo: object.albedo,
            around: object.solid.around() as f32,
            turn: [cos as f32, sin as f32],
            origin: origin.map(|units| units as i32),
            rest: [(x - origin[0] / 256.0) as f32, (z - origin[1] / 256.0) as f32],
            unused: [0; 2],
        }
    }
}
