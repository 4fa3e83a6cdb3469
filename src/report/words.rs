//! Numbers and lists in words.

use crate::chart::short_figure;

/// `1.23 [1.20, 1.25]`, the interval only where there is one that has a width.
pub(super) fn with_interval(value: f64, interval: Option<(f64, f64)>) -> String {
    let (middle, ends) = (short_figure(value), interval.map(|(low, high)| between(low, high)));
    ends.map_or(middle.clone(), |ends| format!("{middle} {ends}"))
}

/// `[1.20, 1.25]`
pub(super) fn between(low: f64, high: f64) -> String {
    format!("[{}, {}]", short_figure(low), short_figure(high))
}

/// A share of 1 as percent: three digits, and no more decimals than two.
pub(super) fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent != 0.0 && percent.abs() < 0.005 {
        return "under 0.01 %".to_owned();
    }
    let decimals = match percent.abs() {
        size if size >= 10.0 => 0,
        size if size >= 1.0 => 1,
        _ => 2,
    };
    format!("{percent:.decimals$} %")
}

/// `a, b and c`
pub(super) fn listed(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [only] => only.clone(),
        [before @ .., last] => format!("{} and {last}", before.join(", ")),
    }
}

/// The first few of some names, and how many more there are.
pub(super) fn first_of(names: &[String], most: usize) -> String {
    if names.len() <= most + 1 {
        return listed(names);
    }
    format!("{} and {} more", names[..most].join(", "), names.len() - most)
}

/// `1 row`, `2 rows`
pub(crate) fn count(number: usize, one: &str, several: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { several })
}

/// With a capital at the start.
pub(super) fn capital(words: &str) -> String {
    let mut characters = words.chars();
    let first = characters.next().map(|first| first.to_uppercase().collect::<String>());
    first.map_or(String::new(), |first| first + characters.as_str())
}

/// A cell of a Markdown table.
pub(super) fn cell(text: &str) -> String {
    text.replace('\\', "\\\\").replace('|', "\\|").split_whitespace().collect::<Vec<_>>().join(" ")
}
