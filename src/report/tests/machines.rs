//! Results of several machines.

use super::*;
use crate::results::drawings;

fn of(machine: &str, kernel: &str, ns: f64) -> Row {
    Row { machine: machine.into(), ..timed(kernel, ns) }
}

fn two() -> Results {
    let rows =
        vec![of("Z80", "a", 4.0), of("Z80", "b", 5.0), of("6502", "a", 7.0), of("6502", "b", 6.0)];
    let by_machine = TIMES
        .replace("panels = \"order\"", "panels = \"machine\"")
        .replace("\"times\"", "\"both\"");
    let mut results = results(rows, &[TIMES, &by_machine]);
    results.sources.push(source("6502"));
    results
}

#[test]
fn each_machine_has_its_answers_and_a_row() {
    let page = html(&two(), &[]);
    assert!(page.contains("Results of 2 machines or builds are put together here"));
    let place = |words: &str| page.find(words).expect(words);
    assert!(place("<h3>Z80</h3>") < place("<code>a/f32"));
    assert!(place("<h3>6502</h3>") < place("<code>b/f32"));
    assert!(page.contains("<th scope=\"row\">6502</th>"));
}

#[test]
fn a_figure_in_which_machines_clash_is_drawn_for_each() {
    let results = two();
    let drawn = drawings(&results.chapters[0], &results.sources);
    let files: Vec<&str> = drawn.iter().map(|drawing| drawing.file.as_str()).collect();
    assert_eq!(files, ["times--1", "times--2", "both"]);
    assert_eq!(drawn.iter().map(|drawing| drawing.rows.len()).collect::<Vec<_>>(), [2, 2, 4]);
    let page = html(&results, &[]);
    assert!(page.contains("id=\"fig-times--2\"") && !page.contains("several rows are for"));
    // With one machine, the figure keeps its name.
    let one = super::results(vec![timed("a", 1.0)], &[TIMES]);
    assert_eq!(drawings(&one.chapters[0], &one.sources)[0].file, "times");
}
