//! What one upload or one pipeline serves, against what is made for each.

use terrane::relief::Tracer;
use terrane_shaderlib::heightfield::adversary::SIZES;
use terrane_shaderlib::relief::{Method, Placed};

use super::{LIMIT, device, lands};

#[test]
fn an_upload_and_a_pipeline_that_are_shared_change_no_answer() {
    let Some(gpu) = device() else { return };
    let mut tiled = 0;
    for (heights, sent) in lands(16, 3).take(2 * SIZES.len()) {
        let placed = Placed::new(&heights, Method::Walk.bounds(), LIMIT).expect("whole steps can be placed");
        tiled += usize::from(placed.tiled);
        let walk = Tracer::new(&gpu, &heights, &placed, Method::Walk).expect("the device takes it");
        let mipmaps = Tracer::new(&gpu, &heights, &placed, Method::MaximumMipmaps).expect("the device takes it");
        let answers = |tracer: &Tracer<'_>| tracer.trace(&sent).expect("the device answers").0;
        let shared = walk.sharing(Method::MaximumMipmaps).expect("the device takes it");
        assert_eq!(answers(&shared), answers(&mipmaps), "{:?} {:?}", heights.size(), heights.border());
        let over = shared.over(&heights, &placed).expect("the device takes it");
        assert_eq!(answers(&over), answers(&mipmaps), "{:?} {:?}", heights.size(), heights.border());
    }
    assert!(tiled > 0, "no map was traced tile by tile");
}
