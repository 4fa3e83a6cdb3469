//! What each kind of operation costs of a listing's time (thesis B, 4.4).
//!
//! The price of a kind is the time of the form that does every operation of it twice, less that of
//! its control, which passes the same operands through the same barrier without the second
//! operation; as a share of the literal form's time, round by round.

use crate::measure::Figures;
use crate::registry::Variant;
use crate::stats::{median, sign_interval};
use crate::table::Row;

/// A row per listing and kind, from the samples of one cell.
pub fn rows(measured: &[Row], figures: &[Figures], variants: &[&'static Variant]) -> Vec<Row> {
    let samples = |variant: &Variant| {
        let id = variant.id();
        figures.iter().find(|figures| figures.id == id).map(|figures| figures.samples.as_slice())
    };
    let sibling = |variant: &Variant, priced: &str| {
        variants.iter().copied().find(|other| {
            let same = other.axes.kernel == variant.axes.kernel;
            same && other.axes.output == variant.axes.output && other.axes.priced == priced
        })
    };
    let mut rows = Vec::new();
    for twice in variants.iter().filter(|variant| is_twice(variant.axes.priced)) {
        let control = sibling(twice, &format!("{}{CONTROL}", twice.axes.priced));
        let literal = sibling(twice, "");
        let of = [Some(*twice), control, literal].map(|variant| variant.and_then(samples));
        let ([Some(twice_ns), Some(control_ns), Some(literal_ns)], Some(literal)) = (of, literal)
        else {
            continue;
        };
        let id = literal.id();
        let Some(of_literal) = measured.iter().find(|row| row.id == id) else { continue };
        let mut row = Row { priced: twice.axes.priced.into(), ..of_literal.clone() };
        put_price(&mut row, twice_ns, control_ns, literal_ns);
        rows.push(row);
    }
    rows
}

/// The median share with its interval; without rounds in common the row says so.
fn put_price(row: &mut Row, twice_ns: &[f64], control_ns: &[f64], literal_ns: &[f64]) {
    let costs = twice_ns.iter().zip(control_ns).zip(literal_ns);
    let shares: Vec<f64> =
        costs.map(|((twice, control), literal)| (twice - control) / literal).collect();
    // Rounds of different groups are no pairs.
    let are_pairs = [control_ns, literal_ns].iter().all(|other| other.len() == twice_ns.len());
    row.price = median(&shares).filter(|_| are_pairs);
    if row.price.is_none() {
        // What is the matter with the literal form is the matter with its price.
        if row.status == "ok" {
            row.status = "not-measured".into();
            row.reason = "the forms that tell the price have no rounds in common".into();
        }
        return;
    }
    let interval = sign_interval(&shares);
    row.price_low = interval.as_ref().map(|interval| interval.low);
    row.price_high = interval.as_ref().map(|interval| interval.high);
}

const CONTROL: &str = "-control";

fn is_twice(priced: &str) -> bool {
    !priced.is_empty() && !priced.ends_with(CONTROL)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_price_is_the_median_share_of_rounds_in_common() {
        let mut row = Row { status: "ok".into(), ..Row::default() };
        put_price(&mut row, &[13.0, 15.0, 18.0], &[11.0, 11.0, 12.0], &[10.0, 10.0, 10.0]);
        assert_eq!((row.price, row.status.as_str()), (Some(0.4), "ok"));
    }

    /// Whether there is such a row does not depend on how quiet the machine was.
    #[test]
    fn without_rounds_in_common_the_row_says_so() {
        for twice in [&[][..], &[13.0, 15.0]] {
            let mut row = Row { status: "ok".into(), ..Row::default() };
            let others = if twice.is_empty() { &[][..] } else { &[11.0] };
            put_price(&mut row, twice, others, others);
            assert_eq!((row.price, row.status.as_str()), (None, "not-measured"));
            assert!(row.reason.contains("in common") && row.price_low.is_none());
        }
    }
}
