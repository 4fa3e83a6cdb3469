//! Rows that are made up for the series of a claim.

use crate::chart::Wanted;
use crate::claims::{Claim, SeriesOf};
use crate::table::{Row, has_interval};

/// Figures of a series: its name, its keys, the figure. Columns of a key are parted by `/`, and `|`
/// stands between names and between keys of the same figure: `a|b/0|1` are four keys.
pub type Cells = &'static [(&'static str, &'static str, f64)];

/// The rows that give a claim these figures in an order; later figures replace earlier ones of the same
/// key. Intervals reach from `noise` less to `noise` more than the figure, relatively.
pub fn rows(claim: &Claim, cells: &[(&str, &str, f64)], order: &str, noise: f64) -> Vec<Row> {
    let mut single: Vec<(&str, Vec<String>, f64)> = Vec::new();
    for (names, keys, value) in cells {
        for (name, key) in
            names.split('|').flat_map(|name| keys_of(keys).into_iter().map(move |key| (name, key)))
        {
            single.retain(|(other, own, _)| (*other, own) != (name, &key));
            single.push((name, key, *value));
        }
    }
    let of = |(name, key, value): &(&str, Vec<String>, f64)| {
        let series = claim.series.get(*name).unwrap_or_else(|| panic!("{}: {name}", claim.id));
        let seeds = if series.over.is_some() { 1..=6 } else { 1..=1 };
        let row = |seed: u32| {
            // From the lower to the upper end in six steps, or the middle alone.
            let off =
                if series.over.is_some() { (f64::from(seed) - 3.5) / 2.5 * noise } else { 0.0 };
            row(series, key, value * (1.0 + off), (order, noise, seed))
        };
        seeds.map(row).collect::<Vec<_>>()
    };
    single.iter().flat_map(of).collect()
}

fn keys_of(keys: &str) -> Vec<Vec<String>> {
    let mut all: Vec<Vec<String>> = vec![Vec::new()];
    for column in keys.split('/').filter(|column| !column.is_empty()) {
        let longer = |key: &Vec<String>| {
            let of = |word: &str| [key.clone(), vec![word.to_owned()]].concat();
            column.split('|').map(of).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

fn text(wanted: &Wanted) -> String {
    match wanted {
        Wanted::Any(all) => text(&all[0]),
        Wanted::Number(number) => number.to_string(),
        Wanted::Word(word) => word.clone(),
    }
}

fn row(series: &SeriesOf, key: &[String], value: f64, given: (&str, f64, u32)) -> Row {
    let (order, noise, seed) = given;
    let mut row = Row::default();
    let mut set = |column: &str, text: &str| {
        row.set(column, text).unwrap_or_else(|allowed| panic!("{column} = {text}: {allowed}"));
    };
    set("experiment", &series.experiment.list()[0]);
    set("status", "ok");
    set("order", order);
    series.filter.iter().for_each(|(column, wanted)| set(column, &text(wanted)));
    assert_eq!(series.along.list().len(), key.len(), "{key:?} along {:?}", series.along);
    series.along.list().iter().zip(key).for_each(|(column, key)| set(column, key));
    if let Some(over) = &series.over {
        set(over, &seed.to_string());
    }
    set(&series.value, &value.to_string());
    if has_interval(&series.value) {
        let (low, high) = match series.value.as_str() {
            "ratio_to_reference" => ("ratio_low", "ratio_high"),
            "cycles_per_test" => ("cycles_low", "cycles_high"),
            "ns_per_test" => ("ns_low", "ns_high"),
            "price" => ("price_low", "price_high"),
            other => panic!("how is the interval of {other} called?"),
        };
        set(low, &(value - noise * value.abs()).to_string());
        set(high, &(value + noise * value.abs()).to_string());
    }
    row
}
