use super::*;
use crate::heightfield::{Border, Texels};

const FOREVER: (f64, f64) = (0.0, f64::INFINITY);

/// 4 × 4 texels, flat but for one of height 100 at (1, 1).
fn needle(border: Border) -> Heights {
    let mut texels = vec![0; 16];
    texels[5] = 100;
    Heights::new([4, 4], border, Texels::U16(texels)).unwrap()
}

fn shoot(heights: &Heights, origin: [f64; 3], direction: [f64; 3]) -> Option<(f64, [i64; 2])> {
    first_hit(heights, &Ray { origin, direction }, FOREVER).map(|hit| (hit.t, hit.cell))
}

#[test]
fn meets_the_needle_wherever_it_comes_from() {
    let map = needle(Border::Wrap);
    assert_eq!(shoot(&map, [0.0, 1.0, 50.0], [1.0, 0.0, 0.0]), Some((0.5, [0, 1])));
    assert_eq!(shoot(&map, [2.0, 1.0, 50.0], [-1.0, 0.0, 0.0]), Some((0.5, [1, 1])));
    assert_eq!(shoot(&map, [1.0, -2.0, 50.0], [0.0, 2.0, 0.0]), Some((1.25, [1, 0])));
    assert_eq!(shoot(&map, [1.0, 1.0, 300.0], [0.0, 0.0, -50.0]), Some((4.0, [1, 1])), "vertical");
    assert_eq!(shoot(&map, [0.0, 1.0, 100.0], [1.0, 0.0, 0.0]), Some((1.0, [0, 1])), "grazes the tip");
    assert_eq!(shoot(&map, [0.0, 1.0, 100.5], [1.0, 0.0, 0.0]), None, "above everything, for ever");
}

#[test]
fn dips_into_a_patch_and_out_of_it() {
    let map = needle(Border::Clamp);
    let hit = shoot(&map, [0.0, 1.0, 20.0], [1.0, -1.0, 0.0]).unwrap();
    assert!((hit.0 - 0.276_393_202_250_021).abs() < 1e-15 && hit.1 == [0, 0], "{hit:?}");
    assert_eq!(shoot(&map, [0.0, 1.0, 25.0], [1.0, -1.0, 0.0]), Some((0.5, [0, 0])), "touches");
    assert_eq!(shoot(&map, [0.0, 1.0, 25.1], [1.0, -1.0, 0.0]), None);
}

#[test]
fn the_ground_is_solid() {
    let map = needle(Border::Wrap);
    assert_eq!(shoot(&map, [1.0, 1.0, 99.0], [0.0, 0.0, 1.0]), Some((0.0, [1, 1])));
    assert_eq!(shoot(&map, [2.5, 2.5, 0.0], [1.0, 1.0, 5.0]), Some((0.0, [2, 2])), "on the surface");
    assert_eq!(shoot(&map, [2.5, 2.5, -1.0], [0.0, 0.0, 0.0]), Some((0.0, [2, 2])), "a ray of one point");
    let hit = first_hit(&map, &Ray { origin: [0.0, 1.0, 50.0], direction: [1.0, 0.0, 0.0] }, (0.75, 2.0));
    assert_eq!(hit.map(|hit| hit.t), Some(0.75));
}

#[test]
fn a_clamped_map_ends() {
    let map = needle(Border::Clamp);
    assert_eq!(shoot(&map, [-5.0, 2.5, -1.0], [1.0, 0.0, 0.0]), Some((5.0, [0, 2])), "its side");
    assert_eq!(shoot(&map, [8.0, 3.0, -1.0], [-1.0, 0.0, 0.0]), Some((5.0, [2, 2])), "its last corner's row");
    assert_eq!(shoot(&map, [3.0, 3.0, 7.0], [0.0, 0.0, -1.0]), Some((7.0, [2, 2])), "its last corner");
    assert_eq!(shoot(&map, [3.001, 1.0, 7.0], [0.0, 0.0, -1.0]), None);
    assert_eq!(shoot(&map, [-5.0, 2.5, 5.0], [1.0, 0.0, -0.1]), None, "passes before it comes down");
    assert_eq!(shoot(&map, [-5.0, 3.5, -1.0], [1.0, 0.0, 0.0]), None);
}

