//! The figures of shadow and occlusion in docs/relief/notebook.md.

use terrane::content;
use terrane::content::recipe::{Arguments, maker};
use terrane::measure::{MAPS, Subject};
use terrane::relief::{Lighter, Lighting, Turn};
use terrane::render::Gpu;
use terrane_codegen::graph::recipe::recipe;
use terrane_shaderlib::heightfield::visibility::Sun;
use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::relief::Placed;

use super::device;
use super::lighting::{Place, differences, rmse};

/// Texels a side.
const SIDE: u32 = 1024;

/// Land that does not tile.
fn mountains() -> Option<Subject> {
    let arguments = Arguments::defaults(recipe("mountains")?, SIDE, 1);
    let content::map::Texels::Grey16(texels) = (maker("mountains").make)(&arguments).swap_remove(0).texels else {
        return None;
    };
    let heights = Heights::new([SIDE; 2], Border::Clamp, Texels::U16(texels)).ok()?;
    Some(Subject { name: "mountains".into(), heights, full: 65535.0 })
}

fn shadows() -> Vec<Lighting> {
    // The last as graphs have it.
    let cones =
        [(1, 0.0), (1, 32.0), (3, 0.0), (7, 0.0), (7, 1.0)].map(|(planes, coarse)| Lighting::Cone(planes, coarse));
    let others = [
        Lighting::ParallaxPublished,
        Lighting::Parallax(16),
        Lighting::Parallax(64),
        Lighting::Published,
        Lighting::FastHorizon(8),
    ];
    [Lighting::Hard, Lighting::HardWide].into_iter().chain(cones).chain(others).collect()
}

fn skies() -> Vec<Lighting> {
    let exact = [(4, Turn::Fixed), (4, Turn::Jittered), (8, Turn::Fixed)];
    let fast = exact.map(|(count, turn)| Lighting::FastSky(count, turn, 8));
    let searched = [0.0, 0.015625, 0.03125, 0.0625, 0.125]
        .into_iter()
        .flat_map(|tolerance| exact.map(|(count, turn)| Lighting::Sky(count, turn, tolerance)));
    searched.chain(fast).collect()
}

/// One line for each method: loads, time over that of the first, errors.
fn print(gpu: &Gpu, place: &Place<'_>, points: &[[f64; 2]], truth: &[f64], methods: &[Lighting]) {
    let mut base = None;
    for method in methods {
        let bounds = method.bounds();
        let placed = Placed::new(place.heights, bounds, 1 << 16).expect("a map that can be placed");
        let lighter = Lighter::new(gpu, place.heights, &placed, *method, place.scene).expect("the device takes it");
        let rounds: Vec<_> = (0..6).map(|_| lighter.see(points).expect("the device answers")).collect();
        let time = rounds[1..].iter().map(|round| round.1).min().expect("five rounds").as_secs_f64();
        let seen = &rounds[0].0;
        let mean = |part: fn(&terrane::relief::Seen) -> u32| {
            seen.iter().map(|one| f64::from(part(one))).sum::<f64>() / seen.len() as f64
        };
        let off = differences(seen, truth);
        println!(
            "  {method:?}: nodes or samples {:.1}, patches {:.1}, time {:.2}, rmse {:.4}, bias {:+.4}",
            mean(|one| one.steps),
            mean(|one| one.leaves),
            time / *base.get_or_insert(time),
            rmse(&off),
            off.iter().sum::<f64>() / off.len() as f64,
        );
    }
}

/// The maps of materials, and land.
fn maps() -> impl Iterator<Item = Subject> {
    let named = |subject: &Subject| ["cracked_rock", "pebbles", "hills", "cracks", "needles"].contains(&&*subject.name);
    MAPS.iter().map(|map| map.make(SIDE)).filter(named).chain(mountains())
}

#[test]
#[ignore = "takes minutes: `cargo test --test suite relief::figures -- --ignored --nocapture` prints a table"]
fn shadow() {
    let Some(gpu) = device() else { return };
    for subject in maps() {
        for elevation in [45.0, 30.0, 15.0] {
            let place = Place::new(&subject, Sun::new(34.0, elevation, 0.27));
            let points = place.facing(64);
            let truth = place.sun_shares(&points, 16);
            println!("{} under a sun at {elevation}°: {} points", subject.name, points.len());
            print(&gpu, &place, &points, &truth, &shadows());
        }
    }
}

#[test]
#[ignore = "takes minutes: `cargo test --test suite relief::figures -- --ignored --nocapture` prints a table"]
fn occlusion() {
    let Some(gpu) = device() else { return };
    for subject in maps() {
        let place = Place::new(&subject, Sun::new(34.0, 89.0, 0.27));
        let points = place.facing(24);
        println!("{} under the sky: {} points", subject.name, points.len());
        print(&gpu, &place, &points, &place.sky_shares(&points, 64), &skies());
    }
}
