//! What the concrete domains share: integers are `u32`, conditions are `bool`, and all of them are known.

use super::Domain;
use crate::machine::texture::{Footprint, Load, Sample, Textures};

/// The methods of [`Domain`](super::Domain) that do not depend on the float.
macro_rules! concrete {
    () => {
        const DECIDED: bool = true;

        #[inline(always)]
        fn int(bits: u32) -> u32 {
            bits
        }
        #[inline(always)]
        fn truth(value: bool) -> bool {
            value
        }
        #[inline(always)]
        fn int_unary(op: IntUnary, x: u32) -> u32 {
            op.apply(x)
        }
        #[inline(always)]
        fn int_binary(op: IntBinary, a: u32, b: u32) -> u32 {
            op.apply(a, b)
        }
        #[inline(always)]
        fn int_comparison(op: IntComparison, a: u32, b: u32) -> bool {
            op.apply(a, b)
        }
        #[inline(always)]
        fn not(x: bool) -> bool {
            !x
        }
        #[inline(always)]
        fn truth_binary(op: TruthBinary, a: bool, b: bool) -> bool {
            match op {
                TruthBinary::And => a & b,
                TruthBinary::Or => a | b,
                TruthBinary::Equal => a == b,
                TruthBinary::NotEqual => a != b,
            }
        }
        #[inline(always)]
        fn float_comparison(op: FloatComparison, a: Self::Float, b: Self::Float) -> bool {
            match op {
                FloatComparison::Equal => a == b,
                FloatComparison::NotEqual => a != b,
                FloatComparison::Less => a < b,
                FloatComparison::LessEqual => a <= b,
            }
        }
        #[inline(always)]
        fn dot(a: &[Self::Float], b: &[Self::Float]) -> Self::Float {
            let first = a[0] * b[0];
            a.iter().zip(b).skip(1).fold(first, |sum, (a, b)| sum + a * b)
        }
        #[inline(always)]
        fn select_float(condition: bool, accept: Self::Float, reject: Self::Float) -> Self::Float {
            if condition { accept } else { reject }
        }
        #[inline(always)]
        fn select_int(condition: bool, accept: u32, reject: u32) -> u32 {
            if condition { accept } else { reject }
        }
        #[inline(always)]
        fn select_truth(condition: bool, accept: bool, reject: bool) -> bool {
            if condition { accept } else { reject }
        }
        #[inline(always)]
        fn decide(condition: bool) -> Option<bool> {
            Some(condition)
        }
        #[inline(always)]
        fn known(x: u32) -> Option<u32> {
            Some(x)
        }
        fn candidates(x: u32) -> Option<Vec<u32>> {
            Some(vec![x])
        }
        fn sample(textures: &dyn Textures, sample: &Sample<Self::Float, u32>) -> Option<[Self::Float; 4]> {
            super::concrete::sample::<Self>(textures, sample)
        }
        fn load(textures: &dyn Textures, load: &Load<u32>) -> Option<[Self::Float; 4]> {
            let texel = super::concrete::load(textures, load)?;
            Some(texel.map(<Self as super::concrete::Real>::measured))
        }
        fn load_int(textures: &dyn Textures, load: &Load<u32>) -> Option<[u32; 4]> {
            let texel = super::concrete::load(textures, load)?;
            Some(texel.map(|value| value as i64 as u32))
        }
    };
}

pub(super) use concrete;

/// A domain whose floats are numbers.
pub(super) trait Real: Domain<Int = u32> {
    /// The number, for the host.
    fn wide(x: Self::Float) -> f64;
    /// A number from the host.
    fn measured(value: f64) -> Self::Float;
}

pub(super) fn sample<D: Real>(textures: &dyn Textures, sample: &Sample<D::Float, u32>) -> Option<[D::Float; 4]> {
    let request = Sample {
        texture: sample.texture,
        sampler: sample.sampler,
        layer: sample.layer as i32,
        uv: sample.uv.map(D::wide),
        offset: sample.offset,
        footprint: match sample.footprint {
            Footprint::Level(level) => Footprint::Level(D::wide(level)),
            Footprint::Gradient { ddx, ddy } => Footprint::Gradient { ddx: ddx.map(D::wide), ddy: ddy.map(D::wide) },
        },
    };
    Some(textures.sample(&request)?.map(D::measured))
}

pub(super) fn load(textures: &dyn Textures, load: &Load<u32>) -> Option<[f64; 4]> {
    textures.load(&Load {
        texture: load.texture,
        at: load.at.map(|at| at as i32),
        layer: load.layer as i32,
        level: load.level as i32,
    })
}

/// The largest floats that convert to an integer without leaving its range: WGSL clamps to them.
pub(super) const I32_RANGE: (f32, f32) = (-2_147_483_648.0, 2_147_483_520.0);
/// As [`I32_RANGE`].
pub(super) const U32_RANGE: (f32, f32) = (0.0, 4_294_967_040.0);
