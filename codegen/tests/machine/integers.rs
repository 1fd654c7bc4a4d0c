//! Integers, bits and conversions, through WGSL, against Rust.

use terrane_codegen::machine::{Accept, Component, F32, F64, Value};

use crate::support::{Random, shader};

/// Bit patterns with many of the awkward ones.
fn patterns() -> Vec<[u32; 3]> {
    let mut random = Random::new(11);
    let special = [0, 1, 2, 7, 31, 32, 33, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, u32::MAX, u32::MAX - 1, 0xffff];
    let mut draw = || match random.below(3) {
        0 => special[random.below(special.len() as u32) as usize],
        1 => random.below(100),
        _ => random.bits(),
    };
    (0..5000).map(|_| [draw(), draw(), draw()]).collect()
}

/// `expression` of `a`, `b`, `c` of type i32 or u32, in all domains.
#[track_caller]
fn check(ty: &str, expression: &str, reference: impl Fn(u32, u32, u32) -> u32) {
    let shader = shader(&format!("fn f(a: {ty}, b: {ty}, c: {ty}) -> {ty} {{ return {expression}; }}"));
    let points = patterns();
    let column = |i: usize| points.iter().map(|point| point[i]).collect::<Vec<u32>>();
    let expected: Vec<u32> = points.iter().map(|[a, b, c]| reference(*a, *b, *c)).collect();
    let single = shader.call::<F32>("f", &[0, 1, 2].map(|i| Value::u32(&column(i))), points.len());
    let double = shader.call::<F64>("f", &[0, 1, 2].map(|i| Value::u32(&column(i))), points.len());
    let accepted = shader.call::<Accept>("f", &[0, 1, 2].map(|i| Value::u32(&column(i))), points.len());
    for (i, point) in points.iter().enumerate() {
        let what = format!("{expression} of {point:?}, result {}", expected[i]);
        assert_eq!(single.int_at(0, i), Some(expected[i]), "{what}");
        assert_eq!(double.int_at(0, i), Some(expected[i]), "{what}");
        let accepted = accepted.int_at(0, i).expect("an integer");
        assert_eq!(accepted.values(), Some(&expected[i..=i]), "{what}");
    }
}

#[track_caller]
fn signed(expression: &str, reference: impl Fn(i32, i32, i32) -> i32) {
    check("i32", expression, |a, b, c| reference(a as i32, b as i32, c as i32) as u32);
}

#[track_caller]
fn unsigned(expression: &str, reference: impl Fn(u32, u32, u32) -> u32) {
    check("u32", expression, reference);
}

#[test]
fn arithmetic_wraps_and_division_is_total() {
    signed("a + b * c - 7", |a, b, c| a.wrapping_add(b.wrapping_mul(c)).wrapping_sub(7));
    unsigned("a + b * c - 7u", |a, b, c| a.wrapping_add(b.wrapping_mul(c)).wrapping_sub(7));
    signed("a / b", |a, b, _| if b == 0 { a } else { a.wrapping_div(b) });
    signed("a % b", |a, b, _| if b == 0 { 0 } else { a.wrapping_rem(b) });
    unsigned("a / b", |a, b, _| a.checked_div(b).unwrap_or(a));
    unsigned("a % b", |a, b, _| if b == 0 { 0 } else { a % b });
    signed("-a", |a, _, _| a.wrapping_neg());
}

#[test]
fn bits_and_shifts() {
    signed("(a & b) | (a ^ c) | ~b", |a, b, c| (a & b) | (a ^ c) | !b);
    signed("a << (u32(b) & 63u)", |a, b, _| a.wrapping_shl(b as u32));
    signed("a >> (u32(b) & 63u)", |a, b, _| a.wrapping_shr(b as u32));
    unsigned("(a << (b & 63u)) ^ (a >> (c & 63u))", |a, b, c| a.wrapping_shl(b) ^ a.wrapping_shr(c));
    unsigned("countOneBits(a) + countLeadingZeros(b) * 100u", |a, b, _| a.count_ones() + b.leading_zeros() * 100);
    unsigned("countTrailingZeros(a) ^ reverseBits(b)", |a, b, _| a.trailing_zeros() ^ b.reverse_bits());
    unsigned("firstLeadingBit(a) ^ (firstTrailingBit(b) << 8u)", |a, b, _| {
        let trailing = if b == 0 { u32::MAX } else { b.trailing_zeros() };
        a.checked_ilog2().unwrap_or(u32::MAX) ^ (trailing << 8)
    });
    signed("firstLeadingBit(a)", |a, _, _| {
        (if a < 0 { !a } else { a } as u32).checked_ilog2().map_or(-1, |x| x as i32)
    });
    unsigned("extractBits(a, b, c)", |a, b, c| {
        let (offset, count) = (b.min(32), c.min(32 - b.min(32)));
        ((u64::from(a) >> offset) & ((1_u64 << count) - 1)) as u32
    });
    signed("extractBits(a, u32(b), u32(c))", |a, b, c| {
        let offset = (b as u32).min(32);
        let count = (c as u32).min(32 - offset);
        if count == 0 { 0 } else { (i64::from(a) << (64 - offset - count) >> (64 - count)) as i32 }
    });
    unsigned("insertBits(a, b, c, 9u)", |a, b, c| {
        let offset = c.min(32);
        let mask = ((((1_u64 << 9.min(32 - offset)) - 1) << offset) & 0xffff_ffff) as u32;
        (a & !mask) | (((u64::from(b) << offset) as u32) & mask)
    });
}

