//! Which cones a change may have reached, asked on the device as `heightfield/cones/change` asks it: what has changed reaches a cone
//! where its highest point, before or after, is as steep from the tip as the cone is. Cones are found anew part by part: a part of
//! which no cone is reached is a square that is not drawn.

/// One over the least distance at which what has changed counts, toward the four quadrants: for columns, and behind them for rows.
@group(1) @binding(6) var build_shares: texture_2d<f32>;
/// The highest of each rectangle that has changed, and in a second row the same after the change.
@group(1) @binding(7) var build_highest_texels: texture_2d<u32>;
/// For each part whether a cone of it is reached.
@group(2) @binding(0) var build_parts: texture_2d<u32>;

/// Cells along a part.
override build_side: i32 = 32;

/// Parts before and above one whose cones read what is drawn there.
override build_before: i32 = 0;

/// Whether cones are round, and their source has the heights that count toward four quadrants.
override build_is_round: bool = false;

/// Whether a texel has the cones of four quadrants.
override build_has_quadrants: bool = false;

/// A share that says that the change is at the place itself.
const build_here: f32 = 1e9;

/// How much gentler a round cone may have come out than it is: 2^-18 by its ratio, and the roundings here.
const build_ratio_rounding: f32 = 1.0 - 1.0 / 65536.0;

/// Two triangles over a part that is reached, or none. The viewport is the level, of `behind` columns and rows.
@vertex
fn build_part_vertex(@builtin(vertex_index) index: u32, @builtin(instance_index) number: u32) -> @builtin(position) vec4f {
    let columns = (build_part.behind.x + build_side - 1i) / build_side;
    let part = vec2i(i32(number) % columns, i32(number) / columns);
    // Bits of the corners' columns and rows.
    let corner = vec2i((vec2u(0x32u, 0x2cu) >> vec2u(index)) & vec2u(1u));
    let place = vec2f(build_side * select(part, part + corner, build_is_part_reached(part))) / vec2f(build_part.behind);
    return vec4f(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y, 0.0, 1.0);
}

/// Whether a part is, or one that reads it. Behind the last part there are the same cones again.
fn build_is_part_reached(part: vec2i) -> bool {
    let last = vec2i(textureDimensions(build_parts)) - 1i;
    for (var y = max(part.y - build_before, 0i); y <= part.y; y += 1i) {
        for (var x = max(part.x - build_before, 0i); x <= part.x; x += 1i) {
            if textureLoad(build_parts, min(vec2i(x, y), last), 0i).r > 0u {
                return true;
            }
        }
    }
    return false;
}

/// The highest of some nodes, from the first to what is behind the last.
@fragment
fn build_highest_node() -> @location(0) u32 {
    var highest = vec4u(0u);
    for (var y = build_part.first.y; y < build_part.behind.y; y += 1i) {
        for (var x = build_part.first.x; x < build_part.behind.x; x += 1i) {
            highest = max(highest, textureLoad(build_source, vec2i(x, y), 0i));
        }
    }
    let round = max(max(highest.x, highest.y), max(highest.z, highest.w));
    return select(highest.x, round, build_is_round);
}

/// 1 for a part of which a cone is reached, or 0.
@fragment
fn build_reached(@builtin(position) position: vec4f) -> @location(0) u32 {
    let first = build_side * vec2i(position.xy);
    let behind = min(first + build_side, build_part.size);
    let highest = build_highest_of_all();
    for (var y = first.y; y < behind.y; y += 1i) {
        for (var x = first.x; x < behind.x; x += 1i) {
            if build_reaches(vec2i(x, y), highest) {
                return 1u;
            }
        }
    }
    return 0u;
}

fn build_highest_of_all() -> u32 {
    let size = vec2i(textureDimensions(build_highest_texels));
    var highest = 0u;
    for (var x = 0i; x < size.x; x += 1i) {
        let before = textureLoad(build_highest_texels, vec2i(x, 0i), 0i).r;
        highest = max(highest, max(before, textureLoad(build_highest_texels, vec2i(x, 1i), 0i).r));
    }
    return highest;
}

/// Whether what is so high reaches the cone of a cell or of a texel.
fn build_reaches(at: vec2i, highest: u32) -> bool {
    let shares = min(textureLoad(build_shares, vec2i(at.x, 0i), 0i), textureLoad(build_shares, vec2i(at.y, 1i), 0i));
    if shares.x >= build_here {
        return true;
    }
    let cone = textureLoad(build_source, build_part.corner + at, 0i);
    let tip = select(cone.x, (cone.x >> 24u) | ((cone.y >> 24u) << 8u), build_has_quadrants);
    if highest <= tip {
        return false;
    }
    let slopes = f32(highest - tip) * shares;
    if build_is_round {
        return slopes.x > 0.0 && build_ratio_code(build_ratio_rounding / slopes.x) <= cone.y;
    }
    let codes = vec4u(build_code(slopes.x), build_code(slopes.y), build_code(slopes.z), build_code(slopes.w));
    if build_has_quadrants {
        let stored = vec4u(cone.x, cone.x >> 12u, cone.y, cone.y >> 12u) & vec4u(0xfffu);
        return any((codes > vec4u(0u)) & (build_twelve(codes) >= stored));
    }
    return codes.x > 0u && codes.x >= cone.y;
}
