//! Invented rows with a known answer, for each demand.

mod demands;
mod ranking;

use super::{KnownVariant, Needs, Packets, Question, RecommendError, Recommendation, recommend};
use crate::results::{About, Chapter, Results};
use crate::table::Row;

/// A timed row of a single ray; the ratio's interval is 1 % wide to both sides.
fn timed(kernel: &str, precision: &str, output: &str, ratio: f64) -> Row {
    Row {
        experiment: "first".into(),
        id: format!("{kernel}/{precision}/single/sse2/early/last/plain/{output}"),
        kernel: kernel.into(),
        precision: precision.into(),
        drive: "single".into(),
        level: "sse2".into(),
        division: "last".into(),
        rounding: "plain".into(),
        output: output.into(),
        stored: "vertices".into(),
        workload: "nearest-random".into(),
        order: "reshuffled".into(),
        query: "ray".into(),
        status: "ok".into(),
        ns_per_test: Some(10.0 * ratio),
        cycles_per_test: Some(30.0 * ratio),
        cycles_low: Some(29.7 * ratio),
        cycles_high: Some(30.3 * ratio),
        ratio_to_reference: Some(ratio),
        ratio_low: Some(0.99 * ratio),
        ratio_high: Some(1.01 * ratio),
        ..Row::default()
    }
}

fn in_order(order: &str, row: Row) -> Row {
    Row { order: order.into(), ..row }
}

fn in_experiment(experiment: &str, row: Row) -> Row {
    Row { experiment: experiment.into(), ..row }
}

fn results(rows: Vec<Row>) -> Results {
    let about = About {
        id: "first".into(),
        title: String::new(),
        mirrors: String::new(),
        question: String::new(),
        why: String::new(),
        config: String::new(),
        command: String::new(),
        claims: Vec::new(),
        figures: Vec::new(),
    };
    let chapter = Chapter { about, rows, complete: true, workload_hash: String::new() };
    Results { chapters: vec![chapter], ..Results::default() }
}

/// All variants of the rows: available, not watertight, without limits.
fn known(rows: &[Row]) -> Vec<KnownVariant> {
    let variant = |row: &Row| KnownVariant {
        id: row.id.clone(),
        available: true,
        call: format!("call {}", row.id),
        ..KnownVariant::default()
    };
    rows.iter().map(variant).collect()
}

fn asked(rows: &[Row], question: &Question) -> Result<Recommendation, RecommendError> {
    recommend(&results(rows.to_vec()), question, &known(rows))
}

/// The kernel that is recommended.
fn kernel(rows: &[Row], question: &Question) -> String {
    let found = asked(rows, question).expect("something fits");
    found.variant.split('/').next().unwrap_or_default().to_owned()
}

fn says(found: &Recommendation, words: &str) -> bool {
    found.because.iter().any(|sentence| sentence.contains(words))
}
