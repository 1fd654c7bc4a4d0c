use super::*;
use crate::heightfield::oracle::{Oracle, Time};
use crate::heightfield::{Border, Heights, Texels};

fn land(land: Land, seed: u64) -> Heights {
    map(land, [16, 12], Border::Wrap, Depth::Sixteen, seed).unwrap()
}

#[test]
fn the_same_seed_gives_the_same_on_every_machine() {
    let mut digest = Random::new(0);
    let mut add = |bits: i64| digest = Random::new(digest.bits() ^ bits as u64);
    for (at, kind) in LANDS.into_iter().enumerate() {
        let map = land(kind, at as u64);
        let Texels::U16(texels) = map.texels() else { panic!("16 bits were asked for") };
        texels.iter().for_each(|texel| add(i64::from(*texel)));
        let mut rays = Rays::new(&map, at as u64);
        for case in AIMS.map(|aim| rays.case(aim)) {
            case.fixed.origin.into_iter().chain(case.fixed.direction.map(i64::from)).for_each(&mut add);
            case.ray.direction.into_iter().for_each(|rate| add(rate.to_bits() as i64));
        }
    }
    assert_eq!(digest.bits(), 3_377_745_238_304_788_688);
}

#[test]
fn both_forms_are_the_same_ray() {
    for (kind, border) in LANDS.into_iter().flat_map(|land| [(land, Border::Wrap), (land, Border::Clamp)]) {
        let map = map(kind, [7, 5], border, Depth::Eight, 3).unwrap();
        let mut rays = Rays::new(&map, 5);
        for aim in AIMS.into_iter().flat_map(|aim| [aim; 50]) {
            let case = rays.case(aim);
            assert_eq!(case.ray.origin, case.fixed.origin.map(|at| at as f64 / 256.0));
            for (rate, fixed) in case.ray.direction.into_iter().zip(case.fixed.direction) {
                assert!((rate - f64::from(fixed) / 256.0).abs() < 1e-199, "{aim:?}: {case:?}");
            }
            Oracle::new(&map, case.fixed, Time::new(case.end, 1).unwrap()).unwrap();
        }
    }
}

#[test]
fn saddles_are_touched_exactly() {
    let map = land(Land::Checkerboard, 1);
    let mut rays = Rays::new(&map, 1);
    let touched = (0..100).filter(|_| {
        let case = rays.case(Aim::Saddles);
        let oracle = Oracle::new(&map, case.fixed, Time::new(case.end, 1).unwrap()).unwrap();
        // Level rays touch every saddle of a row; those that begin in the ground do not count.
        oracle.first_cell().is_some() && oracle.lifted(1).first_cell().is_none()
    });
    assert!(touched.count() > 30);
}

#[test]
fn walls_stand_where_nodes_meet() {
    for seed in 0..20 {
        let map = land(Land::Walls, seed);
        assert!([0, 15].into_iter().any(|x| (0..12).all(|y| map.height(x, y) == 65535.0)), "{seed}: at the seam");
    }
}
