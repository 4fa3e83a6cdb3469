//! The interval of a figure, as rows store it.

use super::Row;

/// Columns that have an interval of their own in the same row, or share that of the time.
const WITH_INTERVAL: [&str; 14] = [
    "ratio_to_reference",
    "price",
    "ns_per_test",
    "latency_ns_per_test",
    "cold_ns_per_test",
    "total_cycles_per_ray",
    "prepare_cycles_per_triangle",
    "pays_from_rays",
    "cycles_per_test",
    "seconds",
    "mtests_per_s",
    "build_ms",
    "predicted_ratio",
    "seconds_per_frame",
];

/// Whether figures of a column come with an interval, where enough rounds were measured.
pub fn has_interval(column: &str) -> bool {
    WITH_INTERVAL.contains(&column)
}

/// The interval of the figure `y` of a column. Rows store that of the time and of the ratio; figures that are
/// proportional to the time, or to its inverse, have the same one relatively. `None` where the row
/// stores none.
pub fn interval(row: &Row, column: &str, y: f64) -> Option<(f64, f64)> {
    let (low, high) = match column {
        "ratio_to_reference" => (row.ratio_low?, row.ratio_high?),
        "price" => (row.price_low?, row.price_high?),
        "ns_per_test" => (row.ns_low?, row.ns_high?),
        "latency_ns_per_test" => (row.latency_ns_low?, row.latency_ns_high?),
        "cold_ns_per_test" => (row.cold_ns_low?, row.cold_ns_high?),
        "total_cycles_per_ray" => (row.total_cycles_per_ray_low?, row.total_cycles_per_ray_high?),
        "prepare_cycles_per_triangle" => (row.prepare_cycles_low?, row.prepare_cycles_high?),
        "pays_from_rays" => (row.pays_from_low?, row.pays_from_high?),
        "cycles_per_test" => (row.cycles_low?, row.cycles_high?),
        "build_ms" => (row.build_low?, row.build_high?),
        "predicted_ratio" => (row.predicted_low?, row.predicted_high?),
        "seconds" | "seconds_per_frame" => {
            (y * row.ns_low? / row.ns_per_test?, y * row.ns_high? / row.ns_per_test?)
        }
        "mtests_per_s" => (y * row.ns_per_test? / row.ns_high?, y * row.ns_per_test? / row.ns_low?),
        _ => return None,
    };
    (low.is_finite() && high.is_finite() && low <= high).then_some((low, high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::COLUMNS;

    /// A row whose every numeric column holds 1.
    fn ones() -> Row {
        let mut row = Row::default();
        for column in COLUMNS {
            // Words take anything; they are no figures.
            row.set(column, "1").expect("a number or a word");
        }
        row
    }

    #[test]
    fn a_column_has_an_interval_exactly_if_it_is_listed() {
        let row = ones();
        for column in COLUMNS {
            let found = interval(&row, column, 1.0);
            assert_eq!(found.is_some(), has_interval(column), "{column}");
        }
    }

    #[test]
    fn rates_have_the_interval_of_the_time_the_other_way_round() {
        let row =
            Row { ns_per_test: Some(2.0), ns_low: Some(1.0), ns_high: Some(4.0), ..Row::default() };
        assert_eq!(interval(&row, "mtests_per_s", 500.0), Some((250.0, 1000.0)));
        assert_eq!(interval(&row, "seconds", 10.0), Some((5.0, 20.0)));
        assert_eq!(interval(&Row::default(), "seconds", 10.0), None);
    }

    #[test]
    fn ends_that_are_no_interval_are_none() {
        let row = Row { cycles_low: Some(3.0), cycles_high: Some(2.0), ..Row::default() };
        assert_eq!(interval(&row, "cycles_per_test", 2.5), None);
    }
}