#[test]
fn order_and_sign() {
    signed("min(a, b) ^ max(b, c) ^ clamp(a, -5, 9)", |a, b, c| a.min(b) ^ b.max(c) ^ a.clamp(-5, 9));
    unsigned("min(a, b) ^ max(b, c) ^ clamp(a, 5u, 9u)", |a, b, c| a.min(b) ^ b.max(c) ^ a.clamp(5, 9));
    signed("abs(a) + sign(b)", |a, b, _| a.wrapping_abs().wrapping_add(b.signum()));
    signed("select(a, b, a < c) ^ select(0, 1, a >= b) ^ select(0, 2, b <= c) ^ select(0, 4, b != c)", |a, b, c| {
        (if a < c { b } else { a }) ^ i32::from(a >= b) ^ (i32::from(b <= c) << 1) ^ (i32::from(b != c) << 2)
    });
    unsigned("select(a, b, a < c) ^ select(0u, 1u, a > b)", |a, b, c| (if a < c { b } else { a }) ^ u32::from(a > b));
    signed("dot(vec2i(a, b), vec2i(b, c))", |a, b, c| a.wrapping_mul(b).wrapping_add(b.wrapping_mul(c)));
}

#[test]
fn casts_keep_or_reinterpret() {
    signed("i32(bitcast<u32>(a)) + bitcast<i32>(u32(b))", |a, b, _| a.wrapping_add(b));
    unsigned("u32(a > b) + u32(bool(c))", |a, b, c| u32::from(a > b) + u32::from(c != 0));
    unsigned("bitcast<u32>(bitcast<f32>((a & 0x3fffffffu) | 0x20000000u))", |a, _, _| (a & 0x3fff_ffff) | 0x2000_0000);
    signed("i32(f32(a % 100000) * 0.5)", |a, _, _| (f64::from(a % 100_000) * 0.5) as i32);
}

#[test]
fn floats_to_integers_clamp_and_truncate() {
    let shader = shader("fn f(x: f32) -> vec2i { return vec2i(i32(x), bitcast<i32>(u32(x))); }");
    let values = [0.0, 0.99, -0.99, 3.7, -3.7, 3e9, 1e20, -1e20, 2_147_483_520.0, f32::NAN];
    let result = shader.call::<F32>("f", &[Value::f32(&values)], values.len());
    let signed = [0, 0, 0, 3, -3, 2_147_483_520, 2_147_483_520, i32::MIN, 2_147_483_520, 0];
    let unsigned = [0, 0, 0, 3, 0, 3_000_000_000, 4_294_967_040, 0, 2_147_483_520, 0_u32];
    assert_eq!(result.components[0], Component::Int(signed.map(|x: i32| x as u32).to_vec()));
    assert_eq!(result.components[1], Component::Int(unsigned.to_vec()));
}

#[test]
fn packing_is_that_of_the_specification() {
    let shader = shader(
        "fn f(x: vec4f) -> vec4u {
            return vec4u(pack4x8unorm(x), pack4x8snorm(x), pack2x16unorm(x.xy), pack2x16snorm(x.zw));
        }
        fn g(w: u32) -> vec4f { return unpack4x8unorm(w) + unpack4x8snorm(w) + vec4f(unpack2x16unorm(w), unpack2x16snorm(w)); }
        fn h(x: vec4i) -> vec4u {
            let u = bitcast<vec4u>(x);
            return vec4u(pack4xI8(x), pack4xU8(u), pack4xI8Clamp(x), pack4xU8Clamp(u));
        }
        fn i(w: u32) -> vec4i { return unpack4xI8(w) + vec4i(unpack4xU8(w)); }
        fn j(x: vec2f) -> u32 { return pack2x16float(x); }
        fn k(w: u32) -> vec2f { return unpack2x16float(w); }",
    );
    let x = [0.0, 1.0, -0.5, 0.3];
    let result = shader.call::<F32>("f", &[Value::vector(&[x])], 1);
    let ints = |value: &Value<F32>| (0..4).map(|i| value.int_at(i, 0).expect("an integer")).collect::<Vec<_>>();
    // floor(0.5 + 255 * 0.3) = 77, floor(0.5 - 127 * 0.5) = -63, floor(0.5 + 127 * 0.3) = 38, floor(0.5 + 32767 * 0.3) = 9830.
    assert_eq!(ints(&result), [0x4d00_ff00, 0x26c1_7f00, 0xffff_0000, 0x2666_c001]);
    let word = 0x4dc1_ff00;
    let result = shader.call::<F64>("g", &[Value::u32(&[word])], 1);
    let expected = [
        f64::from(0xff00) / 65535.0,
        1.0 - 1.0 / 127.0 + f64::from(0x4dc1) / 65535.0,
        f64::from(0xc1) / 255.0 - 63.0 / 127.0 - 256.0 / 32767.0,
        f64::from(0x4d) / 255.0 + 77.0 / 127.0 + f64::from(0x4dc1) / 32767.0,
    ];
    for (i, expected) in expected.into_iter().enumerate() {
        let found = result.float_at(i, 0).expect("a float");
        assert!((found - expected).abs() < 1e-12, "{i}: {found}, not {expected}");
    }
    let result = shader.call::<F32>("h", &[Value::integers(&[[1, -2, 300, -400]])], 1);
    assert_eq!(ints(&result), [0x702c_fe01, 0x702c_fe01, 0x807f_fe01, 0xffff_ff01]);
    let result = shader.call::<F32>("i", &[Value::u32(&[0x80ff_7f01])], 1);
    assert_eq!(ints(&result), [2, 254, 254, 0]);
    let result = shader.call::<F32>("j", &[Value::vector(&[[1.0, -2.5]])], 1);
    assert_eq!(result.int_at(0, 0), Some(0xc100_3c00));
    let result = shader.call::<F32>("k", &[Value::u32(&[0xc100_3c00])], 1);
    assert_eq!([result.float_at(0, 0), result.float_at(1, 0)], [Some(1.0), Some(-2.5)]);
}
