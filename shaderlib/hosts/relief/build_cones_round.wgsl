//! Round cones, made on the device: from every texel the steepest way up to one that counts, looked for in a quadtree of maxima,
//! the nearest nodes first and without a stack, as what comes next follows from a node and the tip alone. A node that cannot be
//! steeper than what is known stays closed.
//!
//! Steepness is compared as climb² / distance². Of both f32 holds the whole numbers or is 2^-24 off, a quotient is 2.5 units in
//! the last place off: 2^-21 at most together. Its inverse root is 2^-22 off by the first and 2^-22 by itself, so a ratio that is
//! made 2^-19 smaller is no larger than the true one, and no more than 2^-18 smaller: steps of a code are 2^-12 at least.

/// The levels of the quadtree, for each quadrant of directions its own maxima.
@group(1) @binding(4) var build_quadtree: texture_2d<u32>;
/// What is known so far: the bits of the steepness, and where the search goes on. At first zeros.
@group(1) @binding(5) var build_known: texture_2d<u32>;

/// Whether texels count toward a quadrant alone from which the ground falls that way.
override build_is_relaxed: bool = false;

/// Nodes that one pass goes through at most: some drivers leave a shader's loops after 65535 rounds.
override build_rounds: i32 = 32768;

/// The bits of the ratio whose code is 0.
override build_narrowest: u32 = 0u;

/// Where a search is: at a node that is still to be looked at, or on its way to the next one.
struct BuildVisit {
    node: vec2i,
    level: u32,
    is_onward: bool,
    is_done: bool,
}

/// The heights of a texel toward the four quadrants, 0 where it does not count.
@fragment
fn build_counting(@builtin(position) position: vec4f) -> @location(0) vec4u {
    let at = vec2i(position.xy);
    let height = vec4u(build_texel(at));
    if !build_is_relaxed {
        return height;
    }
    let falls = vec4<bool>(
        build_falls(at, vec2i(1, 1)),
        build_falls(at, vec2i(-1, 1)),
        build_falls(at, vec2i(1, -1)),
        build_falls(at, vec2i(-1, -1)),
    );
    return select(vec4u(0u), height, falls);
}

/// Whether the ground falls along an edge of the cell that begins at a texel. Along a border there is still an edge, if no cell.
fn build_falls(near: vec2i, way: vec2i) -> bool {
    let size = build_part.size;
    let far = select(clamp(near + way, vec2i(0), size - 1i), (near + way + size) % size, vec2<bool>(build_wraps));
    let a = build_texel(near);
    let b = build_texel(vec2i(far.x, near.y));
    let c = build_texel(vec2i(near.x, far.y));
    let d = build_texel(far);
    return a > b || a > c || b > d || c > d;
}

/// The largest of each node's children, or of what there is of them at the border, toward each quadrant.
@fragment
fn build_counting_nodes(@builtin(position) position: vec4f) -> @location(0) vec4u {
    let near = 2i * build_place(position);
    let far = min(near + 1i, build_part.size - 1i);
    let above = max(textureLoad(build_source, near, 0i), textureLoad(build_source, vec2i(far.x, near.y), 0i));
    return max(above, max(textureLoad(build_source, vec2i(near.x, far.y), 0i), textureLoad(build_source, far, 0i)));
}

/// What is known of a texel's cone after some more nodes.
@fragment
fn build_searched(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let tip = vec2i(position.xy);
    let height = build_texel(tip);
    let known = textureLoad(build_known, tip, 0i);
    var steepest = bitcast<f32>(known.r);
    var visit = build_visit_of(known.g);
    var rounds = 0i;
    while rounds < build_rounds && !visit.is_done {
        var found = 0.0;
        if !visit.is_onward {
            found = build_steepness(tip, height, visit.node, visit.level);
        }
        let opens = visit.level > 0u && found > steepest;
        steepest = select(max(steepest, found), steepest, visit.level > 0u);
        if opens {
            visit = build_first(visit, tip);
        } else {
            visit = build_next(visit, tip);
        }
        rounds += 1i;
    }
    return vec2u(bitcast<u32>(steepest), build_word_of(visit));
}