#[test]
fn a_single_texel_is_a_point_or_the_whole_plane() {
    let map = |border| Heights::new([1, 1], border, Texels::U8(vec![9])).unwrap();
    assert_eq!(shoot(&map(Border::Clamp), [-1.0, -2.0, 9.0], [1.0, 2.0, 0.0]), Some((1.0, [0, 0])));
    assert_eq!(shoot(&map(Border::Clamp), [-1.0, -2.0, 9.0], [1.0, 1.0, 0.0]), None);
    assert_eq!(shoot(&map(Border::Wrap), [-1.5, -2.5, 10.0], [1.0, 2.0, -0.5]), Some((2.0, [0, 1])));
}

#[test]
fn no_scale_of_the_direction_loses_a_hit() {
    let map = needle(Border::Wrap);
    for scale in [1e-300, 2_f64.powi(-1022), 1e-9, 1e9, 1e300] {
        let (t, cell) = shoot(&map, [0.25, 0.875, 60.0], [3.0, 0.5, -8.0].map(|rate| rate * scale)).unwrap();
        let (one, expected) = shoot(&map, [0.25, 0.875, 60.0], [3.0, 0.5, -8.0]).unwrap();
        assert!((t * scale - one).abs() < 1e-15 && cell == expected, "{scale}: {}, not {one}", t * scale);
    }
}

#[test]
fn tiny_components_lead_nowhere() {
    let map = needle(Border::Wrap);
    for tiny in [0.0, -0.0, 5e-324, -5e-324, 1e-200, -1e-200] {
        let found = shoot(&map, [2.0, 1.0, 50.0], [-1.0, tiny, -tiny]).unwrap().0;
        assert!((found - 0.5).abs() < 1e-15, "{tiny}: {found}");
        assert_eq!(shoot(&map, [1.0, 1.0, 300.0], [tiny, -tiny, -50.0]).map(|hit| hit.0), Some(4.0), "{tiny}");
    }
}

#[test]
fn what_is_no_ray_meets_nothing() {
    let map = needle(Border::Wrap);
    for wrong in [f64::NAN, f64::INFINITY, 1e17] {
        assert_eq!(shoot(&map, [wrong, 0.0, 1.0], [1.0, 1.0, -1.0]), None);
    }
    assert_eq!(shoot(&map, [0.0, 0.0, 1.0], [f64::NAN, 1.0, -1.0]), None);
    let ray = Ray { origin: [0.0, 0.0, -1.0], direction: [1.0, 0.0, 0.0] };
    assert_eq!(first_hit(&map, &ray, (2.0, 1.0)), None, "an empty range");
    assert_eq!(first_hit(&map, &ray, (f64::NAN, 1.0)), None);
    assert_eq!(first_hit(&map, &ray, (0.0, f64::NAN)), None);
}

#[test]
fn every_walk_ends() {
    let map = needle(Border::Wrap);
    let ray = Ray { origin: [0.0, 2.5, 1.0], direction: [1.0, 0.0, 0.0] };
    let path = Path::new(&map, &ray, FOREVER).unwrap();
    assert_eq!(walk(&map, &path, 1000), None, "between the needles");
    assert_eq!(shoot(&map, [0.0, 0.0, 101.0], [1e5, 1.0, 1e-9]), None, "rises above the top");
    let late = shoot(&map, [0.0, 2.5, 1e12], [1.0, 0.0, -1.0]).unwrap();
    assert_eq!(late, (1e12, [999_999_999_999, 2]), "begins where it comes below the top");
}

#[test]
fn a_shadow_needs_ground_in_between() {
    let map = needle(Border::Wrap);
    assert!(!visible(&map, [3.0, 1.0, 1.0], [-1.0, 0.0, 10.0], FOREVER));
    assert!(visible(&map, [3.0, 1.0, 1.0], [-1.0, 0.0, 10.0], (0.0, 1.0)), "what casts it is farther away");
    assert!(visible(&map, [3.0, 1.0, 1.0], [-1.0, 0.0, 60.0], FOREVER));
}
