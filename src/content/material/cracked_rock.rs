//! Granite as it stands in a cliff: broken along joints into blocks, their faces chipped, grained and overgrown.

use super::super::cells::Cells;
use super::super::color::{Paint, Rgb, hex, mix, scale, step};
use super::super::field::Field;
use super::super::hash::{mix as scramble, unit};
use super::super::map::Material;
use super::super::noise::Noise;
use super::super::recipe::Arguments;

/// Blocks, cracks and grain of one tile.
struct Rock {
    /// What is left of the blocks, 0..1.
    height: Field,
    /// 1 in the middle of a crack.
    crack: Field,
}

/// A tile of about 4 m.
pub fn make(arguments: &Arguments) -> Material {
    let (n, seed) = (arguments.size(), arguments.seed());
    let rock = shape(n, seed, arguments.get("cracks"));
    let sky = rock.height.sky(n as f32 * 0.08, n as f32 * 0.05);
    let albedo = paint(&rock, &sky, seed, arguments.get("lichen")).evened(n as f32 / 7.0, 0.25);
    Material { height: rock.height, albedo }
}

fn shape(n: usize, seed: u32, cracks: f32) -> Rock {
    let warp = Noise::new(seed ^ 0x11, 6, 6).gain(0.55);
    let (du, dv) = (Field::build(n, |u, v| warp.fbm(u, v)), Field::build(n, |u, v| warp.fbm(v + 0.37, u + 0.11)));
    let warped = |x: usize, y: usize, amount: f32| {
        let (u, v) = ((x as f32 + 0.5) / n as f32, (y as f32 + 0.5) / n as f32);
        (u + amount * du.at(x, y), v + amount * dv.at(x, y))
    };
    let crack = Field::texels(n, |x, y| {
        let (u, v) = warped(x, y, 0.03);
        crack(seed, cracks, u, v)
    });
    let shatter = Noise::new(seed ^ 0x22, 5, 4);
    let grain = Noise::new(seed ^ 0x21, 20, 6).gain(0.66);
    let blocks = Field::texels(n, |x, y| {
        let (u, v) = warped(x, y, 0.03);
        let broken = step(-0.25, 0.45, shatter.fbm(u, v));
        let coarse = block(seed ^ 1, (4, 5), u, v) + 0.5 * block(seed ^ 2, (9, 12), u, v);
        let fine = 0.27 * block(seed ^ 3, (23, 27), u, v) + 0.13 * block(seed ^ 4, (53, 57), u, v);
        let (u, v) = warped(x, y, 0.012);
        let faces =
            0.8 * facet(seed ^ 5, 7, u, v) + 0.35 * facet(seed ^ 6, 17, u, v) + 0.16 * facet(seed ^ 7, 39, u, v);
        coarse + fine * (0.2 + 0.8 * broken) + faces + 0.16 * grain.fbm(u, v)
    });
    let height = blocks.evened(n as f32 / 6.0, 0.3).zip(&crack, |h, c| h - 0.5 * c);
    Rock { height: height.normalised(0.0005, 0.9995), crack }
}

/// Blocks that have moved against each other: tilted planes with chipped edges.
fn block(seed: u32, count: (u32, u32), u: f32, v: f32) -> f32 {
    let near = Cells::new(seed, 1).stretched(count.0, count.1).near(u, v);
    let r = |salt: u32| unit(scramble(near.id ^ salt)) - 0.5;
    let plane = 0.75 * r(1) + 0.7 * (r(2) * near.offset.0 + r(3) * near.offset.1);
    plane - 0.22 * (1.0 - step(0.0, 0.05 + 0.12 * (r(4) + 0.5), near.border))
}

