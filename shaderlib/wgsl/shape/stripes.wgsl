//! Even waves across the ground in any direction: ripples of sand, ploughed land. Warp the place to bend them.
//! Source: Terrane; the phase is kept in whole numbers, so waves run on without a seam however far the terrain goes.

/// stripes(Place(vec2i(0, 0), vec3f(0.0, 0.0, 0.0), vec3f(0.0), vec3f(0.0)), 8.0, 90.0) == 1.0 +- 1e-5
/// stripes(Place(vec2i(512, 0), vec3f(0.0, 0.0, 0.0), vec3f(0.0), vec3f(0.0)), 8.0, 90.0) == 0.5 +- 1e-5
/// stripes(Place(vec2i(512, 77), vec3f(2.0, 0.0, 5.0), vec3f(0.0), vec3f(0.0)), 8.0, 90.0) == 0.0 +- 1e-5
/// -> A cosine, 1 on the crests. 0..1
fn stripes(
    /// Where.
    position: Place,
    /// From crest to crest. [m] 0.05..1024 = 0.5
    wavelength: f32,
    /// Where the waves run to, clockwise from north. [deg] -360..360 = 90.0
    azimuth: f32,
) -> f32 {
    let along = rotated(position, wavelength, azimuth);
    let size = coord_footprint(Coord(along.uv, vec2f(0.0, along.ddx.y), vec2f(0.0, along.ddy.y)));
    let crest = 0.5 - 0.5 * angle_unit(360.0 * fract(along.uv.y) - 180.0).x;
    return saturate(mix(0.5, crest, lattice_kept(1.0, size)));
}
