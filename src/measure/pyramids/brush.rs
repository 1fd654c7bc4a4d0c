//! A change of a map as an editor's brush makes it.

use terrane_shaderlib::heightfield::{Heights, Texels};
use terrane_shaderlib::relief::Region;

/// Texels across a stroke.
const ACROSS: u32 = 32;

/// A map without a stroke and with one, and the texels that differ.
pub(super) struct Stroke {
    pub(super) maps: [Heights; 2],
    pub(super) texels: Region,
}

impl Stroke {
    /// A round heap in the middle, a 32nd of all that the kind of texels can hold high, of a map of floats a 32nd of what it spans.
    pub(super) fn new(heights: &Heights) -> Self {
        let size = heights.size();
        let texels = size.map(|side| side.saturating_sub(ACROSS) / 2..side.div_ceil(2) + side.min(ACROSS) / 2);
        let raised = match heights.texels() {
            Texels::U8(values) => {
                Texels::U8(heaped(values, size, |value, share| value.saturating_add((8.0 * share) as u8)))
            }
            Texels::U16(values) => {
                Texels::U16(heaped(values, size, |value, share| value.saturating_add((2048.0 * share) as u16)))
            }
            Texels::F32(values) => {
                let (low, high) =
                    values.iter().fold((f32::MAX, f32::MIN), |(low, high), at| (low.min(*at), high.max(*at)));
                Texels::F32(heaped(values, size, |value, share| value + (high - low) / 32.0 * share))
            }
        };
        let raised = Heights::new(size, heights.border(), raised).expect("as many texels as before");
        Self { maps: [heights.clone(), raised], texels }
    }
}

/// The texels with what a heap does to each: its share is 1 in the middle and falls to 0.
fn heaped<T: Copy>(values: &[T], [width, height]: [u32; 2], raise: impl Fn(T, f32) -> T) -> Vec<T> {
    let away = |at: usize, side: u32| (at as f32 + 0.5 - side as f32 / 2.0) / (ACROSS as f32 / 2.0);
    let share = |at: usize| {
        let [x, y] = [away(at % width as usize, width), away(at / width as usize, height)];
        (1.0 - x * x - y * y).max(0.0)
    };
    values.iter().enumerate().map(|(at, value)| raise(*value, share(at))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use terrane_shaderlib::heightfield::Border;

    #[test]
    fn only_the_texels_of_the_stroke_differ() {
        for size in [[1, 1], [31, 33], [64, 100]] {
            let texels = Texels::U16(vec![9; (size[0] * size[1]) as usize]);
            let Stroke { maps: [before, after], texels } =
                Stroke::new(&Heights::new(size, Border::Wrap, texels).unwrap());
            for (x, y) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))) {
                let [old, new] = [&before, &after].map(|map| map.height(x.into(), y.into()));
                assert!(old == new || texels[0].contains(&x) && texels[1].contains(&y), "{size:?} {x} {y}");
            }
            assert!(after.highest() > 2000.0, "{size:?}");
        }
    }
}
