//! Every builtin that a library calls, through WGSL, against `std` and `glam` in `f64`.

use glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4};
use terrane_codegen::machine::{Accept, Domain, F32, F64, Value};

use crate::support::{Random, shader};

/// Evaluates `expression` of `a`, `b`, `c` (of the given WGSL type, with so many components) at random points.
///
/// The reference gets the arguments and gives all scalars of the result. F64 must agree to 1e-12, F32 to a tolerance,
/// and both must lie inside `Accept`.
#[track_caller]
fn check<const N: usize>(
    ty: &str,
    result: &str,
    expression: &str,
    tolerance: f64,
    range: (f32, f32),
    reference: impl Fn([[f64; N]; 3]) -> Vec<f64>,
) {
    let shader = shader(&format!("fn f(a: {ty}, b: {ty}, c: {ty}) -> {result} {{ return {expression}; }}"));
    let mut random = Random::new(7);
    let mut draw = || std::array::from_fn::<f32, N, _>(|_| range.0 + (range.1 - range.0) * random.unit());
    let points: Vec<[[f32; N]; 3]> = (0..2000).map(|_| [draw(), draw(), draw()]).collect();
    let single = shader.call::<F32>("f", &arguments(&points), points.len());
    let double = shader.call::<F64>("f", &arguments(&points), points.len());
    let accepted = shader.call::<Accept>("f", &arguments(&points), points.len());
    for (i, point) in points.iter().enumerate() {
        let expected = reference(point.map(|x| x.map(f64::from)));
        assert_eq!(expected.len(), double.components.len(), "{expression}: scalars of the result");
        for (component, expected) in expected.into_iter().enumerate() {
            let double = double.float_at(component, i).expect("a float");
            let single = single.float_at(component, i).expect("a float");
            let accepted = accepted.float_at(component, i).expect("a float");
            let scale = expected.abs().max(1.0);
            assert!((double - expected).abs() <= 1e-12 * scale, "{expression} of {point:?}: {double}, not {expected}");
            let error = (f64::from(single) - expected).abs();
            assert!(error <= tolerance * scale, "{expression} of {point:?}: {single}, not {expected}");
            assert!(accepted.holds(double), "{expression} of {point:?}: {double} is not in {accepted:?}");
            assert!(accepted.accepts(single), "{expression} of {point:?}: {single} is not in {accepted:?}");
        }
    }
}

fn arguments<D: Domain, const N: usize>(points: &[[[f32; N]; 3]]) -> Vec<Value<D>> {
    (0..3).map(|i| Value::vector(&points.iter().map(|point| point[i]).collect::<Vec<_>>())).collect()
}

#[track_caller]
fn scalar(expression: &str, range: (f32, f32), reference: impl Fn(f64, f64, f64) -> f64) {
    check::<1>("f32", "f32", expression, 1e-5, range, |[[a], [b], [c]]| vec![reference(a, b, c)]);
}

const AROUND: (f32, f32) = (-4.0, 4.0);
const POSITIVE: (f32, f32) = (0.1, 4.0);
const UNIT: (f32, f32) = (0.0, 1.0);

#[test]
fn operators() {
    scalar("a + b - c", AROUND, |a, b, c| a + b - c);
    scalar("a * b / c", POSITIVE, |a, b, c| a * b / c);
    scalar("-a", AROUND, |a, _, _| -a);
    check::<1>("f32", "f32", "a % b", 1e-4, (0.5, 4.0), |[[a], [b], _]| vec![a % b]);
    check::<3>("vec3f", "vec3f", "a * b + 2.0 * c", 1e-6, AROUND, |[a, b, c]| {
        (DVec3::from(a) * DVec3::from(b) + 2.0 * DVec3::from(c)).to_array().to_vec()
    });
    check::<3>("vec3f", "vec3f", "a / b.x - 1.0", 1e-6, POSITIVE, |[a, b, _]| {
        (DVec3::from(a) / b[0] - 1.0).to_array().to_vec()
    });
    scalar("select(a, b, c > 0.5)", UNIT, |a, b, c| if c > 0.5 { b } else { a });
    scalar("select(a, b, (a < b) != (b <= c))", UNIT, |a, b, c| if (a < b) != (b <= c) { b } else { a });
    scalar("select(a, b, a >= c || b == c)", UNIT, |a, b, c| if a >= c { b } else { a });
    check::<2>("vec2f", "vec2f", "select(a, b, c > a)", 1e-6, UNIT, |[a, b, c]| {
        (0..2).map(|i| if c[i] > a[i] { b[i] } else { a[i] }).collect()
    });
    scalar("f32(all(vec2f(a, b) > vec2f(c))) + f32(any(vec2f(a, b) > vec2f(c)))", UNIT, |a, b, c| {
        f64::from(u8::from(a > c && b > c) + u8::from(a > c || b > c))
    });
}

