//! Which keys of a figure its kind of chart looks at.

use super::ChartError;
use super::figure::{Figure, Kind, Scale, Within};

impl Figure {
    /// Refuses a key that the kind of chart does not look at: it would be silently without effect.
    pub(super) fn validate_use(&self) -> Result<(), ChartError> {
        use Kind::{Bars, Heat, Lines, Precision, Shares};
        let uses: [(&'static str, bool, &[Kind]); 20] = [
            ("envelope", self.envelope.is_some(), &[Lines]),
            ("bound", self.bound.is_some(), &[Bars]),
            ("shown", self.shown.is_some(), &[Heat]),
            ("apart", self.apart.is_some(), &[Heat]),
            ("also", !self.also.is_empty(), &[Bars, Lines]),
            ("x", !self.x.list().is_empty(), &[Lines, Bars, Shares, Precision, Heat]),
            ("y", !self.y.is_empty(), &[Lines, Bars, Shares, Precision, Heat]),
            ("y_below", self.y_below.is_some(), &[Shares]),
            ("y_below_title", self.y_below_title.is_some(), &[Shares]),
            ("panels", self.panels.is_some(), &[Lines, Bars, Precision]),
            ("over", self.over.is_some(), &[Lines, Bars]),
            ("scale", self.scale == Scale::Log, &[Lines, Bars]),
            ("x_scale", self.x_scale == Scale::Log, &[Lines]),
            ("x_marks", !self.x_marks.list().is_empty(), &[Lines]),
            ("normalise_to", self.normalise_to.is_some(), &[Lines, Bars, Shares]),
            ("normalise", self.normalise == Within::X, &[Bars]),
            ("reference", self.reference.is_some(), &[Lines, Bars]),
            ("x_low", self.x_low.is_some(), &[Precision]),
            ("x_high", self.x_high.is_some(), &[Precision]),
            ("errors_from", !self.errors_from.is_empty(), &[Precision]),
        ];
        if self.normalise == Within::X && self.normalise_to.is_none() {
            return Err(self.wrong("normalise", "x", "x with normalise_to"));
        }
        let unused = uses.iter().find(|(_, set, kinds)| *set && !kinds.contains(&self.kind));
        unused.map_or(Ok(()), |(key, _, kinds)| {
            let kind = format!("kind {:?}", self.kind).to_lowercase();
            Err(self.wrong(key, &kind, &format!("{key} with kind {kinds:?}").to_lowercase()))
        })
    }
}
