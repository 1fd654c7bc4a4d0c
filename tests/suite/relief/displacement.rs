//! The switches of quadtree displacement mapping, one by one (Drobot 2010, section 1.4.3).

use terrane::relief::{Outcome, Traced, Tracer};
use terrane::render::Gpu;
use terrane_shaderlib::heightfield::adversary::{Depth, Land, map};
use terrane_shaderlib::heightfield::{Border, Ray, first_hit};
use terrane_shaderlib::relief::{Displacement, Method, Placed};

use super::scene::{Scene, wall};
use super::{Segment, device};

const PUBLISHED: Displacement = Displacement::PUBLISHED;

/// A ray that ends on level ground, past a needle that stands in its way on the coarser levels.
fn passing() -> Scene {
    let height = |x, y| u16::from([x, y] == [0, 5]) * 600;
    Scene::new([8, 8], height, [0.25, 1.0, 601.0], [1.0, 0.0, -64.0])
}

fn trace(gpu: &Gpu, scene: &Scene, switches: Displacement) -> (f64, u32) {
    let traced = scene.trace(gpu, Method::QuadtreeDisplacement(switches));
    let Outcome::Hit(t) = traced.outcome else { panic!("{switches}: {traced:?}") };
    (t, traced.steps)
}

#[test]
fn without_ascent_the_same_place_is_found_on_the_same_level() {
    let Some(gpu) = device() else { return };
    let scene = wall(4, [0.25, 1.0], [1.0, 0.0]);
    let (up, stays) =
        (trace(&gpu, &scene, PUBLISHED), trace(&gpu, &scene, Displacement { ascends: false, ..PUBLISHED }));
    assert_eq!(up.0, stays.0);
    assert_eq!(up.1, stays.1 + 1, "the level above is looked at once more");
}

#[test]
fn more_nodes_are_allowed_to_level_views() {
    let Some(gpu) = device() else { return };
    let caps = |steep| Displacement { caps: Some([5, 64]), steep, ..PUBLISHED };
    // 64 steps down on a texel on: a slope of 45° if that many make a texel, of almost 0° or 90° if very many or few do.
    let (level, straight) = (trace(&gpu, &passing(), caps(6400)), trace(&gpu, &passing(), caps(1)));
    assert!((level.0 - passing().truth()).abs() < 1e-3, "{level:?}");
    assert_eq!(straight.1, 5, "{straight:?}");
}

#[test]
fn a_search_that_stops_early_ends_on_the_plane_of_a_node() {
    let Some(gpu) = device() else { return };
    // The needle's node of the second level, two by two texels, is a box; the ray goes through it beside the needle.
    let height = |x, y| u16::from([x, y] == [5, 1]) * 600;
    let scene = Scene::new([8, 8], height, [0.25, 0.0, 601.0], [1.0, 0.0, -64.0]);
    let fine = trace(&gpu, &scene, PUBLISHED);
    let coarse = trace(&gpu, &scene, Displacement { stop: 256, ..PUBLISHED });
    assert_eq!(fine.0.round(), 9.0, "on the ground");
    assert_eq!(coarse.0, 3.25, "at the border of texels 4 and 5");
    assert!(coarse.1 < fine.1);
}

#[test]
fn between_levels_heights_are_mixed() {
    let Some(gpu) = device() else { return };
    // All texels of even rows and columns are 400 high, the others 200: a level up everything is 400.
    let height = |x, y| if (x | y) % 2 == 0 { 400 } else { 200 };
    let scene = Scene::new([8, 8], height, [1.0, 1.0, 401.0], [1.0 / 1024.0, 0.0, -1024.0]);
    let at = |stop, interpolates| {
        let (t, _) = trace(&gpu, &scene, Displacement { stop, interpolates, ..PUBLISHED });
        scene.height(t).round()
    };
    assert_eq!(
        [at(0, true), at(64, true), at(128, true), at(128, false), at(256, true)],
        [200.0, 250.0, 300.0, 200.0, 400.0]
    );
}

#[test]
fn a_fade_leaves_a_share_of_the_shift() {
    let Some(gpu) = device() else { return };
    let whole = trace(&gpu, &passing(), PUBLISHED).0;
    for keep in [0, 64, 256] {
        assert_eq!(trace(&gpu, &passing(), Displacement { keep, ..PUBLISHED }).0, whole * f64::from(keep) / 256.0);
    }
}

#[test]
fn a_linear_step_brings_hits_on_smooth_ground_nearer_to_the_surface() {
    let Some(gpu) = device() else { return };
    let heights = map(Land::Hills, [64, 64], Border::Wrap, Depth::Sixteen, 1).expect("a map");
    // Straight enough that no ray meets its border, in the direction in which the listing is right.
    let ray = |index: u32| Ray {
        origin: [0.3 + f64::from(index % 16) * 3.7, 0.4 + f64::from(index / 16) * 3.3, 65535.0],
        direction: [1.0, 0.7, -16384.0],
    };
    let sent: Vec<Segment> = (0..256).map(|index| Segment { ray: ray(index), range: (0.0, 4.1) }).collect();
    let error = |method: Method| {
        let placed = Placed::new(&heights, method.bounds(), 4096).expect("sides are powers of two");
        let tracer = Tracer::new(&gpu, &heights, &placed, method).expect("the device takes it");
        let (traced, _) = tracer.trace(&sent).expect("the device answers");
        sent.iter().zip(&traced).map(|(segment, traced)| error(&heights, segment, traced)).sum::<f64>() / 256.0
    };
    let [plain, refined] =
        [false, true].map(|refines| error(Method::QuadtreeDisplacement(Displacement { refines, ..PUBLISHED })));
    assert!(refined < 0.5 * plain, "{refined} texels, without {plain}");
}

fn error(heights: &terrane_shaderlib::heightfield::Heights, segment: &Segment, traced: &Traced) -> f64 {
    let truth = first_hit(heights, &segment.ray, segment.range).map_or(segment.range.1, |hit| hit.t);
    match traced.outcome {
        Outcome::Hit(t) => (t - truth).abs(),
        Outcome::Miss | Outcome::Unresolved => segment.range.1,
    }
}
