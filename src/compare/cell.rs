//! Which row of one side is about the same as which row of the other.

use std::collections::{HashMap, HashSet};

use super::side::Side;
use crate::table::{Row, SETTING_COLUMNS, SUBJECT_COLUMNS};

/// The value of each of [`SETTING_COLUMNS`]; empty where there is none.
pub(super) type Settings = Vec<String>;

/// A row taken apart into what it is about.
pub(super) struct Entry<'a> {
    /// What was measured, level aside.
    pub name: String,
    /// On what.
    pub settings: Settings,
    /// The row.
    pub row: &'a Row,
}

impl<'a> Entry<'a> {
    fn of(row: &'a Row) -> Self {
        let mut name = row.texts(&SUBJECT_COLUMNS);
        name.push(without_level(&row.id));
        // No value holds this separator, so that no two names run together.
        Entry { name: name.join("\u{1f}"), settings: row.texts(&SETTING_COLUMNS), row }
    }
}

/// An id with its fourth axis, the level, left out.
fn without_level(id: &str) -> String {
    let axes = id.split('/').enumerate().filter(|(place, _)| *place != 3);
    axes.map(|(_, axis)| axis).collect::<Vec<_>>().join("/")
}

/// The cells of both sides, put together.
pub(super) struct Matched<'a> {
    /// Rows about the same, base first.
    pub pairs: Vec<(&'a Row, &'a Row)>,
    /// Rows of the base alone.
    pub missing: Vec<&'a Row>,
    /// Rows of the new side alone.
    pub added: Vec<&'a Row>,
    /// What both sides have, but under no settings in common: a row of the base, and the row of
    /// the new side whose settings are closest.
    pub apart: Vec<(Entry<'a>, Settings)>,
}

impl<'a> Matched<'a> {
    /// Of two sides.
    pub fn of(base: &'a Side, new: &'a Side) -> Self {
        let (base, new) = (entries(base), entries(new));
        let keyed: HashMap<_, _> =
            new.iter().map(|(count, entry)| (key(*count, entry), entry.row)).collect();
        let mut matched = Matched {
            pairs: Vec::new(),
            missing: Vec::new(),
            added: Vec::new(),
            apart: Vec::new(),
        };
        let (mut keys, mut names) = (HashSet::new(), HashSet::new());
        for (count, entry) in &base {
            let key = key(*count, entry);
            if let Some(row) = keyed.get(&key) {
                matched.pairs.push((entry.row, row));
                names.insert(entry.name.clone());
            } else {
                matched.missing.push(entry.row);
            }
            keys.insert(key);
        }
        let added = new.iter().filter(|(count, entry)| !keys.contains(&key(*count, entry)));
        matched.added = added.map(|(_, entry)| entry.row).collect();
        for (_, entry) in base {
            if !names.contains(&entry.name)
                && let Some(settings) = closest(&entry, &new)
            {
                matched.apart.push((entry, settings));
            }
        }
        matched
    }
}

/// The rows of a side, each with the number of equal ones before it: should there be any, they are
/// taken in their order.
fn entries(side: &Side) -> Vec<(usize, Entry<'_>)> {
    let mut seen: HashMap<(String, Settings), usize> = HashMap::new();
    let count = |row| {
        let entry = Entry::of(row);
        let before = seen.entry((entry.name.clone(), entry.settings.clone())).or_default();
        *before += 1;
        (*before - 1, entry)
    };
    side.rows().map(count).collect()
}

fn key(count: usize, entry: &Entry<'_>) -> (usize, String, Settings) {
    (count, entry.name.clone(), entry.settings.clone())
}

/// The settings of the same name that differ in the fewest columns.
fn closest(entry: &Entry<'_>, among: &[(usize, Entry<'_>)]) -> Option<Settings> {
    let differing = |other: &&Entry<'_>| {
        entry.settings.iter().zip(&other.settings).filter(|(a, b)| a != b).count()
    };
    let same_name = among.iter().map(|(_, other)| other).filter(|other| other.name == entry.name);
    same_name.min_by_key(differing).map(|other| other.settings.clone())
}