#[test]
fn rounding_and_clamping() {
    scalar("abs(a) + floor(b) + ceil(c)", AROUND, |a, b, c| a.abs() + b.floor() + c.ceil());
    scalar("trunc(a) + round(b * 4.0) + fract(c)", AROUND, |a, b, c| {
        a.trunc() + (b * 4.0).round_ties_even() + (c - c.floor())
    });
    scalar("min(a, b) + max(b, c)", AROUND, |a, b, c| a.min(b) + b.max(c));
    scalar("clamp(a, -1.0, 2.0) + saturate(b)", AROUND, |a, b, _| a.clamp(-1.0, 2.0) + b.clamp(0.0, 1.0));
    scalar("step(a, b) + sign(c)", AROUND, |a, b, c| f64::from(u8::from(a <= b)) + c.signum());
    scalar("modf(a).fract + 2.0 * modf(b).whole", AROUND, |a, b, _| a.fract() + 2.0 * b.trunc());
    scalar("frexp(a).fract * exp2(f32(frexp(a).exp))", AROUND, |a, _, _| a);
    scalar("ldexp(a, 3) + ldexp(b, -2)", AROUND, |a, b, _| a * 8.0 + b / 4.0);
    check::<1>("f32", "f32", "quantizeToF16(a)", 1e-3, AROUND, |[[a], ..]| {
        let scale = 2_f64.powi(10 - a.abs().max(2_f64.powi(-14)).log2().floor() as i32);
        vec![(a * scale).round_ties_even() / scale]
    });
}

#[test]
fn mixing() {
    scalar("mix(a, b, c)", UNIT, |a, b, c| a * (1.0 - c) + b * c);
    scalar("fma(a, b, c)", AROUND, |a, b, c| a * b + c);
    scalar("smoothstep(-1.0, 2.0, a)", AROUND, |a, _, _| {
        let t = ((a + 1.0) / 3.0).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    });
    scalar("smoothstep(2.0, -1.0, a)", AROUND, |a, _, _| {
        let t = ((2.0 - a) / 3.0).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    });
    check::<3>("vec3f", "vec3f", "mix(a, b, c.x) + mix(b, c, a)", 1e-6, UNIT, |[a, b, c]| {
        (0..3).map(|i| a[i] * (1.0 - c[0]) + b[i] * c[0] + b[i] * (1.0 - a[i]) + c[i] * a[i]).collect()
    });
}

#[test]
fn exponentials_and_logarithms() {
    scalar("exp(a) + exp2(b)", AROUND, |a, b, _| a.exp() + b.exp2());
    scalar("log(a) + log2(b)", POSITIVE, |a, b, _| a.ln() + b.log2());
    scalar("pow(a, b)", POSITIVE, |a, b, _| a.powf(b));
    scalar("sqrt(a) + inverseSqrt(b)", POSITIVE, |a, b, _| a.sqrt() + 1.0 / b.sqrt());
}

#[test]
fn trigonometry() {
    scalar("sin(a) + cos(b)", (-3.0, 3.0), |a, b, _| a.sin() + b.cos());
    scalar("tan(a)", (-1.0, 1.0), |a, _, _| a.tan());
    scalar("asin(a) + acos(b)", (-0.9, 0.9), |a, b, _| a.asin() + b.acos());
    scalar("atan(a) + atan2(b, c)", AROUND, |a, b, c| a.atan() + b.atan2(c));
    scalar("sinh(a) + cosh(b) + tanh(c)", AROUND, |a, b, c| a.sinh() + b.cosh() + c.tanh());
    scalar("asinh(a) + acosh(1.5 + a * a) + atanh(0.2 * a)", AROUND, |a, _, _| {
        // The constants are the shader's: a rounded 0.2.
        a.asinh() + (1.5 + a * a).acosh() + (f64::from(0.2_f32) * a).atanh()
    });
    scalar("radians(a) + degrees(b)", AROUND, |a, b, _| a.to_radians() + b.to_degrees());
}

