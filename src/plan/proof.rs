//! Whether answers are right, ray by ray, and what may be made of that.

use crate::accuracy::{Reported, judge_nearest};
use crate::job::Answer;
use crate::oracle::{Exact, Query, classify, condition, output_error_limit, solve};
use crate::workload::{Ray, Triangle};

/// The exact nearest hit of a ray.
pub type Nearest = Option<(usize, Exact)>;

/// Rays with their exact answers.
pub struct Exactly<'a> {
    /// What is asked.
    pub rays: &'a [Ray],
    /// Of these.
    pub triangles: &'a [Triangle],
    /// Per ray, the nearest triangle of any face.
    pub nearest: Vec<Nearest>,
}

/// What came of the answers of a plan on all rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Answers {
    /// Rays that were asked.
    pub rays: u64,
    /// Answers that are exact, or differ by no more than rounding explains.
    pub agree: u64,
    /// The default variant is right, and the plan is wrong by more than rounding explains.
    pub disagree: u64,
}

/// Which answers are right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// Per ray: exact, or within what rounding explains.
    pub right: Vec<bool>,
    /// Rays that are lost, by their place: they meet a triangle, and nothing is found there or before it.
    pub lost: Vec<usize>,
}

impl Standing {
    /// Rays whose answer is right.
    pub fn agree(&self) -> u64 {
        self.right.iter().filter(|right| **right).count() as u64
    }

    /// Rays whose answer is wrong, by their place.
    pub fn wrong(&self) -> Vec<usize> {
        (0..self.right.len()).filter(|place| !self.right[*place]).collect()
    }

    /// The plan's answers beside those of the default variant.
    pub fn beside(&self, default: &Standing) -> Answers {
        let both = self.right.iter().zip(&default.right);
        Answers {
            rays: self.right.len() as u64,
            agree: self.agree(),
            disagree: both.filter(|(plan, default)| **default && !**plan).count() as u64,
        }
    }
}

impl Exactly<'_> {
    /// Judges one answer a ray. Back faces count even where the form culls: a plan may leave them out
    /// only where that changes nothing.
    pub fn judge(&self, answers: &[Answer], reported: Reported) -> Standing {
        let mut standing = Standing { right: Vec::new(), lost: Vec::new() };
        for (place, answer) in answers.iter().enumerate() {
            let (ray, exact) = (&self.rays[place], &self.nearest[place]);
            standing.right.push(is_right(ray, self.triangles, exact, answer, reported));
            if is_lost(ray, self.triangles, exact, answer, reported) {
                standing.lost.push(place);
            }
        }
        standing
    }
}

/// Whether an answer is right, or rounding explains the difference: as [`judge_nearest`] has it of rays
/// whose nearest triangle is beyond doubt, and two triangles whose exact distances are apart by no more
/// than outputs may err are one as good as the other.
fn is_right(
    ray: &Ray,
    triangles: &[Triangle],
    exact: &Nearest,
    answer: &Answer,
    reported: Reported,
) -> bool {
    let judged = |exact: &Nearest| {
        let (one, rays) = (std::slice::from_ref(exact), std::slice::from_ref(ray));
        let answers = std::slice::from_ref(answer);
        judge_nearest(answers, one, (rays, triangles), reported).wrong.is_none()
    };
    match (answer.triangle, exact) {
        (Some(found), Some((wanted, exact))) if reported.t && found != *wanted => {
            let other = exact_of(ray, &triangles[found]);
            let tie = other.filter(|(query, other)| {
                let one = Query::of(ray, &triangles[*wanted]);
                (other.t - exact.t).abs()
                    <= limit(query, other, reported) + limit(&one, exact, reported)
            });
            // The outputs are those of the triangle that was found.
            match tie {
                Some((_, other)) => judged(&Some((found, other))),
                None => judged(&Some((*wanted, *exact))),
            }
        }
        _ => judged(exact),
    }
}

/// What t may err by.
fn limit(query: &Query, exact: &Exact, reported: Reported) -> f64 {
    output_error_limit(&condition(query, exact), reported.unit_roundoff)[0]
}

/// The exact answer about a triangle that is hit.
fn exact_of(ray: &Ray, triangle: &Triangle) -> Option<(Query, Exact)> {
    let query = Query::of(ray, triangle);
    classify(&query).is_hit().then(|| (query, solve(&query)))
}

/// Whether a ray was lost: it meets a triangle, and what was found is nothing, or behind that.
fn is_lost(
    ray: &Ray,
    triangles: &[Triangle],
    exact: &Nearest,
    answer: &Answer,
    reported: Reported,
) -> bool {
    let Some((wanted, exact)) = exact else { return false };
    match answer.triangle {
        None => true,
        Some(found) if found == *wanted || !reported.t => false,
        Some(found) => exact_of(ray, &triangles[found]).is_some_and(|(query, other)| {
            let one = Query::of(ray, &triangles[*wanted]);
            other.t - exact.t > limit(&query, &other, reported) + limit(&one, exact, reported)
        }),
    }
}

/// Whether a ray hits two of the triangles at distances that are apart by no more than outputs may err.
pub fn has_ties(ray: &Ray, triangles: &[Triangle], reported: Reported) -> bool {
    let hits = triangles.iter().filter_map(|triangle| exact_of(ray, triangle));
    let mut reach: Vec<(f64, f64)> =
        hits.map(|(query, exact)| (exact.t, limit(&query, &exact, reported))).collect();
    reach.sort_by(|a, b| a.0.total_cmp(&b.0));
    reach.windows(2).any(|two| two[1].0 - two[0].0 <= two[0].1 + two[1].1)
}
