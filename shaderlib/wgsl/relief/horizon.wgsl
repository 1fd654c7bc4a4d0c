//! How high the land stands in one direction: the steepest line of sight, found by branch and bound in the quadtree of maxima.
//! Not a node.
//!
//! The ray that is traced is the horizon so far. A node that it clears can only hold what lies under it; in a cell that it does
//! not clear it is raised to the steepest line of the patch, in closed form, and goes on from there. So each cell is asked
//! once, in order, and what is found is exact but for rounding.
//! Source: Terrane; the notion of a horizon after Max, "Horizon mapping: shadows for bump-mapped surfaces", The Visual Computer 1988.

/// What a search found.
struct HorizonFound {
    /// Steps for each t of the steepest line of sight; not less than that of the search's ray.
    slope: f32,
    /// Whether the search came to its end.
    done: bool,
    /// Nodes visited.
    steps: u32,
    /// Patches loaded: not the one that the ray starts over, which is given.
    leaves: u32,
}

/// The horizon along a ray that starts above the ground. Its own slope, not below 0, is the least that matters, and the search
/// ends at one of `enough`. No texel is higher than `lid`. A node that is not larger than `coarse` times its distance stands for
/// all in it: with more than 0 the answer is faster and, if anything, too high. What rises over the horizon by no more than
/// `tolerance`, steps for each t, is passed over: with more than 0 the answer may be so much too low, and far faster on ground
/// that curves up, where every patch raises the horizon a little. `own` are the heights of the cell that it starts in.
fn horizon_search(
    heights: texture_2d_array<u32>,
    bounds: texture_2d_array<u32>,
    field: ReliefField,
    ray: ReliefRay,
    own: vec4f,
    enough: f32,
    lid: f32,
    coarse: f32,
    tolerance: f32,
) -> HorizonFound {
    var frame = walk_frame(ray);
    var horizon = frame.direction.z;
    frame.direction.z += tolerance;
    var state = climb_start(frame);
    var corners = relief_mirrored(own, frame.mirror);
    var leaves = 0u;
    while state.stands {
        var slope = (state.bound - frame.origin.z) / max(state.t, 1e-6);
        if state.node.level == 0i {
            let start = frame.origin.xy - (state.node.sides - 1.0);
            slope = horizon_patch(corners, vec3f(start, frame.origin.z), frame.direction.xy, state.t, state.leave);
        }
        horizon = max(horizon, slope);
        if horizon >= enough {
            break;
        }
        frame.direction.z = horizon + tolerance;
        frame.end = min(ray.end, max(lid - frame.origin.z, 0.0) / max(frame.direction.z, 1e-6));
        state = climb_on(bounds, field, frame, state, coarse);
        if state.stands && state.node.level == 0i {
            leaves++;
            corners = relief_corners(heights, field, climb_cell(frame, state.node), frame.mirror);
        }
    }
    let done = state.t >= frame.end || horizon >= enough;
    return HorizonFound(horizon, done, state.steps, leaves);
}

/// The steepest line from `start`, in the cell's frame, to a patch that a ray passes over from t to `leave`.
///
/// The patch under the ray is a quadratic in t, and the slope to it `square t + linear + pole / t`: it is steepest at an end, or
/// where square and pole are negative and their terms equal.
fn horizon_patch(corners: vec4f, start: vec3f, direction: vec2f, t: f32, leave: f32) -> f32 {
    let along = corners.yz - corners.x;
    let twist = corners.w - corners.y - along.y;
    let square = twist * direction.x * direction.y;
    // Around the middle of the way, so that little is subtracted from much.
    let middle = 0.5 * (t + leave);
    let half = 0.5 * (leave - t);
    let at = start.xy + direction * middle;
    let rise = corners.x + along.x * at.x + (along.y + twist * at.x) * at.y - start.z;
    let linear = dot(along, direction) + twist * (at.x * direction.y + at.y * direction.x);
    let ends = vec2f(-half, half);
    let heights = rise + ends * (linear + square * ends);
    let slopes = heights / max(middle + ends, vec2f(1e-6));
    let pole = rise - middle * (linear - square * middle);
    let crest = sqrt(max(pole / select(-1.0, square, square < 0.0), 0.0));
    let on = crest - middle;
    let inside = square < 0.0 && pole < 0.0 && abs(on) < half;
    let top = select(-RELIEF_NEVER, (rise + on * (linear + square * on)) / max(crest, 1e-6), inside);
    return max(max(slopes.x, slopes.y), top);
}
