//! How wide the columns of a bar chart are.

use super::bars::{Plan, SERIES_SIZE, VALUE_SIZE};
use super::figure::Figure;
use super::frame::{MARGIN, SMALL};
use super::text;

/// Widths of the columns: category, series, and per panel plot and value labels.
pub(super) struct Widths {
    pub category: f64,
    pub series: f64,
    pub plot: f64,
    pub value: f64,
}

impl Widths {
    pub fn new(figure: &Figure, plan: &Plan) -> Self {
        let lines = plan.groups.iter().flat_map(|group| &group.lines);
        let category = lines.map(|line| text::width(line, SMALL, true)).fold(0.0, f64::max) + 14.0;
        // Where the categories are the series (x and series the same column), one name is enough.
        let shown = plan
            .groups
            .iter()
            .any(|group| group.series.iter().any(|s| plan.series[*s] != group.name));
        let names =
            plan.series.iter().map(|name| text::width(&figure.label(name), SERIES_SIZE, false));
        let series =
            if plan.series.len() > 1 && shown { names.fold(0.0, f64::max) + 12.0 } else { 0.0 };
        let all = plan.ours.iter().chain(&plan.published);
        let value = all
            .map(|point| text::width(&text::figure(point.y), VALUE_SIZE, false))
            .fold(0.0, f64::max)
            + 18.0;
        let plot = [520.0, 320.0, 240.0, 200.0][plan.panels.len().clamp(1, 4) - 1];
        Widths { category, series, plot, value }
    }

    /// Left end of a panel's plot.
    pub fn panel(&self, index: usize) -> f64 {
        MARGIN + self.category + self.series + index as f64 * (self.plot + self.value + 10.0)
    }
}
