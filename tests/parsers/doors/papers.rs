//! What is published, as data.

use ray_test::chart::{Measure, Published};
use ray_test::claims::{Ledger, judge, to_csv};
use ray_test::table::Row;

/// A paper's claims, judged by some rows, or its numbers.
pub fn papers(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    if let Ok(ledger) = Ledger::from_files(&[("paper.toml", text)]) {
        let rows = rows();
        to_csv(&judge(&ledger, &rows.iter().collect::<Vec<_>>()));
    }
    if let Ok(published) = Published::from_json(text) {
        for table in published.tables() {
            published.points(table, Measure::Seconds);
            published.points(table, Measure::Share);
            published.points(table, Measure::Count);
            published.meaning(table, "0");
        }
    }
}

/// Times over densities, of two kernels.
fn rows() -> Vec<Row> {
    let row = |kernel: &str, density: f64| Row {
        id: format!("{kernel}/f32/single/sse2/early/last/plain/t"),
        experiment: "b-4.2".into(),
        kernel: kernel.into(),
        order: "literal".into(),
        density: Some(density),
        ns_per_test: Some(4.0 + density),
        ns_low: Some(3.9 + density),
        ns_high: Some(4.1 + density),
        ratio_to_reference: Some(1.0 + density),
        ratio_low: Some(0.99 + density),
        ratio_high: Some(1.01 + density),
        p_value: Some(1e-9),
        status: "ok".into(),
        ..Row::default()
    };
    let densities = [0.0, 0.25, 0.5, 0.75, 1.0];
    ["moller1", "badouel"].iter().flat_map(|kernel| densities.map(|d| row(kernel, d))).collect()
}
