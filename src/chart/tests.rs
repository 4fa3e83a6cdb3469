//! Each kind of chart on rows that are hard to draw: well-formed, described, nothing cut off and
//! no two texts over each other.

use super::*;
use std::collections::BTreeMap;

mod boxes;
mod kinds;
mod machines;
mod marks;
mod precision;
mod refused;
mod stability;
mod timeline;

/// A figure from the text of its TOML table.
fn figure(text: &str) -> Figure {
    toml::from_str(text).unwrap()
}

fn published() -> Published {
    Published::embedded().unwrap()
}

/// Draws, and keeps the picture where `RAY_TEST_FIGURES` names a folder, to be looked at.
fn drawn(figure: &Figure, rows: &[Row]) -> String {
    let svg = draw(figure, rows, &published()).unwrap();
    if let Ok(folder) = std::env::var("RAY_TEST_FIGURES") {
        std::fs::write(format!("{folder}/{}.svg", figure.file), &svg).unwrap();
    }
    boxes::check(&svg);
    svg
}

/// A row as an experiment writes it.
fn row(experiment: &str, kernel: &str) -> Row {
    Row {
        experiment: experiment.into(),
        kernel: kernel.into(),
        status: "ok".into(),
        triangles: Some(1000),
        rounds: Some(64),
        seed: Some(7),
        ..Row::default()
    }
}

/// The same with a time of `ns` and an interval of two percent.
fn timed(row: Row, ns: f64) -> Row {
    Row {
        ns_per_test: Some(ns),
        ns_low: Some(ns * 0.99),
        ns_high: Some(ns * 1.01),
        mtests_per_s: Some(1e3 / ns),
        seconds: Some(ns * 0.5),
        ..row
    }
}
