//! The texture that examples read: 4 by 4 texels, texel (x, y) = (x/3, y/3, (x+y) mod 2, 1), repeating, bilinear, one mip.

use terrane_codegen::machine::{Count, Load, Sample, Textures};

/// The example texture under every id.
pub(super) struct ExampleTexture;

impl Textures for ExampleTexture {
    fn sample(&self, sample: &Sample) -> Option<[f64; 4]> {
        let [u, v] = sample.uv.map(|coordinate| (coordinate - coordinate.floor()) * 4.0 - 0.5);
        let (x, y) = (u.floor(), v.floor());
        let row = |y: f64| lerp(texel(x, y), texel(x + 1.0, y), u - x);
        Some(lerp(row(y), row(y + 1.0), v - y))
    }

    fn load(&self, load: &Load) -> Option<[f64; 4]> {
        let inside = load.at.iter().all(|at| (0..4).contains(at));
        Some(if inside { texel(load.at[0].into(), load.at[1].into()) } else { [0.0; 4] })
    }

    fn size(&self, _: u32, _: u32) -> Option<[u32; 2]> {
        Some([4, 4])
    }

    fn count(&self, _: u32) -> Option<Count> {
        Some(Count { layers: 1, levels: 1 })
    }
}

fn texel(x: f64, y: f64) -> [f64; 4] {
    let (x, y) = (x.rem_euclid(4.0), y.rem_euclid(4.0));
    [x / 3.0, y / 3.0, (x + y) % 2.0, 1.0]
}

fn lerp(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    std::array::from_fn(|i| a[i] * (1.0 - t) + b[i] * t)
}
