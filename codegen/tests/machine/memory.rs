//! Variables, arrays, structs and pointers, with indices that differ from lane to lane.

use terrane_codegen::machine::{Accept, Component, F32, Value};

use crate::support::{Random, shader};

const SHUFFLE: &str = "
const TABLE = array<u32, 5>(3u, 1u, 4u, 1u, 5u);
struct Card { value: u32, at: vec2f, next: array<i32, 3> }

fn swap(deck: ptr<function, array<Card, 4>>, a: u32, b: u32) {
    let held = (*deck)[a];
    (*deck)[a] = (*deck)[b];
    (*deck)[b] = held;
}

fn bump(x: ptr<function, u32>, by: u32) { *x += by; }

fn shuffle(seed: u32) -> vec4u {
    var deck: array<Card, 4>;
    for (var i = 0u; i < 4u; i++) {
        deck[i].value = i * 10u;
        deck[i].at = vec2f(f32(i), 0.5);
        deck[i].next[i % 3u] = i32(i) - 2;
    }
    var state = seed;
    for (var i = 0u; i < 6u; i++) {
        state = state * 747796405u + 2891336453u;
        swap(&deck, (state >> 20u) & 3u, (state >> 25u) & 3u);
        deck[(state >> 12u) & 3u].at.y += f32(TABLE[state % 7u]);
        deck[state & 3u].next[(state >> 4u) % 3u] -= 1;
    }
    var m = mat2x2f(1.0, 2.0, 3.0, 4.0);
    m[seed & 1u][(seed >> 1u) & 1u] = 9.0;
    var total = 0u;
    var v = vec4u(1u, 2u, 3u, 4u);
    v[seed % 4u] = 70u;
    let before = total;
    bump(&total, deck[2].value + before);
    total += v.y + u32(m[0].y + m[1][0]);
    return vec4u(total, u32(deck[1].at.y * 2.0), u32(deck[3].next[seed % 3u] + 50), deck[0].value);
}";

#[derive(Clone, Copy, Default)]
struct Card {
    value: u32,
    at: [f32; 2],
    next: [i32; 3],
}

fn shuffle(seed: u32) -> [u32; 4] {
    let table = [3, 1, 4, 1, 5];
    let mut deck = [Card::default(); 4];
    for (i, card) in deck.iter_mut().enumerate() {
        card.value = i as u32 * 10;
        card.at = [i as f32, 0.5];
        card.next[i % 3] = i as i32 - 2;
    }
    let mut state = seed;
    for _ in 0..6 {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        deck.swap((state >> 20) as usize & 3, (state >> 25) as usize & 3);
        // Outside the array, the last element.
        deck[(state >> 12) as usize & 3].at[1] += table[(state as usize % 7).min(4)] as f32;
        deck[state as usize & 3].next[(state >> 4) as usize % 3] -= 1;
    }
    let mut m = [[1.0, 2.0], [3.0, 4.0]];
    m[seed as usize & 1][(seed >> 1) as usize & 1] = 9.0;
    let mut v = [1, 2, 3, 4];
    v[seed as usize % 4] = 70;
    let total = deck[2].value + v[1] + (m[0][1] + m[1][0]) as u32;
    [total, (deck[1].at[1] * 2.0) as u32, (deck[3].next[seed as usize % 3] + 50) as u32, deck[0].value]
}

#[test]
fn arrays_of_structs_are_shuffled_as_in_rust() {
    let mut random = Random::new(13);
    let seeds: Vec<u32> = (0..3000).map(|_| random.bits()).collect();
    let shader = shader(SHUFFLE);
    let result = shader.call::<F32>("shuffle", &[Value::u32(&seeds)], seeds.len());
    let expected: Vec<[u32; 4]> = seeds.iter().map(|seed| shuffle(*seed)).collect();
    for (i, component) in result.components.iter().enumerate() {
        assert_eq!(*component, Component::Int(expected.iter().map(|value| value[i]).collect()), "component {i}");
    }
    let accepted = shader.call::<Accept>("shuffle", &[Value::u32(&seeds)], seeds.len());
    for (point, expected) in expected.iter().enumerate() {
        for (i, expected) in expected.iter().enumerate() {
            let found = accepted.int_at(i, point).expect("an integer");
            assert_eq!(found.values(), Some(&[*expected][..]), "seed {}, component {i}", seeds[point]);
        }
    }
}

/// A load at one mention of a variable must not see a store between it and its use.
#[test]
fn values_are_read_when_they_are_mentioned() {
    let shader = shader(
        "fn f(a: u32) -> vec4u {
            var x = a;
            var y = a * 3u;
            let old = x;
            x = y;
            y = old;
            var v = vec2u(x, y);
            v = v.yx;
            let kept = v;
            for (var i = 0u; i < 2u; i++) {
                v.x += kept.y + i;
                if (i == 1u) { continue; }
                x = v.x + x;
            }
            var z = vec3u(1u, 2u, 3u);
            let p = &z;
            z = z.zxy + *p;
            return vec4u(v, x + kept.x, z.x + z.y * 16u + z.z * 256u);
        }",
    );
    let result = shader.call::<F32>("f", &[Value::u32(&[5, 100])], 2);
    // x = 15, y = 5; v = (5, 15); v.x = 20, x = 35; v.x = 36; z = (4, 3, 5).
    // x = 300, y = 100; v = (100, 300); v.x = 400, x = 700; v.x = 701.
    let z = 4 + 3 * 16 + 5 * 256;
    let columns = [[36, 701], [15, 300], [40, 800], [z, z]];
    assert_eq!(result.components, columns.map(|column| Component::Int(column.to_vec())));
}
