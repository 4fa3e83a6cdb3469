//! One case with its exact answer, and what a decision about it is worth.

use super::reported::Reported;
use super::truth::Truth;
use crate::oracle::{Class, Condition, Exact, Query, excusable};

/// A decision is deep in the wrong when a weight is beyond its bound by at least this.
const DEEP_WEIGHT: f64 = 0.01;
/// Or t by at least this share of its range.
const DEEP_SHARE_OF_RANGE: f64 = 1e-4;

/// What an answer is compared with.
#[derive(Clone, Copy)]
pub(super) struct Case<'a> {
    pub query: &'a Query,
    pub exact: &'a Exact,
    pub condition: Condition,
    /// As in [`Truth`].
    pub t_scale: f64,
    pub front: bool,
}

impl<'a> From<&'a Truth> for Case<'a> {
    fn from(truth: &'a Truth) -> Self {
        Case {
            query: &truth.query,
            exact: &truth.exact,
            condition: truth.condition,
            t_scale: truth.t_scale,
            front: truth.front,
        }
    }
}

impl Case<'_> {
    /// Whether a form should report a hit.
    pub fn wanted(&self, reported: Reported) -> bool {
        self.exact.class.is_hit() && (self.front || !reported.culls)
    }

    /// Whether it is exactly on an edge, at a vertex, or at the end of the range: closed, and so a
    /// hit, but of one triangle by itself either answer is as good.
    pub fn is_boundary(&self) -> bool {
        let (query, exact) = (self.query, self.exact);
        let at = |bound: f64| exact.t == bound && exact.t_lo == 0.0;
        match exact.class {
            Class::Edge | Class::Vertex => true,
            Class::Interior => at(query.t_min) || at(query.t_max),
            _ => false,
        }
    }

    /// Whether rounding explains a wrong decision. None explains that a back face is shown.
    pub fn is_excused(&self, reported: Reported, accepted: bool) -> bool {
        let by_face = self.exact.class.is_hit() != self.wanted(reported);
        !by_face && excusable(self.query, self.exact, reported.unit_roundoff, accepted)
    }

    /// How far a wrong decision is from the right one, and whether that is deep.
    ///
    /// Margins are the smallest weight, and the distance of t from the nearer end of its range over
    /// the length of the range; both are negative outside. A range that reaches beyond the triangle
    /// is as long as the way to its farthest vertex. A false miss is as deep as its smaller margin,
    /// a false hit as its larger excess. Where line and plane meet in no point there is no depth.
    pub fn depth(&self, accepted: bool) -> (Option<f64>, bool) {
        let (query, exact) = (self.query, self.exact);
        let weight = exact.u.min(exact.v).min(exact.w);
        let span = (query.t_max - query.t_min).min(self.reach());
        let nearer = (exact.t - query.t_min).min(query.t_max - exact.t);
        let share = if span > 0.0 { nearer / span } else { 0.0 };
        let (depth, deep) = if accepted {
            let deep = weight <= -DEEP_WEIGHT || share <= -DEEP_SHARE_OF_RANGE;
            ((-weight).max(-share), deep)
        } else {
            (weight.min(share), weight >= DEEP_WEIGHT && share >= DEEP_SHARE_OF_RANGE)
        };
        let known = exact.t.is_finite() && depth.is_finite();
        (known.then(|| depth.max(0.0)), known && deep)
    }

    /// t at which a ray straight to the farthest vertex would be there (largest components, so that
    /// no square leaves the range).
    fn reach(&self) -> f64 {
        let largest = |x: [f64; 3]| x.into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let from = |p: &[f64; 3]| std::array::from_fn(|i| p[i] - self.query.origin[i]);
        let farthest = self.query.triangle.iter().map(|p| largest(from(p))).fold(0.0, f64::max);
        farthest / largest(self.query.direction)
    }
}
