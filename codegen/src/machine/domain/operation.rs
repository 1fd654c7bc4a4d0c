//! The scalar operations a domain must know, and the means to choose a loop by operation once per step, not once per lane.

/// Declares an enum of operations and a macro that runs a body with the operation as a compile-time constant.
macro_rules! operations {
    ($d:tt $(#[$doc:meta])* $name:ident by $each:ident { $($(#[$about:meta])* $variant:ident,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name { $($(#[$about])* $variant,)* }

        impl $name {
            /// Every operation of this family.
            pub const ALL: &[Self] = &[$(Self::$variant,)*];
        }

        macro_rules! $each {
            ($d op:expr, $d known:ident => $d body:expr) => {
                match $d op {
                    $($name::$variant => {
                        const $d known: $name = $name::$variant;
                        $d body
                    })*
                }
            };
        }
        pub(crate) use $each;
    };
}

operations! { $
    /// `f32 -> f32`.
    FloatUnary by each_float_unary {
        /// `-x`.
        Negate,
        /// `abs(x)`.
        Abs,
        /// -1, 0 or 1.
        Sign,
        /// Towards minus infinity.
        Floor,
        /// Towards plus infinity.
        Ceil,
        /// To the nearest whole number, ties to even.
        Round,
        /// Towards zero.
        Trunc,
        /// `x - floor(x)`.
        Fract,
        /// Clamped to 0..1.
        Saturate,
        /// `x * x`, known to be one number twice.
        Square,
        /// `sqrt(x)`.
        Sqrt,
        /// `1 / sqrt(x)`.
        InverseSqrt,
        /// e to the power of x.
        Exp,
        /// 2 to the power of x.
        Exp2,
        /// Natural logarithm.
        Log,
        /// Logarithm of base 2.
        Log2,
        /// `sin(x)`, x in radians.
        Sin,
        /// `cos(x)`, x in radians.
        Cos,
        /// `tan(x)`, x in radians.
        Tan,
        /// `sinh(x)`.
        Sinh,
        /// `cosh(x)`.
        Cosh,
        /// `tanh(x)`.
        Tanh,
        /// `asin(x)`, radians.
        Asin,
        /// `acos(x)`, radians.
        Acos,
        /// `atan(x)`, radians.
        Atan,
        /// `asinh(x)`.
        Asinh,
        /// `acosh(x)`.
        Acosh,
        /// `atanh(x)`.
        Atanh,
        /// Degrees to radians.
        Radians,
        /// Radians to degrees.
        Degrees,
        /// Rounded to a half float and back.
        QuantizeToF16,
        /// x, of which WGSL does not say how accurate it is (a determinant).
        Unspecified,
        /// The fraction of `frexp(x)`: 0, or of magnitude 0.5..1.
        FrexpFraction,
    }
}

operations! { $
    /// `f32, f32 -> f32`.
    FloatBinary by each_float_binary {
        /// `a + b`.
        Add,
        /// `a - b`.
        Subtract,
        /// `a * b`.
        Multiply,
        /// `a / b`.
        Divide,
        /// `a % b`: `a - b * trunc(a / b)`.
        Remainder,
        /// The smaller one.
        Min,
        /// The larger one.
        Max,
        /// `step(edge, x)`: 1 where `edge <= x`, else 0.
        Step,
        /// `pow(a, b)`, for `a >= 0`.
        Pow,
        /// `atan2(y, x)`, radians.
        Atan2,
    }
}

operations! { $
    /// `f32, f32, f32 -> f32`.
    FloatTernary by each_float_ternary {
        /// `clamp(x, low, high)`.
        Clamp,
        /// `fma(a, b, c)`: `a * b + c`.
        Fma,
        /// `mix(a, b, t)`: `a * (1 - t) + b * t`.
        Mix,
        /// `smoothstep(low, high, x)`.
        SmoothStep,
    }
}

operations! { $
    /// `f32, f32 -> bool`. `a > b` is `b < a`.
    FloatComparison by each_float_comparison {
        /// `a == b`.
        Equal,
        /// `a != b`.
        NotEqual,
        /// `a < b`.
        Less,
        /// `a <= b`.
        LessEqual,
    }
}

operations! { $
    /// On 32 bits; the sign is a matter of the operation.
    IntUnary by each_int_unary {
        /// `-x`, wrapping.
        Negate,
        /// `~x`.
        Not,
        /// `abs(x)`, signed; the most negative number is its own.
        Abs,
        /// -1, 0 or 1 of a signed number.
        Sign,
        /// How many 0 bits above the highest 1.
        CountLeadingZeros,
        /// How many 0 bits below the lowest 1.
        CountTrailingZeros,
        /// How many 1 bits.
        CountOneBits,
        /// Bit 0 to bit 31 and so on.
        ReverseBits,
        /// The highest bit that differs from the sign; -1 if none.
        FirstLeadingBitSigned,
        /// The highest 1 bit; -1 if none.
        FirstLeadingBit,
        /// The lowest 1 bit; -1 if none.
        FirstTrailingBit,
    }
}

operations! { $
    /// On 32 bits, with WGSL's rules for overflow and division by zero.
    IntBinary by each_int_binary {
        /// `a + b`, wrapping.
        Add,
        /// `a - b`, wrapping.
        Subtract,
        /// `a * b`, wrapping.
        Multiply,
        /// Signed `a / b`, towards zero; `a` where b is 0 or the result overflows.
        DivideSigned,
        /// Unsigned `a / b`; `a` where b is 0.
        Divide,
        /// Signed `a % b` with the sign of a; 0 where b is 0 or the division overflows.
        RemainderSigned,
        /// Unsigned `a % b`; 0 where b is 0.
        Remainder,
        /// Bits in both.
        And,
        /// Bits in either.
        Or,
        /// Bits in one.
        Xor,
        /// `a << (b & 31)`.
        ShiftLeft,
        /// `a >> (b & 31)`, filled with the sign.
        ShiftRightSigned,
        /// `a >> (b & 31)`, filled with 0.
        ShiftRight,
        /// The smaller signed number.
        MinSigned,
        /// The smaller unsigned number.
        Min,
        /// The larger signed number.
        MaxSigned,
        /// The larger unsigned number.
        Max,
    }
}

operations! { $
    /// `i32, i32 -> bool` or `u32, u32 -> bool`. `a > b` is `b < a`.
    IntComparison by each_int_comparison {
        /// `a == b`.
        Equal,
        /// `a != b`.
        NotEqual,
        /// Signed `a < b`.
        LessSigned,
        /// Unsigned `a < b`.
        Less,
        /// Signed `a <= b`.
        LessEqualSigned,
        /// Unsigned `a <= b`.
        LessEqual,
    }
}

operations! { $
    /// `bool, bool -> bool`.
    TruthBinary by each_truth_binary {
        /// Both.
        And,
        /// Either.
        Or,
        /// `a == b`.
        Equal,
        /// `a != b`.
        NotEqual,
    }
}
