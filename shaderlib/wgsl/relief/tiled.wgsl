//! Tile by tile over a map that wraps and whose sides are no powers of two: a ray is cut where it crosses the border of a tile,
//! and each part is traced by any method as over a map that ends there. Not a node.
//!
//! The tile is integer state, as a cell is: each part begins at the border where the last one ended, and its place on the
//! crossed axis is that border itself, no rounded position. The map is placed with its first column and row again at its end.
//! Source: Terrane.

/// The part of a ray over one tile.
struct TiledPart {
    /// The part, its cell counted in the tile.
    ray: ReliefRay,
    /// t of the whole ray where it begins.
    start: f32,
    /// The tile's first cell.
    corner: vec2i,
    /// The axis along which the ray goes on to the next tile: 1 where it does.
    step: vec2i,
}

/// The part of a ray over the tile that it starts in; a tile has as many cells as the last texel's column and row.
fn tiled_first(field: ReliefField, whole: ReliefRay) -> TiledPart {
    // Rounded down, where division rounds toward 0.
    let tile = select(whole.cell, whole.cell - field.last + 1i, whole.cell < vec2i(0)) / field.last;
    return tiled_part(field, whole, tile * field.last, 0.0, vec2i(0));
}

/// The part over the tile behind another part.
fn tiled_next(field: ReliefField, whole: ReliefRay, part: TiledPart) -> TiledPart {
    let way = select(vec2i(1), vec2i(-1), whole.direction.xy < vec2f(0.0));
    return tiled_part(field, whole, part.corner + way * part.step * field.last, part.start + part.ray.end, part.step);
}

/// The part over a tile from t = `start`, where the ray has just crossed the border on the axis of `crossed`.
fn tiled_part(field: ReliefField, whole: ReliefRay, corner: vec2i, start: f32, crossed: vec2i) -> TiledPart {
    let backward = whole.direction.xy < vec2f(0.0);
    let border = select(vec2i(0), field.last, backward);
    let at = whole.origin + whole.direction * start;
    // Whole cells stay apart from the place in one: beside hundreds of them f32 keeps too little of it.
    let met = vec2i(floor(at.xy)) + (whole.cell - corner);
    let cell = clamp(select(met, border, crossed > vec2i(0)), vec2i(0), field.last - 1i);
    let place = select(at.xy - vec2f(cell + corner - whole.cell), vec2f(border - cell), crossed > vec2i(0));
    let far = vec2f(corner - whole.cell + select(field.last, vec2i(0), backward)) - whole.origin.xy;
    // A border that rounding has put before the entry is crossed at once.
    let leave = max(select(far, -far, backward) / max(abs(whole.direction.xy), vec2f(RELIEF_LEAST)), vec2f(start));
    let end = min(min(leave.x, leave.y), whole.end);
    let step = select(vec2i(0, 1), vec2i(1, 0), leave.x <= leave.y);
    let origin = vec3f(saturate(place), at.z);
    return TiledPart(ReliefRay(cell, origin, whole.direction, end - start), start, corner, step);
}
