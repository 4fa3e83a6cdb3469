//! The figures of the stability sweep, with as many series and families as there may be.

use super::*;

const KERNELS: usize = 30;
const FAMILIES: [&str; 18] = [
    "needle",
    "cap",
    "sliver",
    "mixed-scale",
    "compound",
    "tiny",
    "subnormal",
    "huge",
    "short-direction",
    "long-direction",
    "random-exponents",
    "far",
    "gis",
    "far-origin",
    "near-plane",
    "grazing",
    "grazing-axis",
    "near-edge",
];

fn form(kernel: usize) -> Row {
    let name = format!("a-kernel-of-some-length-{kernel}");
    Row { precision: "f32".into(), form: name.clone(), ..row("stability", &name) }
}

/// Kernel 0 to 9 as good as the inputs allow, the others each ten times as bad as the one before.
fn cells(family: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    for kernel in 0..KERNELS {
        for knob in 0..=8 {
            let size = 10f64.powi(knob);
            let worse = 10f64.powi((kernel as i32 - 9).max(0));
            rows.push(Row {
                record: "cases".into(),
                family: family.into(),
                knob: Some(f64::from(knob)),
                err_t_p99_rel: Some(1e-7 * worse),
                err_b_p99: (knob < 6 || kernel < 20).then_some(1e-7 * size * worse),
                kappa_t_p99: Some(2.0),
                kappa_b_p99: Some(2.0 * size),
                ..form(kernel)
            });
        }
    }
    rows
}

fn knees() -> Vec<Row> {
    let inputs = Row { kernel: String::new(), form: "(inputs)".into(), ..form(0) };
    let mut rows = Vec::new();
    for (place, family) in FAMILIES.iter().enumerate() {
        for kernel in 0..=KERNELS {
            let blank = kernel.checked_sub(1).map_or_else(|| inputs.clone(), form);
            let knee = (kernel + place) % 12;
            rows.push(Row {
                record: "knee".into(),
                family: (*family).into(),
                knee: (knee < 10).then_some(knee as f64),
                knee_share: Some((knee as f64 / 10.0).min(1.0)),
                ..blank
            });
        }
    }
    rows
}

fn leaks() -> Vec<Row> {
    let mut rows = Vec::new();
    for kernel in 0..KERNELS {
        for class in ["random", "edge", "vertex", "exact edge", "exact vertex"] {
            let none = kernel % 3 == 0;
            rows.push(Row {
                record: "leaks".into(),
                ray_class: class.into(),
                leaks_per_million: Some(if none { 0.0 } else { 3f64.powi(kernel as i32 / 3) }),
                leaks_bound_per_million: none.then_some(2.5),
                ..form(kernel)
            });
        }
    }
    rows
}

#[test]
fn every_figure_of_a_sweep_is_readable() {
    let mut rows = knees();
    rows.extend(leaks());
    rows.extend(cells("needle"));
    let figures = stability_figures(&rows);
    assert_eq!(figures.len(), 2 + FAMILIES.len());
    let of = |file: &str| figures.iter().find(|figure| figure.file == file).expect(file);
    let knees = boxes::texts(&drawn(of("knees-f32"), &rows));
    // The row that stands apart is the first one.
    let height = |words: &str| knees.iter().find(|text| text.words == words).unwrap().bottom;
    assert!(height("(inputs)") < height("a-kernel-of-some-length-0"));
    let dashes = knees.iter().filter(|text| text.words == "–").count();
    let never = rows.iter().filter(|row| row.record == "knee" && row.knee.is_none()).count();
    assert_eq!(dashes, never);
    let leaks = boxes::texts(&drawn(of("leaks-f32"), &rows));
    assert_eq!(leaks.iter().filter(|text| text.words == "< 2.50").count(), 5 * KERNELS / 3);
    let errors = boxes::texts(&drawn(of("needle-f32"), &rows));
    let has = |words: &str| errors.iter().filter(|text| text.words.contains(words)).count();
    // In both panels ten, and the one that is no digit worse, are drawn together.
    assert_eq!(has("the others (11), grey"), 2);
    assert_eq!(has("a-kernel-of-some-length-29"), 2);
    drawn(of("far-f32"), &rows);
}
