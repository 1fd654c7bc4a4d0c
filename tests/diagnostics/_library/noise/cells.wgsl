//! Distances to scattered points.
//! Source: test.

/// What `cells` gives.
struct Cells {
    /// To the nearest point.
    f1: f32,
    /// To the second nearest.
    f2: f32,
    /// Of the nearest point.
    center: vec2f,
}

/// cells(Place(vec2i(0), vec3f(0.0), vec3f(0.0), vec3f(0.0)), 8.0).f1 == 0.0 +- 1.0
/// -> Two distances.
fn cells(
    /// Where.
    position: Place,
    /// Mean distance of the points. [m] 0.01..100000
    wavelength: f32,
) -> Cells {
    return Cells(0.0, position.local.x / wavelength, vec2f(0.0));
}