/// Faces of broken stone: the highest of many tilted wedges.
fn facet(seed: u32, cells: u32, u: f32, v: f32) -> f32 {
    let mut top = f32::MIN;
    Cells::new(seed, cells).visit(u, v, |id, dx, dy| {
        let r = |salt: u32| unit(scramble(id ^ salt));
        let (ax, ay) = (r(1) * 2.0 - 1.0, r(2) * 2.0 - 1.0);
        let length = (ax * ax + ay * ay).sqrt().max(0.05);
        let (cx, cy) = (ax / length, ay / length);
        let (rx, ry) = (cx * dx + cy * dy, cx * dy - cy * dx);
        let tilt = 0.45 * (r(3) - 0.5) * rx + 0.45 * (r(4) - 0.5) * ry;
        let edge = (rx.abs() * (0.55 + 0.5 * r(5))).max(ry.abs() * (0.55 + 0.5 * r(6))).max((rx + ry).abs() * 0.5);
        top = top.max(0.55 * r(7) + tilt - edge);
    });
    top
}

/// Joints that gape: 1 where a crack is deepest.
fn crack(seed: u32, open: f32, u: f32, v: f32) -> f32 {
    let gape = Noise::new(seed ^ 0x31, 4, 4);
    let width = (gape.fbm(u, v) + 1.2 * open - 0.65).clamp(0.0, 1.0);
    // The same joints as those of `block`, or cracks would run across sound stone.
    let long = Cells::new(seed ^ 1, 1).stretched(4, 5).near(u, v).border;
    let short = Cells::new(seed ^ 2, 1).stretched(9, 12).near(u, v).border;
    let deep = (1.0 - step(0.0, 0.004 + 0.05 * width, long)) * step(0.0, 0.2, width);
    let fine = (1.0 - step(0.0, 0.03 + 0.04 * width, short)) * step(0.2, 0.6, gape.fbm(v + 0.3, u) + open - 0.3);
    deep.max(0.7 * fine)
}

fn paint(rock: &Rock, sky: &Field, seed: u32, lichen: f32) -> Paint {
    let n = rock.height.size;
    let edge = rock.height.above(n as f32 / 200.0);
    let (broad, mid) = (Noise::new(seed ^ 0x51, 4, 5), Noise::new(seed ^ 0x52, 16, 5).gain(0.6));
    let growth = Noise::new(seed ^ 0x53, 7, 6).gain(0.6);
    Paint::build(n, |x, y, u, v| {
        let (b, m) = (broad.fbm(u, v), mid.fbm(u, v));
        let mut color = mix(hex(0x8a8682), hex(0x9c9287), step(-0.4, 0.5, b));
        color = mix(color, hex(0x7d766c), step(0.05, 0.6, m));
        color = crystals(seed, color, u, v);
        color = mix(color, hex(0x7a6248), 0.5 * step(0.15, 0.6, b * 0.6 + m * 0.6 + 0.4 * rock.crack.at(x, y)));
        color = scale(color, 1.0 + (edge.at(x, y) * 6.0).clamp(-0.25, 0.25));
        let patch = step(0.34, 0.55, growth.fbm(u, v) + 0.35 * m + 0.7 * (lichen - 0.5) + 0.3 * (sky.at(x, y) - 0.7));
        color = mix(color, lichen_color(seed, u, v), 0.75 * patch);
        scale(color, (0.35 + 0.65 * step(0.25, 0.95, sky.at(x, y))) * (1.0 - 0.45 * rock.crack.at(x, y)))
    })
}

/// Feldspar, quartz and mica.
fn crystals(seed: u32, color: Rgb, u: f32, v: f32) -> Rgb {
    let grain = Cells::new(seed ^ 0x61, 260).near(u, v);
    match grain.id >> 24 {
        0..=34 => mix(color, hex(0x3d3b3a), 0.5),
        35..=110 => mix(color, hex(0xb9a897), 0.35),
        111..=170 => mix(color, hex(0xc9c9c6), 0.3),
        _ => color,
    }
}

fn lichen_color(seed: u32, u: f32, v: f32) -> Rgb {
    let spot = Cells::new(seed ^ 0x71, 26).near(u, v);
    let base = match spot.id >> 30 {
        0 => hex(0x8c8f5c),
        1 => hex(0xa7a893),
        2 => hex(0x6b6a52),
        _ => hex(0x96927c),
    };
    scale(base, 0.85 + 0.3 * unit(scramble(Cells::new(seed ^ 0x72, 230).near(u, v).id)))
}