#[test]
fn geometry() {
    check::<3>("vec3f", "f32", "dot(a, b) + length(c)", 1e-5, POSITIVE, |[a, b, c]| {
        vec![DVec3::from(a).dot(DVec3::from(b)) + DVec3::from(c).length()]
    });
    check::<2>("vec2f", "f32", "distance(a, b)", 1e-5, AROUND, |[a, b, _]| {
        vec![DVec2::from(a).distance(DVec2::from(b))]
    });
    check::<3>("vec3f", "vec3f", "normalize(a) + cross(b, c)", 1e-5, POSITIVE, |[a, b, c]| {
        (DVec3::from(a).normalize() + DVec3::from(b).cross(DVec3::from(c))).to_array().to_vec()
    });
    check::<3>("vec3f", "vec3f", "reflect(a, normalize(b))", 1e-5, AROUND, |[a, b, _]| {
        DVec3::from(a).reflect(DVec3::from(b).normalize()).to_array().to_vec()
    });
    check::<3>("vec3f", "vec3f", "refract(normalize(a), normalize(b), 0.75)", 1e-5, AROUND, |[a, b, _]| {
        DVec3::from(a).normalize().refract(DVec3::from(b).normalize(), 0.75).to_array().to_vec()
    });
    check::<3>("vec3f", "vec3f", "faceForward(a, b, c)", 1e-6, AROUND, |[a, b, c]| {
        let sign = if DVec3::from(b).dot(DVec3::from(c)) < 0.0 { 1.0 } else { -1.0 };
        (sign * DVec3::from(a)).to_array().to_vec()
    });
    check::<4>("vec4f", "f32", "dot(a, b) + length(c)", 1e-5, AROUND, |[a, b, c]| {
        vec![DVec4::from(a).dot(DVec4::from(b)) + DVec4::from(c).length()]
    });
}

#[test]
fn matrices() {
    check::<2>("vec2f", "vec2f", "mat2x2f(a, b) * c", 1e-5, AROUND, |[a, b, c]| {
        (DMat2::from_cols(a.into(), b.into()) * DVec2::from(c)).to_array().to_vec()
    });
    check::<3>("vec3f", "vec3f", "a * mat3x3f(a, b, c)", 1e-5, AROUND, |[a, b, c]| {
        let matrix = DMat3::from_cols(a.into(), b.into(), c.into());
        (matrix.transpose() * DVec3::from(a)).to_array().to_vec()
    });
    check::<3>(
        "vec3f",
        "mat3x3f",
        "mat3x3f(a, b, c) * transpose(mat3x3f(c, a, b)) * 2.0",
        1e-5,
        AROUND,
        |[a, b, c]| {
            let (m, n) =
                (DMat3::from_cols(a.into(), b.into(), c.into()), DMat3::from_cols(c.into(), a.into(), b.into()));
            (m * n.transpose() * 2.0).to_cols_array().to_vec()
        },
    );
    check::<3>("vec3f", "mat3x3f", "mat3x3f(a, b, c) + mat3x3f(c, b, a) - mat3x3f(b, b, b)", 1e-5, AROUND, {
        |[a, b, c]| {
            let sum = |i: usize| [a[i] + c[i] - b[i], b[i], c[i] + a[i] - b[i]];
            let columns: Vec<[f64; 3]> = (0..3).map(sum).collect();
            (0..3).flat_map(|column| (0..3).map(move |row| (row, column))).map(|(r, c)| columns[r][c]).collect()
        }
    });
    check::<3>("vec3f", "vec2f", "mat3x2f(a.xy, b.xy, c.xy) * a", 1e-5, AROUND, |[a, b, c]| {
        (0..2).map(|row| a[row] * a[0] + b[row] * a[1] + c[row] * a[2]).collect()
    });
    check::<4>("vec4f", "f32", "determinant(mat4x4f(a, b, c, a.wzyx))", 1e-4, AROUND, |[a, b, c]| {
        let last = DVec4::new(a[3], a[2], a[1], a[0]);
        vec![DMat4::from_cols(a.into(), b.into(), c.into(), last).determinant()]
    });
}
