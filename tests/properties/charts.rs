//! Any rows become a picture: of them, or of why there is none.

use super::picture::{finite, within};
use super::unit;
use ray_test::chart::{ChartError, Figure, Published, draw, placeholder, timeline};
use ray_test::experiment::Experiment;
use ray_test::table::{Round, Row};
use ray_test::workload::Pcg;

/// An experiment with figures of every kind, read as those of users are.
fn figures() -> Vec<Figure> {
    let text = include_str!("charts.toml");
    Experiment::parse("charts.toml", text).expect("the test's own text").figure
}

fn published() -> Published {
    Published::embedded().expect("it is part of the program")
}

/// Where the values of a picture come from.
type Values = fn(&mut Pcg) -> Option<f64>;

/// What can be measured, more or less.
const MEASURED: [(&str, Values); 5] = [
    ("usual", |pcg| Some(1.0 + unit(pcg))),
    ("alike", |_| Some(3.5)),
    ("of many sizes", |pcg| Some(10f64.powf(12.0 * unit(pcg) - 6.0))),
    ("missing, some", |pcg| (pcg.below(3) > 0).then(|| unit(pcg))),
    ("missing", |_| None),
];

/// What nobody measures, but files can hold.
const HELD: [(&str, Values); 8] = [
    ("zero", |_| Some(0.0)),
    ("huge", |pcg| Some(1e300 * (1.0 + unit(pcg)))),
    ("the largest", |_| Some(f64::MAX)),
    ("tiny", |pcg| Some(1e-300 * (1.0 + unit(pcg)))),
    ("subnormal", |_| Some(5e-324)),
    ("negative", |pcg| Some(-unit(pcg))),
    ("of both ends", |pcg| Some([f64::MAX, f64::MIN][pcg.below(2) as usize])),
    ("all sorts", |pcg| {
        Some([0.0, 1.0, -1e9, 1e-30, 1e30, f64::MAX, 5e-324][pcg.below(7) as usize])
    }),
];

/// Rows of some kernels over some densities, every figure of them from `values`.
fn rows(count: usize, values: Values, pcg: &mut Pcg) -> Vec<Row> {
    let row = |place: usize| {
        let mut one = || values(pcg);
        let [time, error, count] = [one(), one(), one()];
        Row {
            id: format!("k{}/f32/{place}", place % 3),
            experiment: "charts".into(),
            kernel: format!("k{}", place % 3),
            precision: ["f32", "f64"][place % 2].into(),
            order: "fixed".into(),
            density: Some((place / 3) as f64 / 8.0),
            code: Some((place / 3) as u64),
            ns_per_test: time,
            ns_low: time.map(|time| time * 0.99),
            ns_high: one(),
            ratio_to_reference: one(),
            ratio_low: one(),
            ratio_high: one(),
            seconds: one(),
            share: error,
            err_b_p99: error,
            err_b_p50: one(),
            err_b_max: one(),
            useful_lanes: one(),
            ops_add: count.map(|count| count as u64),
            ops_mul: Some(3),
            rounds: Some(64),
            status: "ok".into(),
            ..Row::default()
        }
    };
    (0..count).map(row).collect()
}

/// The picture of a figure, or of why it is none, as a run draws it.
fn picture(figure: &Figure, rows: &[Row]) -> String {
    match draw(figure, rows, &published()) {
        Err(error @ (ChartError::Ambiguous { .. } | ChartError::Wrong { .. })) => {
            placeholder(figure, &error.to_string()).expect("it has only words")
        }
        drawn => drawn.unwrap_or_else(|error| panic!("{}: {error}", figure.file)),
    }
}

#[test]
fn what_can_be_measured_lies_in_its_picture() {
    let mut pcg = Pcg::new(51);
    for (name, values) in MEASURED {
        for count in [0, 1, 2, 3, 9, 24] {
            let rows = rows(count, values, &mut pcg);
            for figure in figures() {
                println!("{name}, {count} rows, {}", figure.file);
                within(&picture(&figure, &rows));
            }
        }
    }
}

#[test]
fn what_files_can_hold_makes_a_picture_too() {
    let mut pcg = Pcg::new(52);
    for (name, values) in HELD {
        for count in [1, 2, 9, 24] {
            let rows = rows(count, values, &mut pcg);
            for figure in figures() {
                println!("{name}, {count} rows, {}", figure.file);
                finite(&picture(&figure, &rows));
            }
        }
    }
}

#[test]
fn any_word_can_stand_in_a_picture() {
    let words = [
        "",
        "<&>\"'",
        "]]>",
        "a\u{0}b",
        "\u{1b}[31m",
        "\u{fffe}",
        "\n\t",
        "\u{202e}abc",
        "NaN",
        "\u{1f600}",
    ];
    let mut pcg = Pcg::new(53);
    for word in words.into_iter().map(str::to_owned).chain(["long ".repeat(400)]) {
        let mut rows = rows(9, MEASURED[0].1, &mut pcg);
        for row in &mut rows {
            row.kernel = format!("{word}{}", row.kernel);
            row.order.push_str(&word);
            row.precision.push_str(&word);
        }
        for figure in figures() {
            println!("{word:?}, {}", figure.file);
            finite(&picture(&figure, &rows));
            let figure = Figure { question: format!("{word}?"), subtitle: word.clone(), ..figure };
            finite(&picture(&figure, &rows));
        }
    }
}

#[test]
fn rounds_of_any_time_make_a_picture() {
    let mut pcg = Pcg::new(54);
    for (name, values) in MEASURED.into_iter().chain(HELD) {
        for count in [0, 1, 2, 300] {
            let round = |number: u64| Round {
                experiment: format!("e{}", number / 100),
                cell: "0 fixed".into(),
                round: number,
                at_s: values(&mut pcg).unwrap_or(number as f64),
                // None at or below zero can be read.
                reference_ns_per_test: values(&mut pcg).filter(|ns| *ns > 0.0),
                state: ["clean", "crowded", "dirty"][number as usize % 3].into(),
            };
            let mut rounds: Vec<Round> = (0..count).map(round).collect();
            rounds.sort_by(|one, other| one.at_s.total_cmp(&other.at_s));
            println!("{name}, {count} rounds");
            finite(&timeline(&rounds, false).expect("whatever the rounds"));
        }
    }
}
