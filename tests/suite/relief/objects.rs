//! Solids in displaced ground against f64: where they are in front of it, what they look like there, and what they throw their
//! shadow on.

use glam::DVec3;
use terrane::render::{Camera, Gpu, NEAR, Object, Solid, View, sun_direction};
use terrane_shaderlib::heightfield::{Border, Heights, Texels};

use super::device;
use super::plain::{IMAGE, MIDDLE, Plain, SHAPE, Shape, rough, sights};
use super::rendered::{GRAZING, WHOLE, mips, under};

/// A sphere whose upper part is out of the ground and whose lower part is among stones and pits.
const SPHERE: (DVec3, f64) = (DVec3::new(MIDDLE.x + 1.1, -0.05, MIDDLE.z + 3.9), 0.22);

/// Metres along the ray by which relief and sphere must be apart, so that rounding does not decide which is in front. That of a
/// sphere is largest where a ray touches it: of a chord's square 1e-6 m² may be lost, 1 mm of the chord.
const APART: f64 = 2e-3;

fn object(solid: Solid, center: DVec3) -> Object {
    Object { solid, center: center.to_array(), albedo: [0.9, 0.02, 0.02], roughness: 0.9 }
}

/// Metres from the eye along a ray of length 1 to a sphere.
fn sphere(eye: DVec3, ray: DVec3) -> Option<f64> {
    let (center, radius) = SPHERE;
    let along = (center - eye).dot(ray);
    let square = radius * radius - (eye + ray * along - center).length_squared();
    (square > 0.0).then(|| along - square.sqrt())
}

/// A relief that is as low as it can be everywhere.
fn level() -> Heights {
    Heights::new([64; 2], Border::Wrap, Texels::U16(vec![0; 64 * 64])).expect("a map")
}

/// Pixels of a picture.
fn pixels(bytes: &[u8]) -> Vec<[u8; 3]> {
    bytes.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
}

/// Metres along every pixel's ray, from the depth that is written.
fn distances(view: &View, depth: &[f32]) -> Vec<f64> {
    let metres = |(ray, depth): (DVec3, &f32)| NEAR / f64::from(*depth) / ray.dot(view.forward);
    sights(view).iter().map(|sight| sight.ray).zip(depth).map(metres).collect()
}

/// How often each came out in front, and pixels that show another than they must.
#[derive(Debug, Default)]
struct Count {
    sphere: usize,
    /// The sphere, lower than the height map's ground.
    sunk: usize,
    /// Ground before the sphere, and the sphere higher than all pits.
    hidden: usize,
    wrong: usize,
}

#[test]
fn a_sphere_in_displaced_ground_is_cut_by_the_relief_pixel_by_pixel() {
    let Some(gpu) = device() else { return };
    let view = GRAZING.view(IMAGE[0], IMAGE[1]).expect("a good camera");
    let (center, radius) = SPHERE;
    let solids = [object(Solid::Sphere { radius }, center)];
    let rendered = Plain::new(&rough(64), WHOLE).furnished(&solids).render(&gpu, GRAZING);
    // On ground as deep as the relief all that can be seen of the sphere is seen, and no stone is before the sun.
    let bare = pixels(&Plain::new(&level(), WHOLE).furnished(&solids).render(&gpu, GRAZING).image.pixels);
    let mips = mips(rough(64));
    let mut count = Count::default();
    let (found, seen) = (distances(&view, &rendered.depth), pixels(&rendered.image.pixels));
    for (index, sight) in sights(&view).iter().enumerate() {
        let ground = sight.ground + under(&mips, 0, view.eye + sight.ray * sight.ground, sight.ray);
        let solid = sphere(view.eye, sight.ray).unwrap_or(f64::INFINITY);
        if (solid - ground).abs() < APART {
            continue;
        }
        let nearer = solid < ground;
        let low = view.eye.y + sight.ray.y * solid;
        count.sphere += usize::from(nearer);
        count.sunk += usize::from(nearer && low < 0.0);
        count.hidden += usize::from(!nearer && solid.is_finite() && low > -WHOLE.depth);
        let pixel = seen[index];
        let is_red = u16::from(pixel[0]) > 2 * u16::from(pixel[2]);
        let looks = is_red == nearer && (!nearer || low < 0.0 || pixel == bare[index]);
        let right = (found[index] - solid.min(ground)).abs() < APART && looks;
        count.wrong += usize::from(!right);
    }
    assert!(count.sphere > 500 && count.sunk > 100 && count.hidden > 100, "{count:?}");
    // As often as the search for relief itself may miss an edge.
    assert!(count.wrong <= found.len() / 500, "{count:?}");
}

/// Looking down on three solids.
const ABOVE: Camera = Camera { eye: [MIDDLE.x, 6.0, MIDDLE.z + 3.0], target: [MIDDLE.x, 0.0, MIDDLE.z], fov: 34.0 };

/// Faded where it begins.
const FLAT: Shape = Shape { fade: (0.5, 1.0), ..SHAPE };

