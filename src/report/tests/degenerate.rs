//! Results that hold little or nothing.

use super::*;
use crate::report::numbers::figure_csv;

const KINDS: [&str; 6] = [
    TIMES,
    "file = \"l\"\nkind = \"lines\"\nquestion = \"L?\"\nx = \"density\"\ny = \"ns_per_test\"",
    "file = \"s\"\nkind = \"shares\"\nquestion = \"S?\"\nx = \"code\"\ny = \"share\"",
    "file = \"c\"\nkind = \"counts\"\nquestion = \"C?\"",
    "file = \"p\"\nkind = \"precision\"\nquestion = \"P?\"\nx = \"err_b_p99\"\ny = \"ns_per_test\"",
    "file = \"h\"\nkind = \"heat\"\nquestion = \"H?\"\nx = \"family\"\ny = \"knee_share\"",
];

fn all(results: &Results) -> [String; 3] {
    let findings = [finding("B-1", "", Verdict::NotTestable, true)];
    [html(results, &findings), markdown(results, &findings), terminal(results, &findings)]
}

#[test]
fn nothing_at_all_is_said_to_be_nothing() {
    for text in all(&Results::default()) {
        assert!(text.contains("There are no experiments") || text.contains("There are no rows"));
    }
}

#[test]
fn no_rows_one_row_and_rows_without_values_are_drawn_as_what_they_are() {
    let empty = Row { experiment: "first".into(), ..Row::default() };
    let zero = Row {
        density: Some(0.0),
        code: Some(0),
        share: Some(0.0),
        err_b_p99: Some(0.0),
        family: "needle".into(),
        knee_share: Some(1.0),
        ..timed("a", 0.0)
    };
    let negative = Row { err_b_p99: Some(-1.0), ..timed("b", -1.0) };
    for rows in
        [vec![], vec![empty], vec![zero.clone()], vec![negative.clone()], vec![zero, negative]]
    {
        let results = results(rows.clone(), &KINDS);
        let [page, ..] = all(&results);
        assert_eq!(page.matches("<svg ").count(), KINDS.len());
        assert!(!page.contains("NaN") && !page.contains(">inf"), "{rows:?}");
        for text in KINDS {
            figure_csv(&figure(text), &rows).unwrap();
        }
        if rows.is_empty() {
            // In the picture, in its description and below it.
            assert_eq!(page.matches("Not drawn: there are no rows.").count(), 3 * KINDS.len());
        }
    }
}

#[test]
fn a_figure_that_cannot_be_drawn_says_why_and_the_rest_stands() {
    let results = results(vec![timed("a", 2.0), timed("a", 3.0)], &[TIMES, KINDS[3]]);
    let [page, ..] = all(&results);
    assert!(page.contains("several rows are for"));
    assert_eq!(page.matches("<figure ").count(), 2);
}

#[test]
fn the_terminal_has_a_hundred_columns_whatever_is_said() {
    let mut long = timed("a", 2.0);
    long.status = "wrong-result".into();
    let mut results = results(vec![timed("b", 2.0), long], &[]);
    results.chapters[0].complete = false;
    let findings = [Finding {
        statement: "word ".repeat(60),
        ..finding("B-1", "literal", Verdict::Undecided, true)
    }];
    let text = terminal(&results, &findings);
    assert!(widest(&text) <= 100, "{text}");
    assert!(!text.contains('\u{1b}'));
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for words in
        ["undecided (literal)", "WRONG: 1 row is of a kernel", "! WRONG RESULTS", "not complete"]
    {
        assert!(text.contains(words), "{words}: {text}");
    }
}
