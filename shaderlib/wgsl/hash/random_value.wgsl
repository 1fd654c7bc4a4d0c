//! A random number from a whole one: to vary copies by their index.
//! Source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020 (pcg).

/// random_value(0u) == 0.03019994 +- 1e-6
/// random_value(1u) == 0.65916312 +- 1e-6
/// -> Every value is equally likely. 0..1
fn random_value(
    /// Any whole number. 0..65535
    index: u32,
) -> f32 {
    return hash_unit(pcg(index));
}
