//! The theses' printed numbers, as series that a figure can draw beside ours.

use super::ChartError;
use serde_json::{Map, Value};

const BLECHA_2007: &str = include_str!("../../configs/published/blecha2007.json");

/// Name of a table in a figure's configuration, and its key in the file.
const TABLES: [(&str, &str); 10] = [
    ("table_4_1", "table_4_1"),
    ("table_4_2", "table_4_2"),
    ("table_4_3", "table_4_3"),
    ("table_4_4", "table_4_4_4_6_4_8_4_9"),
    ("table_4_5", "table_4_5"),
    ("table_4_6", "table_4_4_4_6_4_8_4_9"),
    ("table_4_7", "table_4_7"),
    ("table_4_8", "table_4_4_4_6_4_8_4_9"),
    ("table_4_9", "table_4_4_4_6_4_8_4_9"),
    ("table_4_10", "table_4_10"),
];

/// Which of a table's figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Seconds, over density, machine or return code.
    Seconds,
    /// Share of the calls that end with a return code, from 0 to 1.
    Share,
    /// Operations of one call.
    Count,
}

/// One printed number.
#[derive(Clone, Debug, PartialEq)]
pub struct PublishedPoint {
    /// Kernel, as the table calls it.
    pub series: String,
    /// Density, machine, return code or operation.
    pub x: String,
    /// The number.
    pub y: f64,
}

/// A file of published numbers.
#[derive(Clone, Debug)]
pub struct Published {
    root: Value,
}

impl Published {
    /// Thesis B's numbers, which are part of the program.
    pub fn embedded() -> Result<Self, ChartError> {
        Published::from_json(BLECHA_2007)
    }

    /// The numbers in a text of the same form.
    pub fn from_json(text: &str) -> Result<Self, ChartError> {
        let root = serde_json::from_str(text)
            .map_err(|error| ChartError::Published(format!("published figures: {error}")))?;
        Ok(Published { root })
    }

    /// The tables that a figure may name.
    pub fn tables(&self) -> Vec<&'static str> {
        let known = TABLES.iter().filter(|(_, key)| self.root.get(key).is_some());
        known.map(|(name, _)| *name).collect()
    }

    fn table(&self, name: &str) -> Option<&Value> {
        let (_, key) = TABLES.iter().find(|(known, _)| *known == name)?;
        self.root.get(key)
    }

    /// The numbers of a table; none if it does not have that measure.
    pub fn points(&self, table: &str, measure: Measure) -> Vec<PublishedPoint> {
        let Some(value) = self.table(table) else { return Vec::new() };
        match measure {
            Measure::Seconds => seconds(table, value),
            Measure::Share => shares(table, value),
            Measure::Count => counts(value),
        }
    }

    /// What a return code means, where the table says.
    pub fn meaning(&self, table: &str, code: &str) -> Option<&str> {
        self.table(table)?.get("meaning")?.get(code)?.as_str()
    }
}

/// Series names of the tables by return code, which are about one kernel each.
fn only_kernel(table: &str) -> &'static str {
    if table == "table_4_7" { "badouel" } else { "moller" }
}

fn object<'a>(value: &'a Value, key: &str) -> Option<&'a Map<String, Value>> {
    value.get(key)?.as_object()
}

fn seconds(table: &str, value: &Value) -> Vec<PublishedPoint> {
    let Some(seconds) = object(value, "seconds") else { return Vec::new() };
    let densities: Vec<_> =
        value.get("density").and_then(Value::as_array).into_iter().flatten().collect();
    let mut points = Vec::new();
    for (name, figures) in seconds {
        match figures {
            // kernel: one number per density
            Value::Array(figures) => {
                for (density, y) in densities.iter().zip(figures) {
                    push(&mut points, name, &plain(density), y);
                }
            }
            // machine: one number per kernel
            Value::Object(kernels) => {
                kernels.iter().for_each(|(kernel, y)| push(&mut points, kernel, name, y));
            }
            // return code: one number
            y => push(&mut points, only_kernel(table), name, y),
        }
    }
    points
}

fn shares(table: &str, value: &Value) -> Vec<PublishedPoint> {
    let Some(counts) = object(value, "count") else { return Vec::new() };
    let total: f64 = counts.values().filter_map(Value::as_f64).sum();
    let share = |(code, count): (&String, &Value)| {
        let y = count.as_f64()? / total;
        let series = only_kernel(table).to_owned();
        y.is_finite().then(|| PublishedPoint { series, x: code.clone(), y })
    };
    counts.iter().filter_map(share).collect()
}

fn counts(value: &Value) -> Vec<PublishedPoint> {
    let mut points = Vec::new();
    for (kernel, operations) in object(value, "counts").into_iter().flatten() {
        for (operation, y) in operations.as_object().into_iter().flatten() {
            push(&mut points, kernel, operation, y);
        }
    }
    points
}

fn push(points: &mut Vec<PublishedPoint>, series: &str, x: &str, y: &Value) {
    if let Some(y) = y.as_f64() {
        points.push(PublishedPoint { series: series.to_owned(), x: x.to_owned(), y });
    }
}

/// A number as the rows write it: `0.0` is `0`.
fn plain(value: &Value) -> String {
    value.as_f64().map_or(String::new(), |number| number.to_string())
}
