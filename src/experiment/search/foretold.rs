//! What B + p I says of a volume around a list, beside what the clock says.

use crate::structure::VOLUMES;
use crate::table::Row;

/// The list of no triangle: what a search costs with nothing in it.
pub const NOTHING: &str = "nothing";

/// Lower end, middle and upper end of a time.
type Time = [f64; 3];

fn time_of(row: &Row) -> Option<Time> {
    Some([row.ns_low?, row.ns_per_test?, row.ns_high?])
}

/// Writes into the rows of a group what B + p I says, and whether the clock agrees about who pays.
pub fn foretell(rows: &mut [Row]) {
    let of = |rows: &[Row], record: &str, structure: &str| {
        let mut own = rows.iter().filter(|row| row.record == record && row.structure == structure);
        own.next().and_then(time_of)
    };
    let (list, nothing) = (of(rows, "bounded", "list"), of(rows, "bounded", NOTHING));
    for volume in VOLUMES {
        let emptied = of(rows, "emptied", volume.id);
        let bounded = rows.iter_mut().filter(|row| row.record == "bounded");
        for row in bounded.filter(|row| row.structure == volume.id) {
            let (Some(list), Some(nothing), Some(emptied)) = (list, nothing, emptied) else {
                continue;
            };
            let Some(share) = row.passed_share else { continue };
            let [low, middle, high] = foretold(list, nothing, emptied, share);
            (row.predicted_low, row.predicted_high) = (Some(low), Some(high));
            row.predicted_ratio = Some(middle);
            row.pays_as_predicted =
                row.ratio_low.zip(row.ratio_high).and_then(|(own_low, own_high)| {
                    agree([own_low, own_high], [low, high]).map(u64::from)
                });
        }
    }
}

/// Time with a volume over time without: (N + B + p I) / (N + I), where N is what a search costs with
/// nothing in it, which both pay; `emptied` is N + B. The ends are those of the times that are worst for it, N apart: its ends
/// hardly move a quotient that has it on both sides.
fn foretold(list: Time, nothing: Time, emptied: Time, share: f64) -> Time {
    let none = nothing[1];
    let at = |own: usize, other: usize| {
        let inside = (list[other] - none).max(0.0);
        (emptied[own] + share * inside) / (none + inside)
    };
    let middle = at(1, 1);
    [at(0, 2).min(middle), middle, at(2, 0).max(middle)]
}

/// Whether two intervals are on the same side of 1; `None` where one of them is on both.
fn agree(one: [f64; 2], other: [f64; 2]) -> Option<bool> {
    let pays = |[low, high]: [f64; 2]| match () {
        () if high < 1.0 => Some(true),
        () if low > 1.0 => Some(false),
        () => None,
    };
    Some(pays(one)? == pays(other)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_foretold_ratio_is_that_of_the_lecture() {
        // N = 10, B = 5, I = 40, p = 0.25: (10 + 5 + 10) / 50.
        let time = |ns: f64| [ns - 1.0, ns, ns + 1.0];
        let [low, middle, high] = foretold(time(50.0), time(10.0), time(15.0), 0.25);
        assert_eq!(middle, 0.5);
        assert!(low < middle && middle < high);
        // All pass: the volume is paid for nothing.
        assert!(foretold(time(50.0), time(10.0), time(15.0), 1.0)[0] > 1.0);
    }

    #[test]
    fn sides_are_told_where_they_are_clear() {
        assert_eq!(agree([0.5, 0.9], [0.2, 0.99]), Some(true));
        assert_eq!(agree([1.1, 1.2], [0.2, 0.99]), Some(false));
        assert_eq!(agree([0.9, 1.2], [0.2, 0.99]), None);
        assert_eq!(agree([1.1, 1.2], [0.9, 1.3]), None);
    }

    #[test]
    fn rows_tell_what_was_foretold_and_whether_it_came() {
        let row = |record: &str, structure: &str, ns: f64, ratio: f64| Row {
            record: record.into(),
            structure: structure.into(),
            passed_share: Some(0.25),
            ns_per_test: Some(ns),
            ns_low: Some(ns),
            ns_high: Some(ns),
            ratio_low: Some(ratio),
            ratio_high: Some(ratio),
            ..Row::default()
        };
        let mut rows = vec![
            row("bounded", "list", 50.0, 1.0),
            row("bounded", NOTHING, 10.0, 0.2),
            row("bounded", "box", 26.0, 0.52),
            row("emptied", "box", 15.0, 0.3),
            row("bounded", "sphere", 60.0, 1.2),
            row("emptied", "sphere", 15.0, 0.3),
        ];
        foretell(&mut rows);
        assert_eq!((rows[2].predicted_ratio, rows[2].pays_as_predicted), (Some(0.5), Some(1)));
        assert_eq!((rows[4].predicted_ratio, rows[4].pays_as_predicted), (Some(0.5), Some(0)));
        assert_eq!((rows[0].predicted_ratio, rows[3].predicted_ratio), (None, None));
    }
}
