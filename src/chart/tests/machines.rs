//! Table 4.3: groups that are machines, ours and the thesis's.

use super::*;

fn config() -> Vec<Figure> {
    #[derive(serde::Deserialize)]
    struct Experiment {
        figure: Vec<Figure>,
    }
    let text = include_str!("../../../configs/b-4.3.toml");
    toml::from_str::<Experiment>(text).expect("the experiment's own").figure
}

/// Rows of density 0, as the experiment writes them: seconds of Möller, Badouel and Chirkov.
fn of_machine(machine: &str, seconds: [f64; 3]) -> Vec<Row> {
    let kernels = ["moller1", "badouel", "chirkov-line"];
    let one = |(kernel, seconds): (&str, f64)| Row {
        machine: machine.into(),
        order: "literal".into(),
        density: Some(0.0),
        seconds_mean: Some(seconds),
        ..row("b-4.3", kernel)
    };
    kernels.into_iter().zip(seconds).map(one).collect()
}

#[test]
fn one_machine_stands_beside_the_thesiss_four() {
    for figure in config() {
        let svg = drawn(&figure, &of_machine("", [2.0, 3.0, 1.5]));
        assert!(svg.contains("(this machine, Chirkov)"), "{}", figure.file);
        let texts = boxes::texts(&svg);
        let count = |words: &str| texts.iter().filter(|text| text.words == words).count();
        for group in ["this machine", "Athlon 64 3000+ (2007)", "Core 2 Duo E6600 (2007)"] {
            assert_eq!(count(group), 1, "{}: {group}", figure.file);
        }
        assert_eq!(count("Chirkov"), 5);
    }
}

#[test]
fn each_machine_is_divided_by_its_own_moller() {
    let rows =
        [of_machine("fast", [2.0, 3.0, 1.5]), of_machine("slow", [20.0, 31.0, 21.0])].concat();
    let texts = boxes::texts(&drawn(&config()[0], &rows));
    let has = |words: &str| texts.iter().any(|text| text.words == words);
    // Ours, and the thesis's pc1: 45.268 / 34.228 and 30.703 / 34.228.
    for value in ["1.50", "0.750", "1.55", "1.05", "1.32", "0.897"] {
        assert!(has(value), "{value}");
    }
    // What it is divided by is 1, whatever rounding does to inverses.
    assert!(!has("1.000") && has("1.00"));
    assert!(has("fast") && has("slow") && !has("this machine"));
}

#[test]
fn a_unit_without_a_kernel_to_divide_by_is_refused() {
    let figure = Figure { normalise_to: None, ..config().swap_remove(0) };
    let error = figure.validate(&published()).expect_err("there is no unit").to_string();
    assert!(error.contains("normalise") && error.contains("normalise_to"), "{error}");
}

#[test]
fn without_the_unit_the_picture_says_so() {
    let mut rows = of_machine("", [2.0, 3.0, 1.5]);
    rows.retain(|row| row.kernel != "moller1");
    let svg = drawn(&config()[0], &rows);
    assert!(svg.contains("there is no value of moller1 to divide by"));
}
