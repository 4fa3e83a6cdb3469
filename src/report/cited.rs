//! The line that a citation of the numbers needs.

use super::ReportError;
use super::machine::Machine;
use crate::results::Results;
use std::collections::BTreeSet;

/// Program, commit, seeds, hash of the rows, machines and dates. The version is that of the program
/// that measured; where no source says it, that of the program that writes.
pub(super) fn line(results: &Results, machines: &[Machine]) -> Result<String, ReportError> {
    let of = |value: fn(&Machine) -> &String| {
        let values: BTreeSet<&str> =
            machines.iter().map(|machine| value(machine).as_str()).collect();
        values.into_iter().filter(|value| !value.is_empty()).collect::<Vec<_>>().join(" and ")
    };
    let seeds: BTreeSet<u64> = results.rows().filter_map(|row| row.seed).collect();
    let seeds: Vec<String> = seeds.into_iter().map(|seed| seed.to_string()).collect();
    let version = of(|machine| &machine.version);
    let version = if version.is_empty() { env!("CARGO_PKG_VERSION").to_owned() } else { version };
    let hash = format!("data {:016x}", results.data_hash()?);
    let parts = [
        format!("ray_test {version}"),
        part("commit ", &of(|machine| &machine.commit)),
        part(if seeds.len() == 1 { "seed " } else { "seeds " }, &seeds.join(", ")),
        hash,
        of(|machine| &machine.label),
        of(|machine| &machine.date),
    ];
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    Ok(parts.join(", "))
}

fn part(before: &str, text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("{before}{text}") }
}
