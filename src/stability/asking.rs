//! What a kernel says of the cases of one setting.

use super::family::Case;
use crate::accuracy::{Accuracy, Measures, Reported};
use crate::job::Answer;
use crate::oracle::Query;

/// What a kernel did at a setting.
pub struct Found {
    /// Against the exact answers.
    pub accuracy: Accuracy,
    /// Hits that it reported.
    pub hits: u64,
    /// Hits among the cases whose input is not finite.
    pub hits_of_nothing: u64,
}

/// Asks about every case, or, with `is_segment`, about the segment of every case that has one.
pub fn found(
    ask: fn(&Query) -> Answer,
    is_segment: bool,
    reported: Reported,
    cases: &[Case],
) -> Found {
    let mut measures = Measures::new(reported);
    let (mut hits, mut hits_of_nothing) = (0, 0);
    for case in cases {
        let truth = if is_segment { case.segment.as_ref() } else { Some(&case.truth) };
        let Some(truth) = truth else { continue };
        let answer = ask(&truth.query);
        let hit = answer.triangle.is_some();
        hits += u64::from(hit);
        hits_of_nothing += u64::from(hit && !truth.query.is_finite());
        measures.add(truth, &answer);
    }
    Found { accuracy: measures.finish(), hits, hits_of_nothing }
}
