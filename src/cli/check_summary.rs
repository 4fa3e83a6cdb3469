//! What `check` says at the end: a line per kernel and precision.

use serde_json::json;

use super::check_rows::short;
use super::show::{Sheet, text};
use crate::check::{Judged, Precision, Verdict};

/// Counts of one kernel in one precision.
struct Counts {
    kernel: String,
    precision: Precision,
    hits: u64,
    verdicts: [u64; 4],
    non_finite: u64,
    worst: [Option<f64>; 2],
}

/// Counts of all, in the order in which they first came.
#[derive(Default)]
pub struct Summary {
    counts: Vec<Counts>,
    /// Where the last row went: rows come in the same order case after case.
    last: usize,
}

impl Summary {
    /// Counts a row.
    pub fn add(&mut self, kernel: &str, precision: Precision, judged: &Judged) {
        let place = self.place(kernel, precision);
        let counts = &mut self.counts[place];
        counts.hits += u64::from(judged.hit);
        counts.verdicts[judged.verdict as usize] += 1;
        counts.non_finite += u64::from(judged.non_finite.contains(&true));
        let errors = [judged.errors_ulp[0], judged.barycentric_error];
        for (worst, error) in counts.worst.iter_mut().zip(errors) {
            // No error is less than some error.
            *worst = if error > *worst { error } else { *worst };
        }
        self.last = place;
    }

    fn place(&mut self, kernel: &str, precision: Precision) -> usize {
        let number = self.counts.len();
        let fits = |place: &usize| {
            self.counts[*place].kernel == kernel && self.counts[*place].precision == precision
        };
        let found = (0..number).map(|step| (self.last + 1 + step) % number).find(fits);
        found.unwrap_or_else(|| {
            let (hits, verdicts, non_finite, worst) = (0, [0; 4], 0, [None; 2]);
            let kernel = kernel.to_owned();
            self.counts.push(Counts { kernel, precision, hits, verdicts, non_finite, worst });
            number
        })
    }

    /// The table.
    pub fn text(&self) -> String {
        let columns = vec![
            "kernel",
            "precision",
            "hits",
            "agree",
            "false_hits",
            "false_misses",
            "undefined",
            "non_finite",
            "err_t_max_ulp",
            "err_barycentric_max_abs",
        ];
        let row = |counts: &Counts| {
            let of = |verdict: Verdict| json!(counts.verdicts[verdict as usize]);
            let worst = |place: usize| json!(counts.worst[place].map(short).unwrap_or("-".into()));
            vec![
                json!(counts.kernel),
                json!(counts.precision.name()),
                json!(counts.hits),
                of(Verdict::Agree),
                of(Verdict::FalseHit),
                of(Verdict::FalseMiss),
                of(Verdict::Undefined),
                json!(counts.non_finite),
                worst(0),
                worst(1),
            ]
        };
        text(&Sheet { columns, rows: self.counts.iter().map(row).collect() })
    }
}
