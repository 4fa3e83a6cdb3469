//! The figure of a formula.

use super::claim::Claim;
use super::estimate::Estimate;
use super::expression::Expression;
use super::function::Function;
use super::lack::Lack;
use super::reductions as reduce;
use super::select::{Selected, select};
use super::series::Series;
use super::straight::r_squared;
use crate::table::Row;
use std::collections::BTreeMap;

/// What a formula comes to.
#[derive(Clone, Debug)]
enum Value {
    One(Estimate),
    Many(Series),
    Word(String),
}

/// A claim with the series of one condition.
pub struct Scope<'a> {
    claim: &'a Claim,
    series: BTreeMap<&'a str, Result<Selected, Lack>>,
}

impl<'a> Scope<'a> {
    /// `rows_of` gives the rows that a series may choose from.
    pub fn new<'r>(claim: &'a Claim, rows_of: impl Fn(&super::SeriesOf) -> Vec<&'r Row>) -> Self {
        let of =
            |(name, of): (&'a String, &super::SeriesOf)| (name.as_str(), select(of, &rows_of(of)));
        Scope { claim, series: claim.series.iter().map(of).collect() }
    }

    /// The figure of a formula, with intervals that cover together with `comparisons` - 1 others.
    ///
    /// # Errors
    /// What rows lack.
    pub fn figure(&self, formula: &Expression, comparisons: usize) -> Result<Estimate, Lack> {
        match self.value(formula, comparisons)? {
            Value::One(figure) => Ok(figure),
            Value::Many(series) => {
                let words = format!("{} figures where one is wanted", series.cells.len());
                Err(Lack::new(words))
            }
            Value::Word(word) => Err(Lack::new(format!("'{word}' is no figure"))),
        }
    }

    /// The largest noise floor of the rows that a formula needs.
    pub fn noise_floor(&self, formula: &Expression) -> f64 {
        let of = |name: &str| match (self.claim.read.get(name), self.series.get(name)) {
            (Some(inner), _) => self.noise_floor(inner),
            (None, Some(Ok(selected))) => selected.noise_floor,
            _ => 0.0,
        };
        formula.names().into_iter().map(of).fold(0.0, f64::max)
    }

    /// Whether nothing that a formula needs was left to chance.
    pub fn is_exact(&self, formula: &Expression) -> bool {
        formula.names().into_iter().all(|name| {
            match (self.claim.read.get(name), self.series.get(name)) {
                (Some(inner), _) => self.is_exact(inner),
                (None, Some(Ok(selected))) => {
                    selected.series.cells.iter().all(|(_, figure)| figure.is_exact())
                }
                _ => true,
            }
        })
    }

    fn value(&self, formula: &Expression, comparisons: usize) -> Result<Value, Lack> {
        match formula {
            Expression::Number(number) => Ok(Value::One(Estimate::exact(*number))),
            Expression::Word(word) => Ok(Value::Word(word.clone())),
            Expression::Name(name) => self.named(name, comparisons),
            Expression::Negative(inner) => {
                each(self.value(inner, comparisons)?, |x| Some(x.negated()), "-")
            }
            Expression::Joined(operator, one, other) => {
                join(*operator, self.value(one, comparisons)?, self.value(other, comparisons)?)
            }
            Expression::Call(function, arguments) => {
                let values = |comparisons: usize| -> Result<Vec<Value>, Lack> {
                    arguments.iter().map(|one| self.value(one, comparisons)).collect()
                };
                let mut found = values(comparisons)?;
                if function.selects() {
                    let count: usize = found.iter().map(noisy).sum();
                    found = values(comparisons * count.max(1))?;
                }
                call(*function, found)
            }
        }
    }

    fn named(&self, name: &str, comparisons: usize) -> Result<Value, Lack> {
        if let Some(inner) = self.claim.read.get(name) {
            return self.value(inner, comparisons);
        }
        match self.series.get(name) {
            Some(Ok(selected)) => {
                let corrected = |figure: Estimate| Some(figure.corrected(comparisons));
                Ok(single(selected.series.map(corrected, name)?))
            }
            Some(Err(lack)) => Err(lack.clone()),
            None => Err(Lack::new(format!("there is no '{name}'"))),
        }
    }
}

/// Figures that are not exact.
fn noisy(value: &Value) -> usize {
    match value {
        Value::One(figure) => usize::from(!figure.is_exact()),
        Value::Many(series) => series.cells.iter().filter(|(_, f)| !f.is_exact()).count(),
        Value::Word(_) => 0,
    }
}

/// A series without a key is its one figure.
fn single(series: Series) -> Value {
    match series.cells.as_slice() {
        [(key, figure)] if key.is_empty() => Value::One(*figure),
        _ => Value::Many(series),
    }
}

fn each(
    value: Value,
    function: impl Fn(Estimate) -> Option<Estimate>,
    name: &str,
) -> Result<Value, Lack> {
    match value {
        Value::One(figure) => {
            let lack = || Lack::new(format!("{name} has no value"));
            Ok(Value::One(function(figure).and_then(Estimate::checked).ok_or_else(lack)?))
        }
        Value::Many(series) => Ok(Value::Many(series.map(function, name)?)),
        Value::Word(word) => Err(Lack::new(format!("'{word}' is no figure"))),
    }
}

