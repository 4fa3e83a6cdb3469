//! Whether a kernel's answers may be timed, and how far they are off.

use super::case::Case;
use super::deviation::Deviation;
use super::measures::{Compared, Measures};
use super::reported::Reported;
use super::summary::Accuracy;
use super::surface;
use super::truth::Truth;
use crate::job::Answer;
use crate::oracle::{Exact, Query, condition, excusable, output_error_limit, solve};
use crate::workload::{Ray, Triangle};

/// What was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judgement {
    /// The first difference that rounding does not excuse, in words.
    pub wrong: Option<String>,
    /// Decisions and errors.
    pub accuracy: Accuracy,
}

/// A judgement in the making.
struct Judge {
    reported: Reported,
    measures: Measures,
    wrong: Option<String>,
}

impl Judge {
    fn new(reported: Reported) -> Self {
        Judge { reported, measures: Measures::new(reported), wrong: None }
    }

    fn blame(&mut self, reason: String) {
        self.wrong.get_or_insert(reason);
    }

    /// Looks for outputs of a hit that rounding does not explain.
    fn outputs(&mut self, place: usize, case: &Case<'_>, answer: &Answer, deviation: &Deviation) {
        let reported = self.reported;
        let limits = output_error_limit(&case.condition, reported.unit_roundoff);
        let outputs = [
            ("t", deviation.t, limits[0], reported.t),
            ("u", deviation.u, limits[1], reported.uv),
            ("v", deviation.v, limits[2], reported.uv),
        ];
        for (name, error, limit, _) in outputs.into_iter().filter(|output| output.3) {
            if error.is_nan() || error.abs() > limit {
                self.blame(format!(
                    "item {place}: {name} is off by {:e}, rounding explains {limit:e}",
                    error.abs()
                ));
            }
        }
        if reported.surface
            && let Some(reason) =
                surface::wrong(answer, case.query, case.exact, limits[0], reported)
        {
            self.blame(format!("item {place}: {reason}"));
        }
    }

    fn finish(self) -> Judgement {
        Judgement { wrong: self.wrong, accuracy: self.measures.finish() }
    }
}

/// Judges answers to pairs, one by one.
pub fn judge(answers: &[Answer], truths: &[Truth], reported: Reported) -> Judgement {
    let mut judge = Judge::new(reported);
    for (place, (answer, truth)) in answers.iter().zip(truths).enumerate() {
        let case = Case::from(truth);
        match judge.measures.compare(&case, answer) {
            Compared::Miss | Compared::Differ { excused: true } => {}
            Compared::Hit(deviation) => judge.outputs(place, &case, answer, &deviation),
            Compared::Differ { excused: false } => {
                let word = if answer.triangle.is_some() { "hit" } else { "miss" };
                judge.blame(format!(
                    "item {place}: a {word} where the exact answer is {}",
                    truth.exact.class.name()
                ));
            }
        }
    }
    judge.finish()
}

/// Judges nearest hits. `exact` holds, per ray, the nearest triangle that counts.
pub fn judge_nearest(
    answers: &[Answer],
    exact: &[Option<(usize, Exact)>],
    (rays, triangles): (&[Ray], &[Triangle]),
    reported: Reported,
) -> Judgement {
    let mut judge = Judge::new(reported);
    for (place, (answer, exact)) in answers.iter().zip(exact).enumerate() {
        let ray = &rays[place];
        match (answer.triangle, exact) {
            (None, None) => judge.measures.miss(),
            (Some(found), Some((wanted, exact))) if found == *wanted || !reported.t => {
                let query = Query::of(ray, &triangles[*wanted]);
                let case = case_of(&query, exact);
                let deviation = judge.measures.hit(&case, answer);
                judge.outputs(place, &case, answer, &deviation);
            }
            (_, wanted) => {
                let wanted = wanted.as_ref().map(|(index, _)| *index);
                judge.differing(place, answer, wanted, (ray, triangles));
            }
        }
    }
    judge.finish()
}

/// The face was looked at when the nearest triangle was chosen.
fn case_of<'a>(query: &'a Query, exact: &'a Exact) -> Case<'a> {
    Case { query, exact, condition: condition(query, exact), t_scale: 1.0, front: true }
}

impl Judge {
    /// Takes in a ray whose nearest triangle is another one, and looks for an excuse: the triangle
    /// that was found is a doubtful hit, or the one that was not found is a doubtful miss.
    fn differing(
        &mut self,
        place: usize,
        answer: &Answer,
        wanted: Option<usize>,
        (ray, triangles): (&Ray, &[Triangle]),
    ) {
        let solved = |triangle: Option<usize>| {
            let query = Query::of(ray, triangles.get(triangle?)?);
            Some((query, solve(&query)))
        };
        let (found, missed) = (solved(answer.triangle), solved(wanted));
        let unit_roundoff = self.reported.unit_roundoff;
        let doubtful = |solved: &Option<(Query, Exact)>, accepted: bool| {
            // A right decision about this triangle excuses nothing about the other.
            solved.as_ref().is_some_and(|(query, exact)| {
                accepted != exact.class.is_hit() && excusable(query, exact, unit_roundoff, accepted)
            })
        };
        let excused = doubtful(&found, true) || doubtful(&missed, false);
        let depth = depth_of(&found, &missed);
        self.measures.differ_nearest(answer, wanted.is_some(), depth, excused);
        if !excused {
            let word = |triangle: Option<usize>| triangle.map_or("none".into(), |i| i.to_string());
            self.blame(format!(
                "ray {place}: nearest triangle {}, exactly {}",
                word(answer.triangle),
                word(wanted)
            ));
        }
    }
}

/// Depth of the decision that explains another nearest triangle: the one that was found is exactly
/// no hit; or else the exact one was missed, or lost to it by distance.
fn depth_of(
    found: &Option<(Query, Exact)>,
    missed: &Option<(Query, Exact)>,
) -> (Option<f64>, bool) {
    if let Some((query, exact)) = found
        && !exact.class.is_hit()
    {
        return case_of(query, exact).depth(true);
    }
    let Some((query, exact)) = missed else { return (None, false) };
    let t_max = found.as_ref().map_or(query.t_max, |(_, farther)| farther.t);
    case_of(&Query { t_max, ..*query }, exact).depth(false)
}