/// The most that a texel under a node may be steep, of a leaf what it is: climb² / distance².
fn build_steepness(tip: vec2i, height: u32, node: vec2i, level: u32) -> f32 {
    let near = node << vec2u(level);
    let far = min(near + (1i << level), build_part.size) - 1i;
    let ahead = build_away(near - tip, tip - far, build_part.size);
    let behind = build_away(tip - far, near - tip, build_part.size);
    let x = vec4i(ahead.x, behind.x, ahead.x, behind.x);
    let y = vec4i(ahead.y, ahead.y, behind.y, behind.y);
    let there = (x >= vec4i(0)) & (y >= vec4i(0));
    let climbs = max(textureLoad(build_quadtree, node, i32(level)), vec4u(height)) - vec4u(height);
    let climb = select(vec4f(0.0), vec4f(climbs), there);
    // Under the tip's own node nothing that climbs is nearer than a texel.
    return build_largest(climb * climb / vec4f(max(x * x + y * y, vec4i(1))));
}

/// How many texels a node is away on each axis, seen one way: `before` is how far it begins that way, `after` how far it ends the
/// other way. Of a map that wraps it is the next tile's, of another it is not there: below 0.
fn build_away(before: vec2i, after: vec2i, size: vec2i) -> vec2i {
    let round = select(vec2i(-1), before + size, vec2<bool>(build_wraps));
    return select(max(before, vec2i(0)), round, after > vec2i(0));
}

/// Which child of a node's parent is the nearest to the tip, on each axis.
fn build_flip(node: vec2i, level: u32, tip: vec2i) -> vec2i {
    return select(vec2i(0), vec2i(1), (tip >> vec2u(level)) >= (node | vec2i(1)));
}

/// The nearest child.
fn build_first(visit: BuildVisit, tip: vec2i) -> BuildVisit {
    let level = visit.level - 1u;
    let node = 2i * visit.node;
    return BuildVisit(node + build_flip(node, level, tip), level, false, false);
}

/// Its next sibling or, after the last, the parent's next.
fn build_next(visit: BuildVisit, tip: vec2i) -> BuildVisit {
    let level = visit.level;
    if level + 1u >= textureNumLevels(build_quadtree) {
        return BuildVisit(visit.node, level, false, true);
    }
    let rank = (visit.node & vec2i(1)) ^ build_flip(visit.node, level, tip);
    if all(rank == vec2i(1)) {
        return BuildVisit(visit.node >> vec2u(1u), level + 1u, true, false);
    }
    let node = visit.node ^ vec2i(1, rank.x);
    let is_beyond = any((node << vec2u(level)) >= build_part.size);
    return BuildVisit(node, level, is_beyond, false);
}

/// A visit in a word: node, levels below the root, and the two flags. That of the root is 0.
fn build_word_of(visit: BuildVisit) -> u32 {
    let down = textureNumLevels(build_quadtree) - 1u - visit.level;
    let flags = select(0u, 1u, visit.is_onward) | select(0u, 2u, visit.is_done);
    return u32(visit.node.x) | (u32(visit.node.y) << 13u) | (down << 26u) | (flags << 30u);
}

fn build_visit_of(word: u32) -> BuildVisit {
    let node = vec2i(vec2u(word, word >> 13u) & vec2u(0x1fffu));
    let level = textureNumLevels(build_quadtree) - 1u - ((word >> 26u) & 15u);
    return BuildVisit(node, level, (word & 0x40000000u) != 0u, (word & 0x80000000u) != 0u);
}

/// The height of each cone's tip, and the code of its ratio, rounded down; of one without end the last.
@fragment
fn build_round_cone(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let at = build_cell(position);
    let steepest = bitcast<f32>(textureLoad(build_known, at, 0i).r);
    if steepest == 0.0 {
        return vec2u(build_texel(at), 0xffffu);
    }
    return vec2u(build_texel(at), build_ratio_code(inverseSqrt(steepest) * (1.0 - 1.0 / 524288.0)));
}

/// The largest code whose ratio is not above one.
fn build_ratio_code(ratio: f32) -> u32 {
    let bits = max(bitcast<u32>(ratio), build_narrowest) - build_narrowest;
    return min(bits >> 12u, 0xffffu);
}
