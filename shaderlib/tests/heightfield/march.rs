//! On smooth ground, very many small steps find the same.

use terrane_shaderlib::heightfield::adversary::{Depth, Land, Rays, map};
use terrane_shaderlib::heightfield::{Border, Heights, Ray, first_hit, visible};

/// Steps in a texel.
const FINE: f64 = 256.0;

/// The first step at which the ray is in the ground, and the length of a step.
fn march(map: &Heights, ray: &Ray, end: f64) -> (Option<f64>, f64) {
    let step = 1.0 / (FINE * ray.direction[0].hypot(ray.direction[1]));
    let times = (0..=(end / step) as usize).map(|at| at as f64 * step);
    let last = map.size().map(|side| f64::from(side) - 1.0);
    let over =
        |x: f64, y: f64| map.border() == Border::Wrap || (0.0..=last[0]).contains(&x) && (0.0..=last[1]).contains(&y);
    let in_ground = |t: &f64| {
        let [x, y, z] = ray.at(*t);
        over(x, y) && z <= map.surface(x, y)
    };
    (times.into_iter().find(in_ground), step)
}

#[test]
fn the_first_hit_is_where_a_marcher_comes_under_ground() {
    let (mut hits, mut shallow) = (0, 0);
    for (at, border) in [Border::Wrap, Border::Clamp].into_iter().cycle().take(8).enumerate() {
        let map = map(Land::Hills, [40, 33], border, Depth::Sixteen, at as u64).unwrap();
        let mut source = Rays::new(&map, 7 * at as u64 + 1);
        for tangent in [0.02, 0.1, 0.364, 1.0, 5.67].into_iter().flat_map(|tangent| [tangent; 12]) {
            let case = source.above(tangent);
            let range = (0.0, case.end as f64);
            let hit = first_hit(&map, &case.ray, range).map(|hit| hit.t);
            assert_eq!(visible(&map, case.ray.origin, case.ray.direction, range), hit.is_none());
            let (marched, step) = march(&map, &case.ray, range.1);
            match (hit, marched) {
                (Some(hit), Some(marched)) if hit <= marched + 1e-9 && marched - hit <= step => hits += 1,
                // Between two steps it went in and came out again.
                (Some(hit), marched) if marched.is_none_or(|marched| hit < marched) => shallow += 1,
                (None, None) => {}
                _ => panic!("{case:?}: {hit:?}, but the marcher finds {marched:?}"),
            }
        }
    }
    assert!(hits > 200 && shallow * 100 < hits, "{hits} hits, {shallow} between two steps");
}
