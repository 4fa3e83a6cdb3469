//! Upright lines at values of x.

use super::*;
use crate::chart::figure::Names;

const SIZES: &str = r#"
    file = "marks"
    kind = "lines"
    question = "What does it cost when the triangles do not fit the cache?"
    x = "set_bytes"
    x_scale = "log"
    x_marks = ["l1_bytes", "l2_bytes", "l3_bytes"]
    y = "ns_per_test"
    labels = { l1_bytes = "L1" }
"#;

#[test]
fn values_of_x_are_marked_where_they_lie_on_the_axis() {
    let mut figure = figure(SIZES);
    let sizes = [9_000, 40_000, 300_000, 9_000_000];
    let sized = |bytes: &u64| Row {
        set_bytes: Some(*bytes),
        l1_bytes: Some(49_152),
        l2_bytes: Some(8_000_000),
        l3_bytes: Some(1 << 30),
        ..timed(row("memory", "wald"), *bytes as f64)
    };
    let rows: Vec<Row> = sizes.iter().map(sized).collect();
    let svg = drawn(&figure, &rows);
    let texts = boxes::texts(&svg);
    let count = |words: &str| texts.iter().filter(|text| text.words == words).count();
    assert_eq!([count("L1"), count("l2 bytes"), count("l3 bytes")], [1, 1, 0]);
    figure.x_marks = Names::default();
    assert!(!boxes::texts(&drawn(&figure, &rows)).iter().any(|text| text.words == "L1"));
}
