//! All measures of a variant's answers to many cases.
//!
//! Decisions are counted, errors of hits are collected and summed up at the end, so that it does
//! not matter how the cases were split between threads.

use super::case::Case;
use super::deviation::Deviation;
use super::reported::Reported;
use super::samples::Samples;
use super::summary::Accuracy;
use super::truth::Truth;
use crate::job::Answer;
use crate::number::Precision;

/// Collects answers.
#[derive(Clone, Debug)]
pub struct Measures {
    reported: Reported,
    precision: Precision,
    counts: Counts,
    samples: Samples,
}

#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    cases: u64,
    exact_hits: u64,
    compared: u64,
    boundary_cases: u64,
    false_hits: u64,
    false_misses: u64,
    deep_false_hits: u64,
    deep_false_misses: u64,
    inexcusable: u64,
    non_finite: u64,
    worst_depth: Option<f64>,
}

/// How an answer compares with the exact one.
#[derive(Clone, Copy, Debug)]
pub(super) enum Compared {
    /// Both are misses.
    Miss,
    /// Both are hits.
    Hit(Deviation),
    /// They differ.
    Differ { excused: bool },
}

impl Measures {
    /// None yet.
    pub fn new(reported: Reported) -> Self {
        let precision = Precision::of_unit_roundoff(reported.unit_roundoff);
        Measures { reported, precision, counts: Counts::default(), samples: Samples::default() }
    }

    /// Takes in the answer to one case.
    pub fn add(&mut self, truth: &Truth, answer: &Answer) {
        self.compare(&Case::from(truth), answer);
    }

    pub(super) fn compare(&mut self, case: &Case<'_>, answer: &Answer) -> Compared {
        let accepted = answer.triangle.is_some();
        match (accepted, case.wanted(self.reported)) {
            (false, false) => {
                self.miss();
                Compared::Miss
            }
            (true, true) => Compared::Hit(self.hit(case, answer)),
            _ => Compared::Differ { excused: self.differ(case, answer) },
        }
    }

    /// Takes in a miss that is one.
    pub(super) fn miss(&mut self) {
        self.counts.cases += 1;
    }

    /// Takes in a hit that is one.
    pub(super) fn hit(&mut self, case: &Case<'_>, answer: &Answer) -> Deviation {
        self.counts.cases += 1;
        self.counts.exact_hits += 1;
        self.count_finite(answer);
        let deviation = Deviation::of(case, answer);
        if case.is_boundary() {
            self.counts.boundary_cases += 1;
        } else {
            self.counts.compared += 1;
            self.samples.take(case, answer, &deviation, (self.reported, self.precision));
        }
        deviation
    }

    /// Takes in a decision that differs; whether rounding explains it.
    fn differ(&mut self, case: &Case<'_>, answer: &Answer) -> bool {
        let accepted = answer.triangle.is_some();
        self.counts.cases += 1;
        if case.exact.class.is_hit() {
            self.counts.exact_hits += 1;
        }
        self.count_finite(answer);
        if case.wanted(self.reported) && case.is_boundary() {
            self.counts.boundary_cases += 1;
            return true;
        }
        let excused = case.is_excused(self.reported, accepted);
        self.count_wrong(accepted, case.depth(accepted), excused);
        excused
    }

    /// Takes in a nearest hit of another triangle than the exact one, or of one instead of none.
    /// `depth` is that of the decision about the triangle that explains it.
    pub(super) fn differ_nearest(
        &mut self,
        answer: &Answer,
        is_hit: bool,
        depth: (Option<f64>, bool),
        excused: bool,
    ) {
        self.counts.cases += 1;
        self.counts.exact_hits += u64::from(is_hit);
        self.count_finite(answer);
        self.count_wrong(answer.triangle.is_some(), depth, excused);
    }

    fn count_wrong(
        &mut self,
        accepted: bool,
        (depth, deep): (Option<f64>, bool),
        is_excused: bool,
    ) {
        let counts = &mut self.counts;
        let (all, deep_ones) = if accepted {
            (&mut counts.false_hits, &mut counts.deep_false_hits)
        } else {
            (&mut counts.false_misses, &mut counts.deep_false_misses)
        };
        *all += 1;
        *deep_ones += u64::from(deep);
        counts.inexcusable += u64::from(!is_excused);
        counts.worst_depth = worse(counts.worst_depth, depth);
    }

    fn count_finite(&mut self, answer: &Answer) {
        let reported = self.reported;
        let finite = (!reported.t || answer.t.is_finite())
            && (!reported.uv || (answer.u.is_finite() && answer.v.is_finite()));
        self.counts.non_finite += u64::from(answer.triangle.is_some() && !finite);
    }

    /// Takes in what another one of the same form has collected. However cases are split, and in
    /// whatever order the parts are merged, the result is the same to the bit.
    pub fn merge(&mut self, other: Measures) {
        self.counts.add(&other.counts);
        self.samples.append(other.samples);
    }

    /// Sums up.
    pub fn finish(self) -> Accuracy {
        let counts = self.counts;
        let accuracy = Accuracy {
            cases: counts.cases,
            exact_hits: counts.exact_hits,
            compared: counts.compared,
            boundary_cases: counts.boundary_cases,
            false_hits: counts.false_hits,
            false_misses: counts.false_misses,
            deep_false_hits: counts.deep_false_hits,
            deep_false_misses: counts.deep_false_misses,
            inexcusable: counts.inexcusable,
            worst_depth: counts.worst_depth,
            non_finite: counts.non_finite,
            ..Accuracy::default()
        };
        self.samples.sum_up(accuracy)
    }
}

impl Counts {
    fn add(&mut self, other: &Counts) {
        self.cases += other.cases;
        self.exact_hits += other.exact_hits;
        self.compared += other.compared;
        self.boundary_cases += other.boundary_cases;
        self.false_hits += other.false_hits;
        self.false_misses += other.false_misses;
        self.deep_false_hits += other.deep_false_hits;
        self.deep_false_misses += other.deep_false_misses;
        self.inexcusable += other.inexcusable;
        self.non_finite += other.non_finite;
        self.worst_depth = worse(self.worst_depth, other.worst_depth);
    }
}

fn worse(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.into_iter().chain(b).reduce(f64::max)
}
