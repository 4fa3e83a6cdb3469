//! The rows of one experiment from one folder.

use super::files::SOURCES;
use super::machine::identity;
use crate::table::Row;
use serde_json::Value;

/// One experiment of one folder, on one machine.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    /// The folder, as it was given.
    pub folder: String,
    /// The experiment's id.
    pub experiment: String,
    /// The experiment's text, where it was stored.
    pub text: Option<String>,
    /// What it was measured on.
    pub environment: Value,
    /// The rows, whose column `machine` is empty.
    pub rows: Vec<Row>,
    /// Which share of the work it is; `None` for all of it.
    pub share: Option<Share>,
    /// Whether it was run to its end.
    pub complete: bool,
    /// As stored.
    pub workload_hash: String,
}

/// A share of the work: from one fraction of it to another.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Share {
    /// The I-th of N, N above 0.
    pub part: (u64, u64),
    /// Where each row stands in the whole.
    pub places: Vec<u64>,
}

impl Share {
    /// What a file says; `None` if it says nothing, or nothing that goes with so many rows.
    pub fn of(field: Option<&Value>, rows: usize) -> Option<Self> {
        let field = field?;
        let (part, parts) = field.get("part")?.as_str()?.split_once('/')?;
        let part = (part.parse().ok()?, parts.parse().ok()?);
        let places = field.get("places")?.as_array()?;
        let places: Option<Vec<u64>> = places.iter().map(Value::as_u64).collect();
        let share = Share { part, places: places? };
        let sound = 1 <= part.0 && part.0 <= part.1 && share.places.len() == rows;
        sound.then_some(share)
    }

    /// Whether shares leave nothing out.
    pub fn cover<'a>(shares: impl Iterator<Item = &'a Share>) -> bool {
        let mut parts: Vec<(u128, u128)> =
            shares.map(|share| (share.part.0.into(), share.part.1.into())).collect();
        // By where they begin: (I - 1) / N.
        parts.sort_by(|(i, n), (j, m)| ((i - 1) * m).cmp(&((j - 1) * n)));
        let mut reached = (0, 1);
        for (part, parts) in parts {
            if (part - 1) * reached.1 > reached.0 * parts {
                return false;
            }
            if part * reached.1 > reached.0 * parts {
                reached = (part, parts);
            }
        }
        reached.0 == reached.1
    }
}

impl Part {
    /// What folder and machine it is of: parts for which this is the same were measured together.
    pub fn run(&self) -> (String, Option<Value>, Option<Value>) {
        let label = self.environment.get("label").cloned();
        (self.folder.clone(), identity(&self.environment), label)
    }

    /// A part for each source, where it was put together from several before. Rows that name none
    /// of them are of an unknown machine.
    pub fn by_source(mut self) -> Vec<Part> {
        let Some(Value::Array(sources)) = self.environment.get(SOURCES).cloned() else {
            return vec![self];
        };
        let mut rows = std::mem::take(&mut self.rows);
        self.environment = Value::Null;
        let mut parts: Vec<Part> = Vec::new();
        for source in sources {
            let label = source.get("label").and_then(Value::as_str).unwrap_or_default();
            let (mine, others) = rows.into_iter().partition(|row| row.machine == label);
            rows = others;
            let mut environment = source.get("environment").cloned().unwrap_or_default();
            if environment.is_object() {
                // Tells apart what was measured several times.
                environment["label"] = label.into();
            }
            parts.push(self.with(mine, environment));
        }
        parts.push(self.with(rows, Value::Null));
        parts.retain(|part| !part.rows.is_empty());
        parts
    }

    /// The same with other rows, of one source.
    fn with(&self, rows: Vec<Row>, environment: Value) -> Part {
        let unnamed = |row: Row| Row { machine: String::new(), ..row };
        let rows = rows.into_iter().map(unnamed).collect();
        Part { rows, environment, share: None, ..self.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn share(part: u64, parts: u64) -> Share {
        Share { part: (part, parts), places: Vec::new() }
    }

    #[test]
    fn shares_cover_the_whole_or_leave_a_gap() {
        let cover = |shares: &[Share]| Share::cover(shares.iter());
        assert!(cover(&[share(1, 1)]));
        assert!(cover(&[share(3, 3), share(1, 3), share(2, 3)]));
        assert!(cover(&[share(1, 2), share(2, 4), share(3, 4), share(4, 4)]));
        assert!(!cover(&[share(1, 3), share(3, 3)]));
        assert!(!cover(&[share(2, 3), share(3, 3)]));
        assert!(!cover(&[share(1, 3), share(2, 3)]));
        assert!(!cover(&[]));
    }

    #[test]
    fn a_share_that_does_not_fit_its_rows_is_none() {
        let field = serde_json::json!({ "part": "2/3", "places": [4, 4, 5] });
        let expected = Share { part: (2, 3), places: vec![4, 4, 5] };
        assert_eq!(Share::of(Some(&field), 3), Some(expected));
        assert_eq!(Share::of(Some(&field), 2), None);
        for part in ["0/3", "4/3", "1/0", "a", "1"] {
            let field = serde_json::json!({ "part": part, "places": [] });
            assert_eq!(Share::of(Some(&field), 0), None, "{part}");
        }
        assert_eq!(Share::of(None, 0), None);
    }
}