fn three() -> [Object; 3] {
    let at = |x: f64, y: f64, z: f64| MIDDLE + DVec3::new(x, y, z);
    [
        object(Solid::Sphere { radius: 0.2 }, at(-0.4, 0.3, -0.9)),
        object(Solid::Box { size: [0.5, 0.3, 0.2], turn: 25.0 }, at(-0.4, 0.1, 0.1)),
        object(Solid::Column { radius: 0.12, height: 0.6 }, at(-0.4, 0.28, 1.1)),
    ]
}

/// Whether a point lies in a solid.
fn contains(object: &Object, point: DVec3) -> bool {
    let from = point - DVec3::from(object.center);
    match object.solid {
        Solid::Sphere { radius } => from.length() < radius,
        Solid::Column { radius, height } => from.x.hypot(from.z) < radius && from.y.abs() < height / 2.0,
        Solid::Box { size, turn } => {
            // Clockwise from above is from east to south.
            let (sin, cos) = turn.to_radians().sin_cos();
            let own = DVec3::new(from.x * cos + from.z * sin, from.y, from.z * cos - from.x * sin);
            own.abs().cmplt(DVec3::from(size) / 2.0).all()
        }
    }
}

/// Metres of a step along a ray.
const STEP: f64 = 1e-3;

/// Where the first of some solids is met between two distances, step by step.
fn marched(objects: &[Object], origin: DVec3, way: DVec3, (from, to): (f64, f64)) -> Option<f64> {
    let steps = (0..((to - from) / STEP) as usize).map(|step| from + step as f64 * STEP);
    steps.into_iter().find(|t| objects.iter().any(|object| contains(object, origin + way * *t)))
}

#[test]
fn solids_are_met_where_a_ray_enters_them() {
    let Some(gpu) = device() else { return };
    let view = ABOVE.view(IMAGE[0], IMAGE[1]).expect("a good camera");
    let objects = three();
    let rendered = Plain::new(&rough(64), FLAT).furnished(&objects).render(&gpu, ABOVE);
    let mut met = 0;
    for (sight, found) in sights(&view).iter().zip(distances(&view, &rendered.depth)) {
        // All of them are lower than 0.7 m.
        let first = (view.eye.y - 0.7) / -sight.ray.y;
        let truth = marched(&objects, view.eye, sight.ray, (first, sight.ground));
        met += usize::from(truth.is_some());
        let off = (found - truth.unwrap_or(sight.ground)).abs();
        // A ray that only touches a solid may step over it.
        let grazes = || {
            let near = marched(&objects, view.eye, sight.ray, (found - 4e-3, found + 4e-3));
            near.is_some() || truth.is_some_and(|truth| touches(&objects, view.eye + sight.ray * truth))
        };
        assert!(off < 2.0 * STEP || grazes(), "{found} m, the truth is {truth:?} m, ground {} m", sight.ground);
    }
    assert!(met > 300, "only {met} pixels of solids");
}

/// Whether a point lies within 1 mm of the surface of a solid.
fn touches(objects: &[Object], point: DVec3) -> bool {
    let around = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
    around.into_iter().any(|axis| !objects.iter().any(|object| contains(object, point + axis * 1e-3)))
}

/// Rays to the sun's middle and around its disc, 1.5 of its radii from there.
fn rays(sun: DVec3) -> [DVec3; 5] {
    let aside = sun.cross(DVec3::Y).normalize() * 0.00465 * 1.5;
    let up = aside.cross(sun);
    [sun, sun + aside, sun - aside, sun + up, sun - up].map(DVec3::normalize)
}

fn luminance([r, g, b]: [u8; 3]) -> f64 {
    0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
}

/// Pixels of the ground in the shadow of a solid, and in the sun.
fn check_shadows(gpu: &Gpu, objects: &[Object]) -> (usize, usize) {
    let view = ABOVE.view(IMAGE[0], IMAGE[1]).expect("a good camera");
    // Nothing but the solids throws a shadow.
    let plain = || Plain::new(&level(), FLAT);
    let before = pixels(&plain().render(gpu, ABOVE).image.pixels);
    let after = pixels(&plain().furnished(objects).render(gpu, ABOVE).image.pixels);
    let sun = sun_direction(250.0, 35.0);
    let (mut shadow, mut lit) = (0, 0);
    for (index, sight) in sights(&view).iter().enumerate() {
        let first = (view.eye.y - 0.7) / -sight.ray.y;
        if marched(objects, view.eye, sight.ray, (first, sight.ground)).is_some() {
            continue;
        }
        let ground = view.eye + sight.ray * sight.ground;
        let hits = rays(sun).map(|way| marched(objects, ground, way, (0.0, 1.5)).is_some());
        let left = luminance(after[index]) / luminance(before[index]);
        if hits.into_iter().all(|hit| hit) {
            shadow += 1;
            assert!(left < 0.75, "pixel {index}: {left} of the light in the shadow");
        } else if !hits.into_iter().any(|hit| hit) {
            lit += 1;
            assert!(left > 0.9, "pixel {index}: {left} of the light in the sun");
        }
    }
    (shadow, lit)
}

#[test]
fn every_solid_throws_its_shadow_on_the_ground() {
    let Some(gpu) = device() else { return };
    for object in three() {
        let (shadow, lit) = check_shadows(&gpu, &[object]);
        assert!(shadow > 60 && lit > 4000, "{object:?}: {shadow} pixels in the shadow, {lit} in the sun");
    }
}