fn join(operator: char, one: Value, other: Value) -> Result<Value, Lack> {
    let apply = |a: Estimate, b: Estimate| match operator {
        '+' => Some(a.plus(b)),
        '-' => Some(a.plus(b.negated())),
        '*' => Some(a.times(b)),
        _ => a.over(b),
    };
    let name = operator.to_string();
    match (one, other) {
        (Value::Many(a), Value::Many(b)) => Ok(Value::Many(a.zip(&b, apply, &name)?)),
        (one, Value::One(b)) => each(one, |a| apply(a, b), &name),
        (Value::One(a), other) => each(other, |b| apply(a, b), &name),
        (Value::Word(word), _) | (_, Value::Word(word)) => {
            Err(Lack::new(format!("'{word}' is no figure")))
        }
    }
}

fn call(function: Function, mut arguments: Vec<Value>) -> Result<Value, Lack> {
    let rest = arguments.split_off(1);
    let Some(first) = arguments.pop() else { return Err(Lack::new("nothing to compute with")) };
    let rising = |of: fn(f64) -> f64| move |x: Estimate| x.rising(of);
    match function {
        Function::Ln => each(first, rising(f64::ln), "ln"),
        Function::Exp => each(first, rising(f64::exp), "exp"),
        Function::Sqrt => each(first, rising(f64::sqrt), "sqrt"),
        Function::Abs => each(first, |x| Some(x.absolute()), "abs"),
        Function::Square => each(first, |x| Some(x.squared()), "square"),
        Function::At => many(first)?.at(&words(&rest)?).map(single),
        Function::Without => {
            let keys = words(&rest)?;
            let what = format!("but {}", keys.join(", "));
            many(first)?.only(|key| !keys.iter().any(|k| k == key), &what).map(Value::Many)
        }
        Function::Like => {
            let word = words(&rest)?.concat();
            let what = format!("with '{word}' in its name");
            many(first)?.only(|key| key.contains(&word), &what).map(Value::Many)
        }
        Function::Spearman => {
            let (a, b) = (many(first)?, rest.into_iter().next().map_or(Err(no_series()), many)?);
            // In the keys' order of the first.
            let b = a.zip(&b, |_, figure| Some(figure), "spearman")?;
            reduce::spearman(&a.figures(), &b.figures()).map(Value::One)
        }
        _ => summary(function, first, rest),
    }
}

/// Functions that make one figure of many, or of those that differ in some columns.
fn summary(function: Function, first: Value, rest: Vec<Value>) -> Result<Value, Lack> {
    let reducer = match function {
        Function::Mean => reduce::mean,
        Function::Geomean => reduce::geomean,
        Function::Sum => reduce::sum,
        Function::Min => reduce::min,
        Function::Max => reduce::max,
        Function::Median => reduce::median,
        Function::Spread => reduce::spread,
        _ => return along_keys(function, &many(first)?),
    };
    if let Value::One(figure) = first {
        let mut figures = vec![figure];
        for value in rest {
            let Value::One(figure) = value else { return Err(no_figure()) };
            figures.push(figure);
        }
        return reducer(&figures).map(Value::One);
    }
    let series = many(first)?;
    let columns = if rest.is_empty() { series.along.clone() } else { words(&rest)? };
    series.reduced(&columns, reducer).map(single)
}

/// Functions of figures in the order of their keys.
fn along_keys(function: Function, series: &Series) -> Result<Value, Lack> {
    let figures = series.figures();
    let end = |figure: Option<&Estimate>| figure.copied().ok_or_else(no_figure).map(Value::One);
    match function {
        Function::First => end(figures.first()),
        Function::Last => end(figures.last()),
        Function::Count => Ok(Value::One(Estimate::exact(figures.len() as f64))),
        Function::Keys => {
            let numbers = series.numbers()?.into_iter().map(Estimate::exact);
            let cells = series.cells.iter().map(|(key, _)| key.clone()).zip(numbers).collect();
            Ok(Value::Many(Series { along: series.along.clone(), cells }))
        }
        Function::Slope => reduce::slope(&series.numbers()?, &figures).map(Value::One),
        Function::RSquared => r_squared(&series.numbers()?, &figures).map(Value::One),
        _ => {
            let logs: Vec<f64> = series.numbers()?.into_iter().map(f64::ln).collect();
            let figures = series.map(|x| x.rising(f64::ln), "growth")?.figures();
            reduce::slope(&logs, &figures).map(Value::One)
        }
    }
}

fn many(value: Value) -> Result<Series, Lack> {
    match value {
        Value::Many(series) => Ok(series),
        _ => Err(no_series()),
    }
}

fn no_series() -> Lack {
    Lack::new("one figure where several are wanted")
}

fn no_figure() -> Lack {
    Lack::new("no figure where one is wanted")
}

/// Keys and columns; numbers as rows write them.
fn words(values: &[Value]) -> Result<Vec<String>, Lack> {
    let word = |value: &Value| match value {
        Value::Word(word) => Ok(word.clone()),
        Value::One(figure) if figure.is_exact() => Ok(figure.value.to_string()),
        _ => Err(Lack::new("a figure where a key is wanted")),
    };
    values.iter().map(word).collect()
}
