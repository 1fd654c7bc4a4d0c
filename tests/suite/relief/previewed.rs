//! Relief in the picture of a surface alone.

use terrane_shaderlib::heightfield::{Border, Heights, Texels};
use terrane_shaderlib::hosts::{self, Host};
use terrane_shaderlib::relief::Method;

use super::device;
use super::plain::{Plain, SHAPE, rough};

/// A host that knows no relief.
fn flat() -> Host {
    Host { displaced: None, ..hosts::preview() }
}

/// The part of all bytes that differ by more than one of 255.
fn other(a: &[u8], b: &[u8]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).filter(|(a, b)| a.abs_diff(**b) > 1).count() as f64 / a.len() as f64
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
    assert_eq!(other(&with, &without), 0.0);
}

#[test]
fn relief_is_seen_and_shades_itself_with_any_method() {
    let Some(gpu) = device() else { return };
    let plain = Plain::new(&rough(64), SHAPE);
    let bare = plain.preview(&gpu, Method::Walk, &flat()).pixels;
    let walk = plain.preview(&gpu, Method::Walk, &hosts::preview()).pixels;
    let seen = other(&walk, &bare);
    assert!(seen > 0.15, "only {seen} of the picture is another");
    assert!(mean(&walk) < mean(&bare), "{} is no darker than {}", mean(&walk), mean(&bare));
    for method in [Method::Sprint, Method::Wide, Method::Stride] {
        let part = other(&plain.preview(&gpu, method, &hosts::preview()).pixels, &walk);
        assert!(part < 0.002, "{method}: {part} of the picture is another");
    }
}
