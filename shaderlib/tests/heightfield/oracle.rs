use std::cmp::Ordering;
use std::collections::BTreeMap;

use terrane_shaderlib::heightfield::Hit;
use terrane_shaderlib::heightfield::oracle::{Oracle, Time};

use super::cases::{each, each_large};
use super::judge::{Verdict, judge};

const RAYS_PER_AIM: usize = 100;

#[test]
fn the_reference_agrees_with_the_oracle_on_everything_adversarial() {
    let (mut counts, mut wrong) = (BTreeMap::<String, [usize; 3]>::new(), Vec::new());
    each(RAYS_PER_AIM, |map, aim, case, hit| {
        let touch = match judge(map, &case, hit) {
            Ok(verdict) => verdict == Verdict::Touch,
            Err(why) => {
                let (size, border) = (map.size(), map.border());
                wrong.push(format!("{size:?} {border:?}, {aim:?}: {case:?}: {hit:?}; {why}"));
                false
            }
        };
        let count = counts.entry(format!("{aim:?}")).or_default();
        [1, usize::from(hit.is_some()), usize::from(touch)].into_iter().zip(count).for_each(|(one, sum)| *sum += one);
    });
    println!("rays, hits, touches: {counts:?}");
    assert!(wrong.is_empty(), "{} are wrong: {:#?}", wrong.len(), &wrong[..wrong.len().min(3)]);
    for (aim, [rays, hits, touches]) in counts {
        // Neither test may become empty: rays must hit, and what counts as a touch must be rare but where it is aimed at.
        let often = if aim == "Saddles" { rays / 4 } else { rays / 40 };
        assert!(
            rays >= 20_000 && hits * 2 > rays && touches <= often,
            "{aim}: {rays} rays, {hits} hits, {touches} touches"
        );
    }
}

#[test]
fn thousands_of_cells_add_no_error() {
    let mut farthest = 0;
    each_large(25, |map, aim, case, hit| {
        let verdict = judge(map, &case, hit);
        assert!(verdict.is_ok(), "{:?} {:?}, {aim:?}: {case:?}: {hit:?}; {verdict:?}", map.size(), map.border());
        let way = |hit: Hit| (0..2).map(|axis| (hit.cell[axis] - (case.fixed.origin[axis] >> 8)).abs()).max();
        farthest = farthest.max(hit.and_then(way).unwrap_or(0));
    });
    assert!(farthest > 500, "{farthest} cells");
}

#[test]
fn the_oracle_agrees_with_the_definition_of_the_surface() {
    let mut signs = 0;
    each(2, |map, aim, case, hit| {
        let oracle = Oracle::new(map, case.fixed, Time::new(case.end, 1).unwrap()).unwrap();
        for (p, q) in (0..24).map(|at| (case.end * at, 24)) {
            let [x, y, z] = case.ray.at(p as f64 / q as f64);
            let sign = oracle.sign_at(Time::new(p, q).unwrap());
            let above = z - map.surface(x, y);
            // A million tiles away a position has 20 bits less.
            if let Some(sign) = sign.filter(|_| above.abs() > if x.abs() + y.abs() > 1e6 { 1.0 } else { 1e-6 }) {
                assert_eq!(sign, above.total_cmp(&0.0), "{aim:?} {case:?} at {p}/{q}");
                let before = hit.is_none_or(|hit| (p as f64 / q as f64) < hit.t * (1.0 - 1e-6));
                assert!(!before || sign == Ordering::Greater, "{aim:?} {case:?}: in the ground before {hit:?}");
                signs += 1;
            }
        }
    });
    assert!(signs > 50_000, "{signs} signs");
}
