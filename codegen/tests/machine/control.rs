//! Control flow under diverging lanes, against the same programs in Rust.

use terrane_codegen::machine::{Component, F32, Value};

use crate::support::shader;

const MAZE: &str = "
fn visit(n: u32, total: ptr<function, u32>) -> u32 {
    *total += n * 3u;
    if ((n & 4u) != 0u) { return *total; }
    *total ^= 5u;
    return n + 1u;
}

fn maze(seed: u32) -> u32 {
    var state = seed;
    var total = 0u;
    for (var i = 0u; i < 40u; i++) {
        state = state * 747796405u + 2891336453u;
        let pick = (state >> 16u) % 11u;
        switch (pick) {
            case 0u: { continue; }
            case 1u, 2u: { total += 7u; break; }
            case 3u: { if (i > 20u) { return total; } }
            default: { total = total * 5u + pick; }
        }
        var j = 0u;
        loop {
            if (j > pick) { break; }
            if ((total & 1u) == 0u && j > 3u || pick == 9u) { total += 1u; break; }
            if (((total >> 3u) & 1u) == 1u) { j++; continue; }
            total += visit(j + i, &total);
            if (total % 1009u == 0u) { return total + 100000u; }
            continuing {
                j += 1u;
                break if total > 4000000000u;
            }
        }
    }
    return total;
}";

fn visit(n: u32, total: &mut u32) -> u32 {
    *total = total.wrapping_add(n.wrapping_mul(3));
    if n & 4 != 0 {
        return *total;
    }
    *total ^= 5;
    n.wrapping_add(1)
}

fn maze(seed: u32) -> u32 {
    let mut state = seed;
    let mut total = 0_u32;
    for i in 0..40_u32 {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let pick = (state >> 16) % 11;
        match pick {
            0 => continue,
            1 | 2 => total = total.wrapping_add(7),
            3 => {
                if i > 20 {
                    return total;
                }
            }
            _ => total = total.wrapping_mul(5).wrapping_add(pick),
        }
        let mut j = 0;
        loop {
            if j > pick {
                break;
            }
            if total & 1 == 0 && j > 3 || pick == 9 {
                total = total.wrapping_add(1);
                break;
            }
            if (total >> 3) & 1 == 1 {
                j += 1;
            } else {
                // WGSL reads the left side of `+=` before it evaluates the right one.
                let before = total;
                total = before.wrapping_add(visit(j + i, &mut total));
                if total.is_multiple_of(1009) {
                    return total.wrapping_add(100_000);
                }
            }
            j += 1;
            if total > 4_000_000_000 {
                break;
            }
        }
    }
    total
}

#[test]
fn a_maze_of_jumps_takes_every_lane_where_rust_goes() {
    let seeds: Vec<u32> = (0..5000).map(|i: u32| i.wrapping_mul(2_654_435_761)).collect();
    let result = shader(MAZE).call::<F32>("maze", &[Value::u32(&seeds)], seeds.len());
    let expected: Vec<u32> = seeds.iter().map(|seed| maze(*seed)).collect();
    assert_eq!(result.components, [Component::Int(expected)]);
}
