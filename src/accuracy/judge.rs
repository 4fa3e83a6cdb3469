//! Whether a kernel's answers may be timed, and how far they are off.

use super::surface;
use super::truth::Truth;
use crate::job::Answer;
use crate::oracle::{Exact, Query, condition, excusable, output_error_limit};
use crate::workload::{Ray, Triangle};

/// What a form reports, and how it rounds.
#[derive(Clone, Copy, Debug)]
pub struct Reported {
    /// 2^-24 or 2^-53.
    pub unit_roundoff: f64,
    /// t is reported.
    pub t: bool,
    /// u and v are.
    pub uv: bool,
    /// The point and the normal are.
    pub surface: bool,
    /// Back faces are no hits.
    pub culls: bool,
}

/// What was found. Boundary cases do not occur in timed workloads, so every difference counts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judgement {
    /// Hits where the exact answer is a miss, or another triangle.
    pub false_hits: u64,
    /// Misses where the exact answer is a hit.
    pub false_misses: u64,
    /// Hits with an output that is not finite.
    pub non_finite: u64,
    /// The first difference that rounding does not excuse, in words.
    pub wrong: Option<String>,
    /// Mean of |t - exact| / |exact| over the hits.
    pub t_mean_relative: Option<f64>,
    /// Largest |t - exact| in units in the last place of the precision.
    pub t_max_ulp: Option<f64>,
    /// The error of t that one hit in a thousand exceeds, in the same units.
    pub t_p999_ulp: Option<f64>,
    /// Largest |u - exact|.
    pub u_max: Option<f64>,
    /// Largest |v - exact|.
    pub v_max: Option<f64>,
    hits: u64,
    t_sum: f64,
    t_ulps: Vec<f64>,
}

impl Judgement {
    fn blame(&mut self, reason: String) {
        if self.wrong.is_none() {
            self.wrong = Some(reason);
        }
    }

    /// Takes in the outputs of a hit that is one.
    fn outputs(&mut self, place: usize, answer: &Answer, exact: &Known<'_>, reported: Reported) {
        let limits = output_error_limit(&exact.condition, reported.unit_roundoff);
        let t = (answer.t / exact.t_scale - exact.exact.t) - exact.exact.t_lo;
        let u = (answer.u - exact.exact.u) - exact.exact.u_lo;
        let v = (answer.v - exact.exact.v) - exact.exact.v_lo;
        let outputs = [
            ("t", t, limits[0], reported.t),
            ("u", u, limits[1], reported.uv),
            ("v", v, limits[2], reported.uv),
        ];
        for (name, error, limit, _) in outputs.into_iter().filter(|output| output.3) {
            if !error.is_finite() {
                self.non_finite += 1;
            }
            if error.is_nan() || error.abs() > limit {
                self.blame(format!(
                    "item {place}: {name} is off by {:e}, rounding explains {limit:e}",
                    error.abs()
                ));
            }
        }
        if reported.surface
            && let Some(reason) =
                surface::wrong(answer, exact.query, exact.exact, limits[0], reported)
        {
            self.blame(format!("item {place}: {reason}"));
        }
        self.hits += 1;
        if reported.t && t.is_finite() {
            self.t_sum += (t / exact.exact.t).abs();
            let ulp = exact.exact.t.abs() * 2.0 * reported.unit_roundoff;
            self.t_ulps.push((t / binade(ulp)).abs());
        }
        if reported.uv && u.is_finite() && v.is_finite() {
            self.u_max = larger(self.u_max, u.abs());
            self.v_max = larger(self.v_max, v.abs());
        }
    }

    fn finished(mut self, reported: Reported) -> Self {
        if reported.t && self.hits > 0 {
            self.t_mean_relative = Some(self.t_sum / self.hits as f64);
            self.t_ulps.sort_by(f64::total_cmp);
            let last = self.t_ulps.len().saturating_sub(1);
            self.t_max_ulp = self.t_ulps.last().copied();
            self.t_p999_ulp = self.t_ulps.get((last as f64 * 0.999).round() as usize).copied();
        }
        self
    }
}

