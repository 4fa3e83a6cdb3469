//! A field of colours: who never fails, who fails most, and where most fail.

use super::named::Named;
use crate::chart::Field;
use crate::report::words::{count, first_of};

/// What a heat map shows.
pub(super) fn sentence(named: &Named<'_>, fields: &[Field]) -> String {
    let apart = named.figure.apart.as_ref();
    let fields: Vec<&Field> = fields.iter().filter(|field| Some(&field.series) != apart).collect();
    let fails = |field: &&&Field| field.share < 1.0;
    let mut series: Vec<(usize, String)> = Vec::new();
    for name in distinct(&fields, |field| &field.series) {
        let failed = fields.iter().filter(|field| field.series == name).filter(fails).count();
        series.push((failed, named.figure.label(&name)));
    }
    let mut columns: Vec<(usize, String)> = Vec::new();
    for name in distinct(&fields, |field| &field.x) {
        let failed = fields.iter().filter(|field| field.x == name).filter(fails).count();
        columns.push((failed, named.figure.label(&name)));
    }
    series.sort();
    columns.sort();
    let (Some(least), Some(most)) = (series.first(), series.last()) else {
        return "Nothing was measured.".to_owned();
    };
    let of = |failed: usize| format!("{failed} of {}", count(columns.len(), "family", "families"));
    let never: Vec<String> =
        series.iter().filter(|(failed, _)| *failed == 0).map(|(_, name)| name.clone()).collect();
    let best = if never.is_empty() {
        format!("No kernel holds everywhere: {} fails in the fewest, {}", least.1, of(least.0))
    } else {
        format!("{} of {} never fail: {}", never.len(), series.len(), first_of(&never, 4))
    };
    let worst = format!("{} fails in the most, {}", most.1, of(most.0));
    let hardest = columns.last().map_or(String::new(), |(failed, name)| {
        format!("; most kernels, {failed} of {}, fail in {name}", series.len())
    });
    format!("{best}; {worst}{hardest}.")
}

fn distinct(fields: &[&Field], name: impl Fn(&Field) -> &String) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for field in fields {
        if !names.contains(name(field)) {
            names.push(name(field).clone());
        }
    }
    names
}
