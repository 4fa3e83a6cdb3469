//! From rows to the series of a claim.

use super::claim::SeriesOf;
use super::estimate::Estimate;
use super::lack::Lack;
use super::series::{Series, shown};
use crate::chart::{admits, differing};
use crate::stats::median;
use crate::table::{Cell, Row, has_interval, interval};

/// A series with what is to be said of its rows.
pub struct Selected {
    /// The figures.
    pub series: Series,
    /// The largest noise floor of their rows.
    pub noise_floor: f64,
}

/// A row with its figure.
type Found<'a> = (&'a Row, Estimate);

/// The series of a claim from rows that are of one condition.
///
/// # Errors
/// What is missing, and which command measures it.
pub fn select(of: &SeriesOf, rows: &[&Row]) -> Result<Selected, Lack> {
    let along = of.along.list().to_vec();
    if !of.values.is_empty() {
        let cell = |(key, value): (&String, &f64)| (vec![key.clone()], Estimate::exact(*value));
        let series = Series::new(along, of.values.iter().map(cell).collect());
        return Ok(Selected { series, noise_floor: 0.0 });
    }
    let admitted: Vec<&Row> = rows.iter().copied().filter(|row| belongs(of, row)).collect();
    let mut groups: Vec<(Vec<String>, Vec<Found<'_>>)> = Vec::new();
    let counted = |row: &&Row| ["ok", "inexact"].contains(&row.status.as_str()) || of.wrong_too;
    for row in admitted.iter().copied().filter(counted) {
        let Some(figure) = figure(of, row)? else { continue };
        let key = along.iter().map(|column| text(row, column)).collect();
        match groups.iter_mut().find(|(other, _)| *other == key) {
            Some((_, found)) => found.push((row, figure)),
            None => groups.push((key, vec![(row, figure)])),
        }
    }
    if groups.is_empty() {
        return Err(nothing(of, rows, &admitted));
    }
    let floors = groups.iter().flat_map(|(_, found)| found).filter_map(|(row, _)| row.noise_floor);
    let noise_floor = floors.fold(0.0, f64::max);
    let cell = |(key, found): (Vec<String>, Vec<Found<'_>>)| {
        let figure = together(of, &key, &found)?;
        Ok((key, figure))
    };
    let mut cells = groups.into_iter().map(cell).collect::<Result<Vec<_>, Lack>>()?;
    for key in of.keys.iter().map(|key| vec![key.clone()]) {
        if !cells.iter().any(|(own, _)| *own == key) {
            cells.push((key, Estimate::exact(of.otherwise.unwrap_or_default())));
        }
    }
    Ok(Selected { series: Series::new(along, cells), noise_floor })
}

/// Whether a series asks for a row.
pub fn belongs(of: &SeriesOf, row: &Row) -> bool {
    of.experiment.list().contains(&row.experiment) && admits(&of.filter, row)
}

fn text(row: &Row, column: &str) -> String {
    row.cell(column).map_or(String::new(), |cell| cell.to_string())
}

/// The figure of a row, if it has one.
fn figure(of: &SeriesOf, row: &Row) -> Result<Option<Estimate>, Lack> {
    let Some(value) = row.cell(&of.value).and_then(Cell::number) else { return Ok(None) };
    match interval(row, &of.value, value) {
        Some((low, high)) => {
            // The middle of paired ratios can lie beside the ratio of the middles.
            let (low, high) = (low.min(value), high.max(value));
            Ok(Some(Estimate { value, low, high }))
        }
        None if has_interval(&of.value) => {
            let words = format!("{} of {} has no interval: too few rounds", of.value, row.id);
            Err(Lack::new(words))
        }
        None => Ok(Some(Estimate::exact(value))),
    }
}

/// One figure of all rows of a key.
fn together(of: &SeriesOf, key: &[String], found: &[Found<'_>]) -> Result<Estimate, Lack> {
    let [(first, figure), others @ ..] = found else {
        return Err(Lack::new("there is no figure"));
    };
    let Some(over) = &of.over else {
        return match others {
            [] => Ok(*figure),
            [(other, _), ..] => {
                let differing = differing(first, other);
                let (experiment, key) = (&first.experiment, shown(key));
                let words = format!("several rows of {experiment} are for {key}: {differing}");
                Err(Lack::new(words))
            }
        };
    };
    let mut values = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    for (row, figure) in found {
        let one = text(row, over);
        if seen.contains(&one) {
            let words = format!("several rows of {} are for {} {one}", row.experiment, shown(key));
            return Err(Lack::new(words));
        }
        seen.push(one);
        values.push(figure.value);
    }
    let lack = || Lack::new("there is no median");
    let value = median(&values).ok_or_else(lack)?;
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Ok(Estimate { value, low, high })
}

/// Why there is nothing: no row of the experiment, none that passes, or none with a figure.
fn nothing(of: &SeriesOf, rows: &[&Row], admitted: &[&Row]) -> Lack {
    let experiments = of.experiment.list();
    let name = experiments.join(", ");
    if !rows.iter().any(|row| experiments.contains(&row.experiment)) {
        let commands: Vec<String> = experiments.iter().map(|id| command(id)).collect();
        let commands = commands.join(", ");
        return Lack::new(format!("there are no rows of {name}: run `{commands}`"));
    }
    let reasons = admitted.iter().map(|row| match row.reason.as_str() {
        "" => row.status.as_str(),
        reason => reason,
    });
    let mut distinct: Vec<&str> = Vec::new();
    for reason in reasons {
        if !distinct.contains(&reason) {
            distinct.push(reason);
        }
    }
    match distinct.as_slice() {
        [] => {
            let columns: Vec<String> = of.filter.keys().cloned().collect();
            let (value, columns) = (&of.value, columns.join(", "));
            Lack::new(format!("no row of {name} has {value} with the wanted {columns}"))
        }
        reasons => Lack::new(format!("no {} in {name}: {}", of.value, reasons.join(", "))),
    }
}

/// The command that measures an experiment.
fn command(experiment: &str) -> String {
    if experiment == "stability" {
        return "ray_test stability".to_owned();
    }
    format!("ray_test run configs/{experiment}.toml")
}
