//! Shards of a run are one source, and stand in the order of the unsplit run.

use super::support::*;
use crate::table::Row;
use serde_json::{Value, json};

/// The unsplit run: rows of three forms and two seeds, in an order that no column gives; the last
/// form has two rows for each of its tasks.
fn whole() -> (Vec<u64>, Vec<Row>) {
    let mut rows = Vec::new();
    for seed in [5, 6] {
        for (form, id) in ["wald", "badouel", "keidy"].into_iter().enumerate() {
            let place = (seed - 5) * 3 + form as u64;
            let error = 1e-7 / (1.0 + place as f64 * 0.3);
            rows.push((place, exact(id, seed, error)));
            if id == "keidy" {
                let against = "moller-trumbore-f64".into();
                rows.push((place, Row { err_against: against, ..exact(id, seed, error * 2.0) }));
            }
        }
    }
    rows.into_iter().unzip()
}

/// What a file says that holds so many of the rows.
fn share(part: &str, places: &[u64]) -> Value {
    json!({ "complete": true, "shard": { "part": part, "places": places } })
}

/// A place with the unsplit run, and shards of it as `1`, `2` ...: rows of these numbers.
fn split(shards: &[&[usize]]) -> Place {
    let place = Place::new();
    let machine = environment("P", "3");
    let (places, rows) = whole();
    place.run("whole", &machine, "h-11", &rows, ended());
    for (number, indices) in shards.iter().enumerate() {
        let part = format!("{}/{}", number + 1, shards.len());
        let mine: Vec<Row> = indices.iter().map(|index| rows[*index].clone()).collect();
        let places: Vec<u64> = indices.iter().map(|index| places[*index]).collect();
        let run = (number + 1).to_string();
        place.run(&run, &machine, "h-11", &mine, share(&part, &places));
    }
    place
}

#[test]
fn merged_rows_are_the_unsplit_ones_bit_for_bit_in_any_order() {
    // A task is never split. One after the other, and one form here and two there.
    for shards in [[&[0usize, 1][..], &[2, 3, 4], &[5, 6, 7]], [&[0, 4], &[1, 5], &[2, 3, 6, 7]]] {
        let place = split(&shards);
        let whole = place.csv(&place.load(&["whole"]).expect("it is there").chapters[0].rows);
        for order in [["1", "2", "3"], ["3", "1", "2"], ["2", "3", "1"]] {
            let results = place.load(&order).expect("they are there");
            assert_eq!(results.sources.len(), 1);
            assert_eq!(results.sources[0].folders.len(), 3);
            assert!(results.chapters[0].complete);
            assert!(place.csv(&results.chapters[0].rows) == whole, "{order:?}");
        }
    }
}

#[test]
fn rows_that_are_there_twice_count_once() {
    let place = split(&[&[0, 1, 2, 3], &[2, 3, 4, 5, 6, 7]]);
    let rows = |runs: &[&str]| place.load(runs).expect("they are there").chapters[0].rows.clone();
    let whole = rows(&["whole"]);
    assert_eq!(rows(&["2", "1", "2"]), whole);
    assert_eq!(rows(&["1", "whole", "2"]), whole);
}

#[test]
fn a_missing_part_is_not_complete() {
    let place = split(&[&[0, 1], &[2, 3, 4], &[5, 6, 7]]);
    for (runs, complete) in [(&["1", "3"][..], false), (&["2"], false), (&["1", "3", "2"], true)] {
        assert_eq!(place.load(runs).expect("there").chapters[0].complete, complete, "{runs:?}");
    }
}

#[test]
fn different_experiments_of_one_machine_are_one_source() {
    let place = split(&[&[0, 1, 2, 3, 4, 5, 6, 7]]);
    let machine = environment("P", "3");
    place.run("times", &machine, "b-4.2", &[timed("wald", 0.0, 2.0)], ended());
    place.run("more", &machine, "b-4.2", &[timed("wald", 1.0, 3.0)], ended());
    let results = place.load(&["whole", "times", "more"]).expect("they are there");
    assert_eq!(results.sources.len(), 1);
    let ids: Vec<&str> = results.chapters.iter().map(|one| one.about.id.as_str()).collect();
    assert_eq!(ids, ["b-4.2", "h-11"]);
    assert_eq!(results.chapters[0].rows.len(), 2);
    assert!(results.rows().all(|row| row.machine.is_empty()));
}

#[test]
fn another_text_is_another_measurement() {
    let place = split(&[&[0, 1, 2, 3], &[4, 5, 6, 7]]);
    write(&place.0.join("1/h-11/experiment.toml"), "of before");
    assert_eq!(place.load(&["1", "2"]).expect("they are there").sources.len(), 1);
    write(&place.0.join("2/h-11/experiment.toml"), "of after");
    assert_eq!(place.load(&["1", "2"]).expect("they are there").sources.len(), 2);
}

#[test]
fn where_no_clock_was_read_the_build_is_enough() {
    let place = split(&[&[0, 1, 2, 3], &[4, 5, 6, 7]]);
    let (places, rows) = whole();
    let second = share("2/2", &places[4..]);
    place.run("q", &environment("Q", "3"), "h-11", &rows[4..], second.clone());
    place.run("slow", &environment("Q", "2"), "h-11", &rows[4..], second);
    let of = |runs: &[&str]| place.load(runs).expect("they are there");
    let results = of(&["1", "q"]);
    assert_eq!((results.sources.len(), results.sources[0].label.as_str()), (1, "P"));
    assert_eq!(results.chapters[0].rows, rows);
    assert_eq!(of(&["1", "slow"]).sources.len(), 2);
    // Another machine's times beside them make it another machine.
    place.run("q", &environment("Q", "3"), "b-4.2", &[timed("wald", 0.0, 2.0)], ended());
    assert_eq!(of(&["1", "q"]).sources.len(), 2);
}
