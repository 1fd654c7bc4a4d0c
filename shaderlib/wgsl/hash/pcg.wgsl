//! A whole number to an unpredictable one: the base of everything random.
//! Source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020 (pcg); O'Neill, "PCG", 2014 (RXS-M-XS 32).

/// pcg(0u) == 129708002u +- 0
/// -> Every whole number comes out exactly once.
fn pcg(
    /// Any whole number.
    x: u32,
) -> u32 {
    let state = x * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}
