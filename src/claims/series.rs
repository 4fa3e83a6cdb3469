//! Figures with their keys, and what can be made of several.

use super::estimate::Estimate;
use super::lack::Lack;

/// Figures by the values of some columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// The columns.
    pub along: Vec<String>,
    /// A key, one value a column, and its figure. Numbers are in ascending order where all keys are one
    /// number each, other keys in the order in which rows came.
    pub cells: Vec<(Vec<String>, Estimate)>,
}

/// A key as messages show it.
pub fn shown(key: &[String]) -> String {
    key.join(" ")
}

impl Series {
    /// With the keys in their order.
    pub fn new(along: Vec<String>, cells: Vec<(Vec<String>, Estimate)>) -> Self {
        let mut series = Series { along, cells };
        if let Ok(mut numbers) = series.numbers() {
            let cells = series.cells.into_iter();
            let mut pairs: Vec<_> = numbers.drain(..).zip(cells).collect();
            pairs.sort_by(|(a, _), (b, _)| a.total_cmp(b));
            series.cells = pairs.into_iter().map(|(_, cell)| cell).collect();
        }
        series
    }

    /// The figures alone.
    pub fn figures(&self) -> Vec<Estimate> {
        self.cells.iter().map(|(_, figure)| *figure).collect()
    }

    /// The keys as numbers.
    ///
    /// # Errors
    /// Where a key is of several columns, or no number.
    pub fn numbers(&self) -> Result<Vec<f64>, Lack> {
        let number = |(key, _): &(Vec<String>, Estimate)| match key.as_slice() {
            [one] => one.parse::<f64>().ok().filter(|number| number.is_finite()),
            _ => None,
        };
        let numbers: Option<Vec<f64>> = self.cells.iter().map(number).collect();
        numbers.ok_or_else(|| Lack::new(format!("keys along {} are no numbers", self.along())))
    }

    fn along(&self) -> String {
        if self.along.is_empty() { "nothing".to_owned() } else { self.along.join(", ") }
    }

    /// A function of every figure.
    ///
    /// # Errors
    /// The first key where it has no value.
    pub fn map(
        &self,
        function: impl Fn(Estimate) -> Option<Estimate>,
        name: &str,
    ) -> Result<Self, Lack> {
        let cell = |(key, figure): &(Vec<String>, Estimate)| {
            let found = function(*figure).and_then(Estimate::checked);
            let lack = || Lack::new(format!("{name} has no value at {}", shown(key)));
            found.map(|found| (key.clone(), found)).ok_or_else(lack)
        };
        let cells = self.cells.iter().map(cell).collect::<Result<_, _>>()?;
        Ok(Series { along: self.along.clone(), cells })
    }

    /// A function of the figures of two series with the same key.
    ///
    /// # Errors
    /// Keys that one of them lacks, and keys where the function has no value.
    pub fn zip(
        &self,
        other: &Series,
        function: impl Fn(Estimate, Estimate) -> Option<Estimate>,
        name: &str,
    ) -> Result<Self, Lack> {
        if self.along != other.along {
            let (ours, theirs) = (self.along(), other.along());
            return Err(Lack::new(format!(
                "figures along {ours} and along {theirs} have no pairs"
            )));
        }
        let find = |series: &Series, key: &[String]| {
            series.cells.iter().find(|(own, _)| own == key).map(|(_, figure)| *figure)
        };
        let unpaired = |one: &Series, two: &Series| -> Vec<String> {
            let keys = one.cells.iter().map(|(key, _)| key);
            keys.filter(|key| find(two, key).is_none()).map(|key| shown(key)).collect()
        };
        let mut alone = unpaired(self, other);
        alone.extend(unpaired(other, self));
        if !alone.is_empty() {
            return Err(Lack::new(format!("only one side has figures for {}", alone.join(", "))));
        }
        let paired = |(key, figure): &(Vec<String>, Estimate)| {
            let theirs = find(other, key)?;
            Some((key.clone(), function(*figure, theirs).and_then(Estimate::checked)?))
        };
        let cells: Option<Vec<_>> = self.cells.iter().map(paired).collect();
        let lack = || Lack::new(format!("{name} has no value: an interval contains 0"));
        Ok(Series { along: self.along.clone(), cells: cells.ok_or_else(lack)? })
    }

    /// The figures whose keys begin with `start`, by what is left of their keys.
    ///
    /// # Errors
    /// Where there is none.
    pub fn at(&self, start: &[String]) -> Result<Self, Lack> {
        let rest = |(key, figure): &(Vec<String>, Estimate)| {
            Some((key.strip_prefix(start)?.to_vec(), *figure))
        };
        let cells: Vec<_> = self.cells.iter().filter_map(rest).collect();
        if cells.is_empty() {
            return Err(Lack::new(format!("there is no figure for {}", shown(start))));
        }
        Ok(Series::new(self.along[start.len()..].to_vec(), cells))
    }

    /// The figures whose first key passes.
    ///
    /// # Errors
    /// Where there is none; `what` says which were looked for.
    pub fn only(&self, passes: impl Fn(&str) -> bool, what: &str) -> Result<Self, Lack> {
        let passing = |(key, _): &&(Vec<String>, Estimate)| key.first().is_some_and(|k| passes(k));
        let cells: Vec<_> = self.cells.iter().filter(passing).cloned().collect();
        if cells.is_empty() {
            let along = self.along.first().map_or("key", String::as_str);
            return Err(Lack::new(format!("there is no {along} {what}")));
        }
        Ok(Series { along: self.along.clone(), cells })
    }

    /// One figure for all that differ in the given columns only.
    ///
    /// # Errors
    /// As `function`; where a column is none of the series; where there are no figures.
    pub fn reduced(
        &self,
        columns: &[String],
        function: impl Fn(&[Estimate]) -> Result<Estimate, Lack>,
    ) -> Result<Self, Lack> {
        if let Some(column) = columns.iter().find(|column| !self.along.contains(column)) {
            return Err(Lack::new(format!("figures are along {}, not {column}", self.along())));
        }
        let kept: Vec<usize> =
            (0..self.along.len()).filter(|&place| !columns.contains(&self.along[place])).collect();
        let mut groups: Vec<(Vec<String>, Vec<Estimate>)> = Vec::new();
        for (key, figure) in &self.cells {
            let key: Vec<String> = kept.iter().map(|&place| key[place].clone()).collect();
            match groups.iter_mut().find(|(other, _)| *other == key) {
                Some((_, figures)) => figures.push(*figure),
                None => groups.push((key, vec![*figure])),
            }
        }
        let cell = |(key, figures): (Vec<String>, Vec<Estimate>)| Ok((key, function(&figures)?));
        let cells = groups.into_iter().map(cell).collect::<Result<_, Lack>>()?;
        Ok(Series::new(kept.iter().map(|&place| self.along[place].clone()).collect(), cells))
    }
}
