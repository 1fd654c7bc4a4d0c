use super::*;
use crate::heightfield::{Border, Texels};

fn needle(border: Border) -> Heights {
    let mut texels = vec![0; 16];
    texels[5] = 100;
    Heights::new([4, 4], border, Texels::U8(texels)).unwrap()
}

fn time(p: i64, q: i64) -> Time {
    Time::new(p, q).unwrap()
}

/// With coordinates in texels and steps, where whole ones do.
fn oracle(map: &Heights, origin: [i64; 3], direction: [i32; 3], end: i64) -> Oracle<'_> {
    let ray = FixedRay { origin: origin.map(|at| at * 256), direction: direction.map(|rate| rate * 256) };
    Oracle::new(map, ray, time(end, 1)).unwrap()
}

#[test]
fn knows_when_a_ray_reaches_the_needle() {
    let map = needle(Border::Wrap);
    let ray = oracle(&map, [0, 1, 50], [1, 0, 0], 9);
    assert_eq!(ray.first_cell(), Some([0, 1]));
    assert!(ray.crosses_before(time(1, 2)) && !ray.crosses_before(time((1 << 39) - 1, 1 << 40)));
    assert_eq!(ray.sign_at(time(1, 2)), Some(Ordering::Equal));
    assert_eq!(ray.sign_at(time(1, 1)), Some(Ordering::Less));
    assert_eq!(ray.sign_at(time(2, 1)), Some(Ordering::Greater));
    assert_eq!(oracle(&map, [2, 1, 50], [-1, 0, 0], 9).first_cell(), Some([1, 1]));
    assert_eq!(oracle(&map, [-4_000_002, 1, 50], [1, 0, 0], 9).first_cell(), Some([-4_000_000, 1]));
}

#[test]
fn the_tip_is_touched_at_its_very_height() {
    let map = needle(Border::Wrap);
    let ray = oracle(&map, [0, 0, 100], [1, 1, 0], 9);
    assert_eq!(ray.first_cell(), Some([0, 0]), "in the cell that it comes from");
    assert!(ray.crosses_before(time(1, 1)) && !ray.crosses_before(time(999, 1000)));
    assert_eq!((ray.lifted(1).first_cell(), ray.lifted(-1).first_cell()), (None, Some([0, 0])));
}

#[test]
fn a_saddle_is_touched_at_its_very_height() {
    let map = needle(Border::Clamp);
    let ray = oracle(&map, [0, 1, 25], [1, -1, 0], 9);
    assert_eq!((ray.first_cell(), ray.lifted(1).first_cell()), (Some([0, 0]), None));
    assert!(ray.crosses_before(time(1, 2)) && !ray.crosses_before(time(499, 1000)));
    assert_eq!(ray.sign_at(time(1, 2)), Some(Ordering::Equal));
    assert_eq!(ray.sign_at(time(2, 1)), None, "beside the map");
}

#[test]
fn a_clamped_map_ends() {
    let map = needle(Border::Clamp);
    let side = oracle(&map, [-5, 2, -1], [1, 0, 0], 99);
    assert_eq!(
        (side.first_cell(), side.sign_at(time(4, 1)), side.sign_at(time(5, 1))),
        (Some([0, 2]), None, Some(Ordering::Less))
    );
    assert_eq!(oracle(&map, [8, 3, -1], [-1, 0, 0], 99).first_cell(), Some([2, 2]));
    assert_eq!(oracle(&map, [3, 3, 7], [0, 0, -1], 99).first_cell(), Some([2, 2]), "the last corner, straight down");
    assert_eq!(oracle(&map, [4, 3, 7], [0, 0, -1], 99).first_cell(), None);
    assert_eq!(oracle(&map, [-5, 2, 1], [-1, 0, 0], 99).first_cell(), None, "away from it");
    assert_eq!(oracle(&map, [-1, 4, -1], [1, -1, 0], 99).first_cell(), Some([0, 2]));
    assert_eq!(oracle(&map, [-1, 0, -1], [1, -1, 0], 99).first_cell(), None, "past its corner");
    assert_eq!(oracle(&map, [-1, 1, -1], [1, -1, 0], 99).first_cell(), Some([0, 0]), "through its corner");
}

#[test]
fn a_single_texel_is_a_point_or_the_whole_plane() {
    let map = |border| Heights::new([1, 1], border, Texels::U16(vec![9])).unwrap();
    let (point, plane) = (map(Border::Clamp), map(Border::Wrap));
    assert_eq!(oracle(&point, [-1, -2, 9], [1, 2, 0], 9).first_cell(), Some([0, 0]));
    assert_eq!(oracle(&point, [-1, -2, 9], [1, 1, 0], 9).first_cell(), None);
    assert_eq!(oracle(&point, [0, 0, 10], [0, 0, -1], 9).first_cell(), Some([0, 0]));
    assert_eq!(oracle(&plane, [-1, -2, 10], [2, 0, -1], 9).first_cell(), Some([0, -2]));
}

#[test]
fn what_does_not_fit_is_refused() {
    let (wrapped, clamped) = (needle(Border::Wrap), needle(Border::Clamp));
    let error = |map: &Heights, origin, direction| Oracle::new(map, FixedRay { origin, direction }, time(8, 1)).err();
    assert_eq!(error(&wrapped, [0; 3], [0, -(1 << 24) - 1, 0]), Some(OracleError::Direction(-(1 << 24) - 1)));
    assert_eq!(error(&wrapped, [0, 0, i64::MIN], [0; 3]), Some(OracleError::Height(i64::MIN)));
    assert_eq!(error(&wrapped, [0; 3], [(1 << 22) + 1, 0, 0]), Some(OracleError::Far));
    assert_eq!(error(&wrapped, [i64::MAX, i64::MIN, 0], [-(1 << 22), 1 << 22, 0]), None);
    assert_eq!(error(&clamped, [i64::MIN, 0, 0], [1, 1, 0]), Some(OracleError::Far));
    let floats = Heights::new([1, 1], Border::Wrap, Texels::F32(vec![0.0])).unwrap();
    assert_eq!(error(&floats, [0; 3], [0; 3]), Some(OracleError::NotWhole));
}
