//! Several machines, builds and measurements.

use super::support::*;
use crate::chart::Figure;
use crate::results::{Chapter, drawings};
use serde_json::json;

#[test]
fn machines_builds_and_measurements_are_told_apart() {
    let place = Place::new();
    let row = |ns| [timed("wald", 0.0, ns)];
    place.run("p", &environment("P", "3"), "b-4.2", &row(2.0), ended());
    place.run("slow", &environment("P", "2"), "b-4.2", &row(3.0), ended());
    place.run("again", &environment("P", "3"), "b-4.2", &row(2.1), ended());
    place.run("q", &environment("Q", "3"), "b-4.2", &row(9.0), ended());
    let results = place.load(&["p", "slow", "again", "q"]).expect("they are there");
    let labels: Vec<&str> = results.sources.iter().map(|one| one.label.as_str()).collect();
    let expected =
        ["P (x86_64, opt-level 3)", "P (x86_64, opt-level 2)", "P (x86_64, opt-level 3) #2", "Q"];
    assert_eq!(labels, expected);
    let rows = &results.chapters[0].rows;
    let told: Vec<_> = rows.iter().map(|row| (row.machine.as_str(), row.ns_per_test)).collect();
    let times = [2.0, 3.0, 2.1, 9.0].map(Some);
    assert_eq!(told, expected.into_iter().zip(times).collect::<Vec<_>>());
    // The same folder twice is no second measurement.
    assert_eq!(place.load(&["p", "p"]).expect("there").sources.len(), 1);
}

#[test]
fn what_does_not_say_where_it_is_from_is_put_together_with_nothing() {
    let place = Place::new();
    place.run("a", &json!({}), "b-4.2", &[timed("wald", 0.0, 2.0)], ended());
    place.run("b", &json!({}), "b-4.2", &[timed("wald", 1.0, 2.0)], ended());
    let results = place.load(&["a", "b"]).expect("they are there");
    let labels: Vec<&str> = results.sources.iter().map(|one| one.label.as_str()).collect();
    assert_eq!(labels, ["unknown machine", "unknown machine #2"]);
}

#[test]
fn what_was_put_together_can_be_read_again() {
    let place = Place::new();
    let (p, q) = (environment("P", "3"), environment("Q", "3"));
    place.run("p", &p, "b-4.2", &[timed("wald", 0.0, 2.0)], ended());
    place.run("again", &p, "b-4.2", &[timed("wald", 0.0, 2.5)], ended());
    place.run("q", &q, "b-4.2", &[timed("wald", 0.0, 3.0)], ended());
    let first = place.load(&["p", "again", "q"]).expect("they are there");
    let sources: Vec<_> = first
        .sources
        .iter()
        .map(|one| json!({ "label": one.label, "environment": one.environment }))
        .collect();
    let both = json!({ "sources": sources });
    place.run("both", &both, "b-4.2", &first.chapters[0].rows, ended());
    let second = place.load(&["both"]).expect("it is there");
    assert_eq!(second.chapters[0].rows, first.chapters[0].rows);
    let mut strange = first.chapters[0].rows.clone();
    strange[2].machine = "R".into();
    place.run("strange", &both, "b-4.2", &strange, ended());
    let strange = place.load(&["strange"]).expect("it is there");
    let last = strange.sources.last().map(|one| one.label.as_str());
    assert_eq!((last, strange.rows().count()), (Some("unknown machine"), 3));
    let pairs = second.sources.iter().zip(&first.sources);
    for (second, first) in pairs {
        assert_eq!((&second.label, &second.environment), (&first.label, &first.environment));
    }
}

fn figure(file: &str, x: &str) -> Figure {
    let text =
        format!("file = '{file}'\nkind = 'bars'\nquestion = 'Which?'\nx = '{x}'\ny = 'seconds'");
    toml::from_str(&text).expect("a figure")
}

fn chapter(place: &Place, runs: &[&str]) -> (Chapter, Vec<crate::results::Source>) {
    let mut results = place.load(runs).expect("they are there");
    let mut chapter = results.chapters.remove(0);
    chapter.about.figures = vec![figure("each", "density"), figure("all", "machine")];
    (chapter, results.sources)
}

#[test]
fn a_figure_is_drawn_for_each_machine_unless_it_names_them() {
    let place = Place::new();
    for processor in ["P", "Q"] {
        let rows = [timed("wald", 0.0, 2.0), timed("wald", 1.0, 3.0)];
        place.run(processor, &environment(processor, "3"), "b-4.2", &rows, ended());
    }
    let (both, sources) = chapter(&place, &["P", "Q"]);
    let of_both: Vec<_> = drawings(&both, &sources)
        .into_iter()
        .map(|one| {
            (one.file, one.machine, one.rows.len(), one.figure.subtitle.contains("Machine: "))
        })
        .collect();
    let expected = [("each--1", "P", 2, true), ("each--2", "Q", 2, true), ("all", "", 4, false)];
    assert_eq!(
        of_both,
        expected.map(|(file, machine, rows, told)| (file.to_owned(), machine, rows, told))
    );
    let (one, sources) = chapter(&place, &["Q"]);
    let files: Vec<_> = drawings(&one, &sources).into_iter().map(|one| one.file).collect();
    assert_eq!(files, ["each", "all"]);
}

#[test]
fn a_machine_keeps_its_number_where_others_have_no_rows() {
    let place = Place::new();
    let (p, q) = (environment("P", "3"), environment("Q", "3"));
    place.run("P", &p, "h-11", &[exact("wald", 1, 0.5)], ended());
    place.run("Q", &q, "b-4.2", &[timed("wald", 0.0, 2.0)], ended());
    let (chapter, sources) = chapter(&place, &["P", "Q"]);
    let files: Vec<_> = drawings(&chapter, &sources).into_iter().map(|one| one.file).collect();
    assert_eq!(files, ["each--2", "all"]);
}
