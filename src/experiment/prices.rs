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
        // Rounds of different groups are no pairs.
        if twice_ns.len() != control_ns.len() || twice_ns.len() != literal_ns.len() {
            continue;
        }
        let shares: Vec<f64> = twice_ns
            .iter()
            .zip(control_ns)
            .zip(literal_ns)
            .map(|((twice, control), literal)| (twice - control) / literal)
            .collect();
        let Some(price) = median(&shares) else { continue };
        let id = literal.id();
        let Some(of_literal) = measured.iter().find(|row| row.id == id) else { continue };
        let interval = sign_interval(&shares);
        rows.push(Row {
            priced: twice.axes.priced.into(),
            price: Some(price),
            price_low: interval.as_ref().map(|interval| interval.low),
            price_high: interval.as_ref().map(|interval| interval.high),
            ..of_literal.clone()
        });
    }
    rows
}

const CONTROL: &str = "-control";

fn is_twice(priced: &str) -> bool {
    !priced.is_empty() && !priced.ends_with(CONTROL)
}
