//! A brick wall in running bond: the sides of the bricks are vertical, from a face to the mortar within one texel.

use super::super::color::{Paint, Rgb, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{hash, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;

/// Columns and rows of bricks: of 25 and 8.33 cm with their joints, on a tile of 2 m.
const BRICKS: [u32; 2] = [8, 24];
/// Half of a joint, in heights of a brick.
const JOINT: f32 = 0.06;

/// Which brick a place belongs to, and where in it: −1..1 along and across, and how far inside its border, in its heights.
struct Place {
    brick: u32,
    along: f32,
    across: f32,
    inside: f32,
}

/// A tile of 2 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size(), arguments.seed());
    let [ragged, rough] = [Noise::new(seed ^ 0xb1, 64, 3), Noise::new(seed ^ 0xb2, 96, 4).gain(0.7)];
    let deep = arguments.get("mortar");
    let height = Field::build(n, |u, v| {
        let place = place(u, v, seed, ragged.fbm(u, v));
        let grain = rough.fbm(u, v);
        if place.inside > 0.0 { face(&place, seed) + 0.05 * grain } else { 1.0 - deep + 0.09 * grain }
    });
    let height = height.normalised(0.001, 0.999);
    let albedo = Paint::build(n, |x, y, u, v| {
        let grain = rough.fbm(u, v);
        let color = paint(&place(u, v, seed, ragged.fbm(u, v)), seed, grain);
        scale(color, 0.45 + 0.55 * step(0.0, 0.5, height.at(x, y)))
    });
    Material { albedo: albedo.evened(n as f32 / 6.0, 0.15), height }
}

/// Every second row is shifted by half a brick. `ragged`, −1..1, moves the border a little.
fn place(u: f32, v: f32, seed: u32, ragged: f32) -> Place {
    let row = (v * BRICKS[1] as f32).min(BRICKS[1] as f32 - 0.5);
    let across = row.fract() - 0.5;
    let shifted = u * BRICKS[0] as f32 + if row as u32 & 1 == 1 { 0.5 } else { 0.0 };
    let along = shifted.fract() - 0.5;
    let brick = hash(seed, shifted as u32 % BRICKS[0], row as u32);
    // A brick is three times as long as it is high.
    let border = (0.5 - across.abs()).min(3.0 * (0.5 - along.abs()));
    Place { brick, along: 2.0 * along, across: 2.0 * across, inside: border - JOINT * (1.0 + 0.5 * ragged) }
}

/// The height of a face: each brick is laid a little deeper than others, and not quite straight.
fn face(place: &Place, seed: u32) -> f32 {
    let [sunk, along, across] = [3, 4, 5].map(|salt| unit(hash(seed, place.brick, salt)));
    0.95 - 0.13 * sunk + 0.05 * ((along - 0.5) * place.along + (across - 0.5) * place.across)
}

fn paint(place: &Place, seed: u32, grain: f32) -> Rgb {
    if place.inside <= 0.0 {
        return scale(mix(hex(0x8f887b), hex(0xaaa294), step(-0.4, 0.4, grain)), 0.9);
    }
    let burnt = unit(hash(seed, place.brick, 6));
    let clay = if burnt < 0.15 {
        hex(0x5c4038)
    } else if burnt < 0.55 {
        hex(0x8c4a38)
    } else {
        hex(0xa65c43)
    };
    let shade = 0.8 + 0.4 * unit(hash(seed, place.brick, 7));
    scale(clay, shade * (1.0 + 0.3 * grain))
}

#[cfg(test)]
mod tests {
    use terrane_codegen::graph::recipe::recipe;

    use super::*;

    #[test]
    fn walls_are_vertical() {
        let arguments = Arguments::defaults(recipe("bricks").expect("it is a recipe"), 256, 1);
        let height = make(&arguments).height;
        // Between neighbouring texels of a face there is grain; into a joint it goes down at once.
        let steps = (0..256 * 256).map(|index| {
            (height.at(index % 256, index / 256), height.wrapped(index as i32 % 256 + 1, index as i32 / 256))
        });
        let walls = steps.filter(|(a, b)| (a - b).abs() > 0.35).count();
        assert!(walls >= 2 * 8 * 256 / 2, "only {walls} places fall by more than a third of the depth in one texel");
    }
}
