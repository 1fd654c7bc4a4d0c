//! Where the ground lies between two heights.
//! Source: Andersson, "Terrain Rendering in Frostbite Using Procedural Shader Splatting", 2007, section 5.2.3 (masks from height).

/// height_mask(500.0, 300.0, 700.0, 50.0) == 1.0 +- 1e-6
/// height_mask(700.0, 300.0, 700.0, 50.0) == 0.5 +- 1e-6
/// height_mask(100.0, 300.0, 700.0, 50.0) == 0.0 +- 0
/// -> Half way on either border. 0..1
fn height_mask(
    /// Height of the ground. [m] -12000..12000
    height: f32,
    /// Lower border. [m] -12000..12000 = 0.0
    low: f32,
    /// Upper border. [m] -12000..12000 = 1000.0
    high: f32,
    /// Width of a border, half of it outside. [m] 0..4000 = 50.0
    softness: f32,
) -> f32 {
    return between(height, low, high, softness);
}
