//! A field of colours: who never fails, who fails most, and where most fail.

use super::named::Named;
use crate::chart::Field;
use crate::report::words::{count, first_of};

/// Names told one by one.
const TOLD: usize = 4;

/// What a heat map shows.
pub(super) fn sentence(named: &Named<'_>, fields: &[Field]) -> String {
    let apart = named.figure.apart.as_ref();
    let fields: Vec<&Field> = fields.iter().filter(|field| Some(&field.series) != apart).collect();
    let series = failing(named, &fields, |field| &field.series);
    let columns = failing(named, &fields, |field| &field.x);
    let (Some(&(least, _)), Some(&(most, _))) = (series.first(), series.last()) else {
        return "Nothing was measured.".to_owned();
    };
    let of = |failed: usize| format!("{failed} of {}", count(columns.len(), "family", "families"));
    let who = |failed: usize| {
        let alike = series.iter().filter(|(number, _)| *number == failed);
        let names: Vec<String> = alike.map(|(_, name)| name.clone()).collect();
        let verb = if names.len() == 1 { "fails" } else { "fail" };
        (names.len(), first_of(&names, TOLD), verb)
    };
    let best = match (least, who(least)) {
        (0, (number, names, _)) => format!("{number} of {} never fail: {names}", series.len()),
        (_, (_, names, verb)) => {
            format!("No kernel holds everywhere: {names} {verb} in the fewest, {}", of(least))
        }
    };
    let (_, names, verb) = who(most);
    let worst = format!("{names} {verb} in the most, {}", of(most));
    let hardest = columns.last().map_or(String::new(), |(failed, name)| {
        format!("; most kernels, {failed} of {}, fail in {name}", series.len())
    });
    format!("{best}; {worst}{hardest}.")
}

/// In how many fields of each name something fails, the fewest first.
fn failing(
    named: &Named<'_>,
    fields: &[&Field],
    name: fn(&Field) -> &String,
) -> Vec<(usize, String)> {
    let mut all: Vec<(usize, &String)> = Vec::new();
    for field in fields {
        let fails = usize::from(field.share < 1.0);
        match all.iter_mut().find(|(_, known)| *known == name(field)) {
            Some((failed, _)) => *failed += fails,
            None => all.push((fails, name(field))),
        }
    }
    let labelled = all.into_iter().map(|(failed, name)| (failed, named.figure.label(name)));
    let mut all: Vec<(usize, String)> = labelled.collect();
    all.sort();
    all
}
