//! Square cones as shaders read them, made on the device from their slopes: the forms of `relief/cones.rs`.

/// What square cones are steeper than they need be.
override build_steeper: f32 = 1.0;

/// The bits of the slope whose code is 0.
override build_gentlest: u32 = 0u;

/// The smallest code whose slope is not below one: five bits of exponent, eleven of mantissa, rounded up.
fn build_code(slope: f32) -> u32 {
    let bits = max(bitcast<u32>(slope * build_steeper), build_gentlest) - build_gentlest;
    return min((bits + 0xfffu) >> 12u, 0xffffu);
}

/// Codes rounded up to twelve bits.
fn build_twelve(codes: vec4u) -> vec4u {
    return min((codes + 15u) >> vec4u(4u), vec4u(0xfffu));
}

/// Which of the slopes is stored, where it is one.
override build_way: u32 = 0u;

/// The cell whose cone stands at a texel: the last one again where none begins.
fn build_cell(position: vec4f) -> vec2i {
    return min(build_place(position), build_part.size - 1i);
}

/// The height of a cone's tip, and its code.
@fragment
fn build_cone(@builtin(position) position: vec4f) -> @location(0) vec2u {
    let at = build_cell(position);
    return vec2u(build_texel(at), build_code(textureLoad(build_slopes, at, 0i)[build_way]));
}

/// The codes of the four quadrants, of twelve bits each, and above them the halves of the tip's height.
@fragment
fn build_quadrants(@builtin(position) position: vec4f) -> @location(0) vec4u {
    let at = build_cell(position);
    let slopes = textureLoad(build_slopes, at, 0i);
    let codes = build_twelve(vec4u(build_code(slopes.x), build_code(slopes.y), build_code(slopes.z), build_code(slopes.w)));
    let tip = build_texel(at);
    let words = codes.xz | (codes.yw << vec2u(12u)) | (vec2u(tip & 0xffu, tip >> 8u) << vec2u(24u));
    return vec4u(words, 0u, 0u);
}
