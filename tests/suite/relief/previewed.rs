//! Relief in the picture of a surface alone.

use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::hosts::{self, Host};
use terrane_shaderlib::relief::Method;

use super::device;
use super::plain::{Plain, SHAPE, Shape, other, rough};

/// A host that knows no relief.
fn flat() -> Host {
    Host { displaced: None, ..hosts::preview() }
}

fn mean(bytes: &[u8]) -> f64 {
    bytes.iter().map(|byte| f64::from(*byte)).sum::<f64>() / bytes.len() as f64
}

#[test]
fn relief_at_the_height_of_the_ground_changes_nothing() {
    let Some(gpu) = device() else { return };
    let full = Heights::new([16; 2], Border::Wrap, Texels::U16(vec![u16::MAX; 256])).expect("a map");
    let plain = Plain::new(&full, SHAPE);
    let [with, without] = [hosts::preview(), flat()].map(|host| plain.preview(&gpu, Method::Walk, &host).pixels);
    assert_eq!(other(&with, &without, 1), 0.0);
}

#[test]
fn a_surface_that_says_no_normal_is_shaded_by_its_relief() {
    let Some(gpu) = device() else { return };
    let drawn = |normal: Option<&'static str>| {
        let plain = Plain::new(&rough(64), Shape { normal, ..SHAPE });
        plain.preview(&gpu, Method::Walk, &hosts::preview()).pixels
    };
    let own = drawn(None);
    let flat = other(&own, &drawn(Some("normal_map(texel: (0.5, 0.5, 1.0, 1.0))")), 1);
    assert!(flat > 0.12, "only {flat} of the picture is shaded otherwise than flat ground");
    // Where coordinates are those of the plane, the slope along them says the same; the ball's are not.
    let stated = drawn(Some("normal_from_height(of: relief, uv: uv, depth: 0.25, tile: 2.0)"));
    let square = |bytes: &[u8]| bytes.chunks(3 * 192).flat_map(|row| row[..3 * 90].to_vec()).collect::<Vec<u8>>();
    let part = other(&square(&own), &square(&stated), 1);
    assert!(part < 0.001, "{part} of the square is shaded otherwise than with the node");
}

#[test]
fn relief_is_seen_and_shades_itself_with_any_method() {
    let Some(gpu) = device() else { return };
    let plain = Plain::new(&rough(64), SHAPE);
    let bare = plain.preview(&gpu, Method::Walk, &flat()).pixels;
    let walk = plain.preview(&gpu, Method::Walk, &hosts::preview()).pixels;
    let seen = other(&walk, &bare, 1);
    assert!(seen > 0.15, "only {seen} of the picture is another");
    assert!(mean(&walk) < mean(&bare), "{} is no darker than {}", mean(&walk), mean(&bare));
    for method in [Method::Sprint, Method::Wide, Method::Leap, Method::StrideQuadrants] {
        let part = other(&plain.preview(&gpu, method, &hosts::preview()).pixels, &walk, 1);
        assert!(part < 0.002, "{method}: {part} of the picture is another");
    }
}
