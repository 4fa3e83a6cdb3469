//! An answer held against the exact one.

use super::known::{Known, Place};
use super::reply::Reply;

/// Whether a decision is right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// A hit where the exact answer is one, or a miss where it is one; edges and vertices are hits.
    Agree,
    /// A hit where the exact answer is a miss.
    FalseHit,
    /// A miss where the exact answer is a hit.
    FalseMiss,
    /// The input is not finite.
    Undefined,
}

impl Verdict {
    /// The word of the column `verdict`.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Agree => "agree",
            Verdict::FalseHit => "false-hit",
            Verdict::FalseMiss => "false-miss",
            Verdict::Undefined => "undefined",
        }
    }
}

/// An answer, its verdict and its errors. Every number here is finite: what is not is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// The answer's decision.
    pub hit: bool,
    /// The answer's t, u, v; of hits only.
    pub values: [Option<f64>; 3],
    /// Whether the decision is right.
    pub verdict: Verdict,
    /// Errors of t, u, v where both are hits, in units in the last place of the precision: of the
    /// *exact* t, and of 1 for u and v, which are shares of 1 and no harder to use near 0.
    pub errors_ulp: [Option<f64>; 3],
    /// Largest error of the weights of a, b and c, absolute: what stays small where u or v is 0.
    pub barycentric_error: Option<f64>,
    /// Which of t, u, v a hit reports as NaN or infinite.
    pub non_finite: [bool; 3],
}

impl Judged {
    /// Judges an answer to what is known.
    pub fn of(reply: &Reply, known: &Known) -> Self {
        let given = [reply.t, reply.u, reply.v].map(|x| x.filter(|_| reply.hit));
        let values = given.map(|x| x.filter(|x| x.is_finite()));
        let is_hit = known.place.is_hit();
        let rounded = known.rounded();
        let errors: [Option<f64>; 3] = std::array::from_fn(|i| {
            let (exact, rest) = rounded[i];
            finite((values[i].filter(|_| is_hit)? - exact) - rest)
        });
        Judged {
            hit: reply.hit,
            values,
            verdict: verdict(reply.hit, known.place),
            errors_ulp: std::array::from_fn(|i| {
                let (exact, rest) = if i == 0 { rounded[0] } else { (1.0, 0.0) };
                finite(errors[i]?.abs() / known.precision.ulp(exact, rest))
            }),
            barycentric_error: barycentric(errors),
            non_finite: std::array::from_fn(|i| given[i].is_some() && values[i].is_none()),
        }
    }

    /// The column `non_finite`: the names of such outputs; nothing if there are none.
    pub fn non_finite_names(&self) -> &'static str {
        const NAMES: [&str; 8] = ["", "t", "u", "t u", "v", "t v", "u v", "t u v"];
        let bit = |place: usize| usize::from(self.non_finite[place]) << place;
        NAMES[bit(0) | bit(1) | bit(2)]
    }
}

fn verdict(hit: bool, place: Place) -> Verdict {
    match (hit, place.is_hit()) {
        _ if place == Place::NotFinite => Verdict::Undefined,
        (true, false) => Verdict::FalseHit,
        (false, true) => Verdict::FalseMiss,
        _ => Verdict::Agree,
    }
}

/// The weight of a is what the other two leave of 1, so its error is that of their sum.
fn barycentric([_, u, v]: [Option<f64>; 3]) -> Option<f64> {
    let (u, v) = (u?, v?);
    finite(u.abs().max(v.abs()).max((u + v).abs()))
}

fn finite(x: f64) -> Option<f64> {
    Some(x).filter(|x| x.is_finite())
}
