//! Whether the answer of a tracer is right, by the oracle.

use terrane_shaderlib::heightfield::adversary::Case;
use terrane_shaderlib::heightfield::oracle::{Oracle, Time};
use terrane_shaderlib::heightfield::{Heights, Hit};

/// How far a hit may be from the exact one: in lengths of 1 texel or 1 step, and in parts of t.
pub(super) const NEAR: f64 = 1e-12;
/// How much higher or lower, in 2^−32 steps, the ray may be for which the answer is right: 2^−28 steps.
pub(super) const LIFT: i32 = 1 << 4;

/// How an answer is right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// The ray hits there, and not before; or nowhere.
    Exact,
    /// A ray higher or lower by [`LIFT`] has this answer: it almost touches something, or falls so fast that t lacks bits.
    Touch,
}

/// Judges an answer for the case's whole range.
pub(super) fn judge(map: &Heights, case: &Case, hit: Option<Hit>) -> Result<Verdict, String> {
    let end = Time::new(case.end, 1).expect("the generator's ends are small");
    let oracle = Oracle::new(map, case.fixed, end).map_err(|error| error.to_string())?;
    let sides = hit.map(|hit| sides(case, hit.t));
    if answers(&oracle, &oracle, sides, end) {
        return hit.map_or(Ok(()), |hit| same_cell(&oracle, hit)).map(|()| Verdict::Exact);
    }
    let [higher, lower] = [oracle.lifted(LIFT), oracle.lifted(-LIFT)];
    if answers(&higher, &lower, sides, end) {
        Ok(Verdict::Touch)
    } else {
        Err(format!("the oracle: {:?}", oracle.first_cell()))
    }
}

/// Whether the higher ray does not hit before, and the lower one does until then.
fn answers(higher: &Oracle, lower: &Oracle, sides: Option<(Option<Time>, Time)>, end: Time) -> bool {
    match sides {
        None => !higher.crosses_before(end),
        Some((before, after)) => !before.is_some_and(|t| higher.crosses_before(t)) && lower.crosses_before(after),
    }
}

/// The times just before and just after; nothing is before the beginning.
fn sides(case: &Case, t: f64) -> (Option<Time>, Time) {
    let rate = case.ray.direction.into_iter().fold(1e-9, |rate: f64, other| rate.max(other.abs()));
    let near = NEAR / rate + NEAR * t;
    ((t > near).then(|| fraction(t - near, f64::floor)), fraction(t + near, f64::ceil))
}

/// As many bits as a time has.
fn fraction(t: f64, round: fn(f64) -> f64) -> Time {
    let bits = (39 - t.max(1.0).log2() as i32).max(0);
    Time::new(round(t * 2_f64.powi(bits)) as i64, 1 << bits).expect("t 2^bits is below 2^40")
}

/// The oracle's cell, or one beside it if the hit is on the border between them.
fn same_cell(oracle: &Oracle, hit: Hit) -> Result<(), String> {
    let cell = oracle.first_cell().ok_or("no cell")?;
    let same = [0, 1].into_iter().all(|axis| match cell[axis] - hit.cell[axis] {
        0 => true,
        1 => hit.uv[axis] > 1.0 - 1e-6,
        -1 => hit.uv[axis] < 1e-6,
        _ => false,
    });
    if same { Ok(()) } else { Err(format!("the oracle's cell: {cell:?}")) }
}
