//! Integer hashes and what is made of their bits. Never a sine: its accuracy outside -pi..pi is undefined in WGSL.
//! Source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020 (pcg3d).

/// Three random words from three words.
fn hash_pcg3d(key: vec3u) -> vec3u {
    var v = key * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// A number from 0 up to but not including 1, from the upper 24 bits: exact in f32.
fn hash_unit(bits: u32) -> f32 {
    return f32(bits >> 8u) * 0.000000059604644775390625;
}

/// Two such numbers.
fn hash_unit2(bits: vec2u) -> vec2f {
    return vec2f(bits >> vec2u(8u)) * 0.000000059604644775390625;
}

/// A unit vector in any direction, without sine and cosine.
///
/// The half-angle formula (1 - t^2, 2t) / (1 + t^2) runs through 90 degrees as |t| <= tan(22.5 degrees); two more bits turn it by quarters.
fn hash_direction(bits: u32) -> vec2f {
    let t = (f32((bits >> 8u) & 0xffffu) * 0.000030517578125 - 1.0) * 0.41421357;
    let d = vec2f(1.0 - t * t, 2.0 * t) / (1.0 + t * t);
    let turned = select(d, vec2f(-d.y, d.x), (bits & 0x40000000u) != 0u);
    return select(turned, -turned, (bits & 0x80000000u) != 0u);
}