fn larger(so_far: Option<f64>, value: f64) -> Option<f64> {
    Some(so_far.map_or(value, |old| old.max(value)))
}

/// The power of two at or below `x`.
fn binade(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & (0x7ff << 52))
}

/// An exact hit, as outputs are compared with it.
struct Known<'a> {
    query: &'a Query,
    exact: &'a Exact,
    condition: crate::oracle::Condition,
    t_scale: f64,
}

/// Judges answers to pairs, one by one.
pub fn judge(answers: &[Answer], truths: &[Truth], reported: Reported) -> Judgement {
    let mut judgement = Judgement::default();
    for (place, (answer, truth)) in answers.iter().zip(truths).enumerate() {
        let accepted = answer.triangle.is_some();
        let wanted = truth.exact.class.is_hit() && (truth.front || !reported.culls);
        match (accepted, wanted) {
            (true, true) => {
                let known = Known {
                    query: &truth.query,
                    exact: &truth.exact,
                    condition: truth.condition,
                    t_scale: truth.t_scale,
                };
                judgement.outputs(place, answer, &known, reported);
            }
            (false, false) => {}
            (true, false) => judgement.false_hits += 1,
            (false, true) => judgement.false_misses += 1,
        }
        let decides_face = truth.exact.class.is_hit() != wanted;
        let excused = !decides_face
            && excusable(&truth.query, &truth.exact, reported.unit_roundoff, accepted);
        if accepted != wanted && !excused {
            let word = if accepted { "hit" } else { "miss" };
            judgement.blame(format!(
                "item {place}: a {word} where the exact answer is {}",
                truth.exact.class.name()
            ));
        }
    }
    judgement.finished(reported)
}

/// Judges nearest hits. `exact` holds, per ray, the nearest triangle that counts.
pub fn judge_nearest(
    answers: &[Answer],
    exact: &[Option<(usize, Exact)>],
    (rays, triangles): (&[Ray], &[Triangle]),
    reported: Reported,
) -> Judgement {
    let mut judgement = Judgement::default();
    for (place, (answer, exact)) in answers.iter().zip(exact).enumerate() {
        let ray = &rays[place];
        match (answer.triangle, exact) {
            (None, None) => {}
            (Some(found), Some((wanted, exact))) if found == *wanted || !reported.t => {
                let query = Query::of(ray, &triangles[*wanted]);
                let condition = condition(&query, exact);
                let known = Known { query: &query, exact, condition, t_scale: 1.0 };
                judgement.outputs(place, answer, &known, reported);
            }
            (found, wanted) => {
                let wanted = wanted.as_ref().map(|(index, _)| *index);
                differing(&mut judgement, place, (found, wanted), (ray, triangles), reported);
            }
        }
    }
    judgement.finished(reported)
}

/// Counts a ray whose nearest triangle is another one, and looks for an excuse: the triangle that
/// was found is a doubtful hit, or the one that was not found is a doubtful miss.
fn differing(
    judgement: &mut Judgement,
    place: usize,
    (found, wanted): (Option<usize>, Option<usize>),
    (ray, triangles): (&Ray, &[Triangle]),
    reported: Reported,
) {
    let doubtful = |triangle: Option<usize>, accepted: bool| {
        triangle.and_then(|index| triangles.get(index)).is_some_and(|triangle| {
            let query = Query::of(ray, triangle);
            let exact = crate::oracle::solve(&query);
            // A right decision about this triangle excuses nothing about the other.
            accepted != exact.class.is_hit()
                && excusable(&query, &exact, reported.unit_roundoff, accepted)
        })
    };
    match found {
        Some(_) => judgement.false_hits += 1,
        None => judgement.false_misses += 1,
    }
    if !doubtful(found, true) && !doubtful(wanted, false) {
        let word = |triangle: Option<usize>| triangle.map_or("none".into(), |i| i.to_string());
        judgement.blame(format!(
            "ray {place}: nearest triangle {}, exactly {}",
            word(found),
            word(wanted)
        ));
    }
}
