//! Ambient light lost in the hollows of a material, from its height alone: no direction, no sample, good enough for small relief.
//! Source: Drobot, "Quadtree Displacement Mapping with Height Blending", GPU Pro, 2010, section 1.8.2 (properties generated from the height on the fly).

/// occlusion_from_height(1.0, 0.6) == 1.0 +- 0
/// occlusion_from_height(0.0, 0.6) == 0.4 +- 1e-6
/// occlusion_from_height(0.5, 0.6) == 0.85 +- 1e-6
/// -> 1 is open, 0 is closed. 0..1
fn occlusion_from_height(
    /// Of the material's own relief. 0..1
    height: f32,
    /// How dark the deepest parts get. 0..1 = 0.6
    amount: f32,
) -> f32 {
    let deep = 1.0 - height;
    return saturate(1.0 - amount * deep * deep);
}
