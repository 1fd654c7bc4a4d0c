//! Entry points that turn radiance into a picture: tone curve per sample, mean of the samples, sRGB.

struct ResolveSettings {
    /// Samples of a pixel on a side.
    samples: u32,
}

@group(0) @binding(0) var<uniform> resolve_settings: ResolveSettings;
@group(0) @binding(1) var resolve_radiance: texture_2d<f32>;

@vertex
fn resolve_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(select(-1.0, 3.0, index == 1u), select(-1.0, 3.0, index == 2u), 0.0, 1.0);
}

/// The sigmoid of AgX on 16.5 stops, as a polynomial.
fn resolve_sigmoid(x: vec3f) -> vec3f {
    let x2 = x * x;
    let x4 = x2 * x2;
    return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
}

/// AgX: from scene radiance (0.18 is middle grey) to display light, 0..1, linear Rec. 709. Highlights lose colour as film
/// does. Source: Sobotka, "AgX", 2022, in the form of Wrensch, "Minimal AgX Implementation", 2023, with a look a little
/// softer than his "punchy" one, which has 1.35 and 1.4.
fn resolve_agx(radiance: vec3f) -> vec3f {
    let inset = mat3x3f(
        vec3f(0.842479062253094, 0.0423282422610123, 0.0423756549057051),
        vec3f(0.0784335999999992, 0.878468636469772, 0.0784336),
        vec3f(0.0792237451477643, 0.0791661274605434, 0.879142973793104),
    );
    let outset = mat3x3f(
        vec3f(1.19687900512017, -0.0528968517574562, -0.0529716355144438),
        vec3f(-0.0980208811401368, 1.15190312990417, -0.0980434501171241),
        vec3f(-0.0990297440797205, -0.0989611768448433, 1.15107367264116),
    );
    let stops = log2(max(inset * radiance, vec3f(1e-10)));
    let encoded = max(resolve_sigmoid(clamp((stops + 12.47393) / 16.5, vec3f(0.0), vec3f(1.0))), vec3f(0.0));
    let graded = pow(encoded, vec3f(1.3));
    let grey = dot(graded, vec3f(0.2126, 0.7152, 0.0722));
    let look = max(outset * (grey + 1.35 * (graded - grey)), vec3f(0.0));
    return min(pow(look, vec3f(2.2)), vec3f(1.0));
}

fn resolve_srgb(light: vec3f) -> vec3f {
    return select(1.055 * pow(light, vec3f(1.0 / 2.4)) - 0.055, 12.92 * light, light <= vec3f(0.0031308));
}

/// 0..1, the same for a pixel in every run. Source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020.
fn resolve_noise(pixel: vec2u) -> f32 {
    let state = (pixel.x + pixel.y * 65536u) * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return f32(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

@fragment
fn resolve_fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2u(position.xy);
    let samples = resolve_settings.samples;
    var sum = vec3f(0.0);
    for (var y = 0u; y < samples; y++) {
        for (var x = 0u; x < samples; x++) {
            sum += resolve_agx(textureLoad(resolve_radiance, pixel * samples + vec2u(x, y), 0i).rgb);
        }
    }
    // Half a step of 8 bits to either side: no bands in a clear sky.
    let dither = (resolve_noise(pixel) - 0.5) / 255.0;
    return vec4f(clamp(resolve_srgb(sum / f32(samples * samples)) + dither, vec3f(0.0), vec3f(1.0)), 1.0);
}
