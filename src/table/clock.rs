//! Which columns the clock fills in.

use super::{COLUMNS, Cell, Row};

/// Columns whose values depend on when and where they were measured. All others but `status` and
/// `reason` ([`Row::without_clock`]) are the same in every run of a program on a workload.
pub const CLOCK_COLUMNS: &[&str] = &[
    "ns_per_test",
    "ns_low",
    "ns_high",
    "min_ns",
    "mtests_per_s",
    "cycles_per_test",
    "cycles_source",
    "cycles_low",
    "cycles_high",
    "cycles_first_half",
    "cycles_second_half",
    "rounds",
    "dirty_rounds",
    "ratio_to_reference",
    "ratio_low",
    "ratio_high",
    "ratio_first_half",
    "ratio_second_half",
    "ratio_placebo",
    "instructions_per_test",
    "mispredicts_per_test",
    "seconds",
    "percent_slower",
    "seconds_mean",
    "price",
    "price_low",
    "price_high",
    "empty_loop_share",
    "verdict",
    "p_value",
    "noise_floor",
    "more_rounds",
    "solo_ratio",
    "crowded_share",
    "latency_ns_per_test",
    "latency_ns_low",
    "latency_ns_high",
    "latency_cycles_per_test",
    "latency_ratio_to_reference",
    "latency_ratio_low",
    "latency_ratio_high",
    "latency_floor_ns",
    "cold_ns_per_test",
    "cold_ns_low",
    "cold_ns_high",
    "cold_ratio_to_reference",
    "cold_ratio_low",
    "cold_ratio_high",
    "cold_floor_ns",
    "bound_cycles_per_test",
    "bound_resource",
    "bound_fraction",
    "l1_bytes",
    "l2_bytes",
    "l3_bytes",
    "prepare_ns_per_triangle",
    "prepare_ns_low",
    "prepare_ns_high",
    "prepare_cycles_per_triangle",
    "prepare_cycles_low",
    "prepare_cycles_high",
    "pays_from_rays",
    "pays_from_low",
    "pays_from_high",
    "total_cycles_per_triangle",
    "total_cycles_per_ray",
    "total_cycles_per_ray_low",
    "total_cycles_per_ray_high",
    "build_ms",
    "build_low",
    "build_high",
    "build_pays_rays",
    "predicted_ratio",
    "predicted_low",
    "predicted_high",
    "pays_as_predicted",
    "growth",
    "pays_triangles",
    "pays_triangles_built",
    "seconds_per_frame",
    "frames_per_s",
    "intersection_percent",
];

/// Statuses that were given before anything was timed.
const CLOCK_FREE_STATUSES: [&str; 2] = ["skipped", "wrong-result"];

impl Row {
    /// The same row without what depends on the clock: what two runs must agree on. Whether it was
    /// timed well, and why not, goes too; that it was not to be timed stays.
    pub fn without_clock(&self) -> Row {
        let mut row = self.clone();
        for column in CLOCK_COLUMNS {
            // Nothing is allowed in each of them.
            row.set(column, "").ok();
        }
        if !CLOCK_FREE_STATUSES.contains(&row.status.as_str()) {
            row.status.clear();
            row.reason.clear();
        }
        row
    }

    /// The first column in which the other row differs, with both values.
    pub fn difference<'a>(&'a self, other: &'a Row) -> Option<(&'static str, Cell<'a>, Cell<'a>)> {
        let values = COLUMNS.iter().map(|column| (*column, self.cell(column), other.cell(column)));
        let mut pairs = values.filter_map(|(column, here, there)| Some((column, here?, there?)));
        pairs.find(|(_, here, there)| here != there)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_a_column_and_none_stands_twice() {
        for (index, column) in CLOCK_COLUMNS.iter().enumerate() {
            assert!(COLUMNS.contains(column), "{column}");
            assert!(!CLOCK_COLUMNS[..index].contains(column), "{column}");
        }
        let times = COLUMNS.iter().filter(|name| name.contains("ns_") || name.ends_with("_ns"));
        let forgotten: Vec<_> = times
            .filter(|name| !CLOCK_COLUMNS.contains(name) && !["tests_form"].contains(name))
            .filter(|name| !["instructions_per_test"].contains(name))
            .collect();
        assert!(forgotten.is_empty(), "{forgotten:?}");
    }

    #[test]
    fn what_the_clock_says_goes_and_the_rest_stays() {
        let row = Row {
            id: "a".into(),
            status: "invalid".into(),
            reason: "a block took no time".into(),
            ns_per_test: Some(2.0),
            hits: Some(7),
            ..Row::default()
        };
        let free = row.without_clock();
        assert_eq!((free.ns_per_test, free.hits), (None, Some(7)));
        assert_eq!((free.status.as_str(), free.reason.as_str()), ("", ""));
        let wrong = Row { status: "wrong-result".into(), ..row.clone() };
        assert_eq!(wrong.without_clock().reason, row.reason);
        assert_eq!(row.difference(&row), None);
        assert_eq!(wrong.difference(&row).map(|(column, ..)| column), Some("status"));
    }
}
