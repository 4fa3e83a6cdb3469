//! What a kernel, or somebody else's program, says of a case.

use super::known::Known;
use crate::registry::Asked;

/// An answer to a case. Values may be anything, and mean nothing without a hit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reply {
    /// The triangle is hit.
    pub hit: bool,
    /// Distance in units of the direction, where it is reported.
    pub t: Option<f64>,
    /// Weight of b.
    pub u: Option<f64>,
    /// Weight of c.
    pub v: Option<f64>,
}

impl Reply {
    /// What a form of a kernel says. It must be a form of the precision of `known`, and `known`
    /// that of the segment where the form [answers for one](Asked::is_segment).
    pub fn of(form: &Asked, known: &Known) -> Self {
        let answer = (form.ask)(&known.query);
        let weights = form.axes.output != "t";
        Reply {
            hit: answer.triangle.is_some(),
            t: Some(answer.t * known.unit),
            u: weights.then_some(answer.u),
            v: weights.then_some(answer.v),
        }
    }
}
