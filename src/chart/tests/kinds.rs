//! One figure of each kind and the hard cases.

use super::*;

const ORDERS: [&str; 3] = ["literal", "fixed", "reshuffled"];

const TIMES: &str = r#"
    file = "b-4.1"
    kind = "lines"
    question = "Which variant of the Möller algorithm is the fastest, and does that change with the hit density?"
    subtitle = "Time of moller0, moller1 and moller3 over the share of pairs that hit. Single f32, early exit, sse2."
    x = "density"
    y = "seconds"
    panels = "order"
    normalise_to = "moller1"
    published = { table = "table_4_1", note = "Athlon 64 3000+, 2007", panel = "literal" }
"#;

/// Times over density that nearly coincide in `fixed` and fall in `reshuffled`.
fn over_density(kernels: &[&str], steps: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    for (o, order) in ORDERS.iter().enumerate() {
        for (k, kernel) in kernels.iter().enumerate() {
            for step in 0..=steps {
                let density = step as f64 / steps as f64;
                let slope = [0.38, 0.05, -0.5][o];
                let ns = 2.0 * (1.0 + slope * density) + 0.012 * k as f64 + 1.5 * f64::from(o == 2);
                let row =
                    Row { density: Some(density), order: (*order).into(), ..row("b-4.1", kernel) };
                rows.push(timed(row, ns));
            }
        }
    }
    rows
}

#[test]
fn lines_that_nearly_coincide_in_three_panels() {
    let rows = over_density(&["moller0", "moller1", "moller3"], 4);
    let svg = drawn(&figure(TIMES), &rows);
    let texts = boxes::texts(&svg);
    let count = |words: &str| texts.iter().filter(|text| text.words == words).count();
    assert_eq!([count("moller0"), count("moller1"), count("moller3")], [3, 3, 3]);
    assert_eq!(count("order: literal"), 1);
    // 15 published figures, in one panel only; filled markers have no outline.
    assert_eq!(svg.matches("stroke-width=\"1.6\"").count(), 15);
    assert!(texts.iter().any(|text| text.words.contains("relative to moller1 at density 0")));
    assert!(texts.iter().any(|text| text.words.contains("hollow = published, table 4.1")));
}

#[test]
fn eleven_densities_and_eight_series() {
    let kernels = [
        "moller",
        "badouel",
        "chirkov",
        "wald",
        "plucker",
        "keidy",
        "kensler-shirley",
        "perpendicular-planes",
    ];
    let mut figure = figure(TIMES);
    (figure.file, figure.normalise_to) = ("eleven".into(), None);
    figure.published = None;
    figure.y = "ns_per_test".into();
    let svg = drawn(&figure, &over_density(&kernels, 10));
    let texts = boxes::texts(&svg);
    for density in ["0.1", "0.7", "1"] {
        assert!(texts.iter().filter(|text| text.words == density).count() >= 3, "{density}");
    }
}

#[test]
fn one_panel_with_magnitudes_apart_on_a_log_axis() {
    let mut figure = figure(TIMES);
    (figure.file, figure.scale) = ("magnitudes".into(), Scale::Log);
    (figure.panels, figure.normalise_to, figure.published) = (None, None, None);
    let mut rows = over_density(&["moller0", "moller1", "moller3"], 10);
    rows.retain(|row| row.order == "literal");
    for row in &mut rows {
        let factor = match row.kernel.as_str() {
            "moller0" => 1e-4,
            "moller1" => 1.0,
            _ => 3e5,
        };
        row.seconds = row.seconds.map(|seconds| seconds * factor);
    }
    rows[0].seconds = Some(0.0);
    (rows[1].seconds, rows[1].status) = (None, "wrong-result".into());
    let svg = drawn(&figure, &rows);
    assert!(
        svg.contains("(log scale)")
            && svg.contains("values without a place on the axes, not drawn: 1")
            && svg.contains("rows without a value: 1 (wrong-result)")
    );
}

#[test]
fn published_alone_is_named_so() {
    let rows: Vec<Row> = over_density(&["moller1"], 4);
    let mut figure = figure(TIMES);
    figure.file = "some-missing".into();
    let svg = drawn(&figure, &rows);
    assert_eq!(svg.matches("moller3 (published)").count(), 1);
}

const BARS: &str = r#"
    file = "h-8"
    kind = "bars"
    question = "Does moving the division behind the tests pay?"
    subtitle = "Million tests per second, precomputed triangles, nearest hit, single f32, early exit."
    x = "kernel"
    y = "mtests_per_s"
    series = "division"
    labels = { first = "division first", last = "division last" }
"#;

fn divided(kernels: usize) -> Vec<Row> {
    let names = [
        "moller-trumbore",
        "kensler-shirley",
        "shevtsov",
        "badouel-cramer",
        "wald",
        "keidy",
        "perpendicular-planes",
        "chirkov",
        "plucker",
        "half-spaces",
        "signed-areas",
        "angle-sum",
        "woop-watertight",
        "baldwin-weber",
        "embree-plucker",
        "woop-affine",
        "moller-trumbore-in-f64",
        "moller0",
        "moller1",
        "moller2",
    ];
    let mut rows = Vec::new();
    for (index, kernel) in names.iter().take(kernels).enumerate() {
        for (d, division) in ["first", "last"].iter().enumerate() {
            for (l, level) in ["sse2", "avx2"].iter().enumerate() {
                let row = Row {
                    division: (*division).into(),
                    level: (*level).into(),
                    ..row("h-8", kernel)
                };
                let scale = if *kernel == "angle-sum" { 300.0 } else { 1.0 };
                rows.push(timed(
                    row,
                    scale * (3.0 + 0.37 * index as f64 - 0.6 * d as f64 - 1.1 * l as f64),
                ));
            }
        }
    }
    rows
}

#[test]
fn sixteen_categories_of_two_bars_in_two_panels() {
    let mut figure = figure(BARS);
    figure.panels = Some("level".into());
    let svg = drawn(&figure, &divided(16));
    let texts = boxes::texts(&svg);
    assert_eq!(texts.iter().filter(|text| text.words == "division last").count(), 16);
    assert!(texts.iter().any(|text| text.words == "moller-trumbore"));
}

#[test]
fn twenty_bars_of_one_series_start_at_zero() {
    let mut figure = figure(BARS);
    (figure.file, figure.series) = ("twenty".into(), Names::One("experiment".into()));
    let wanted = |word: &str| Wanted::Word(word.into());
    figure.filter =
        BTreeMap::from([("level".into(), wanted("sse2")), ("division".into(), wanted("last"))]);
    let svg = drawn(&figure, &divided(20));
    let polygons = svg.split("<polygon").skip(1).filter(|part| part.contains("fill=\"#0072B2\""));
    let lefts: Vec<&str> = polygons
        .map(|part| boxes::attribute(part, "points").unwrap().split(',').next().unwrap())
        .collect();
    assert_eq!(lefts.len(), 20);
    assert!(lefts.iter().all(|left| *left == lefts[0]), "{lefts:?}");
}

#[test]
fn bars_of_different_machines_with_published_ones() {
    let mut figure = figure(BARS);
    figure.file = "b-4.3".into();
    figure.question = "Which of the three is the fastest depends on the processor".into();
    figure.subtitle = "Mean time over the densities.".into();
    (figure.x, figure.y) = (Names::One("build".into()), "seconds".into());
    (figure.series, figure.scale) = (Names::One("kernel".into()), Scale::Log);
    figure.published =
        Some(toml::from_str("table = \"table_4_3\"\nnote = \"four computers of 2007\"").unwrap());
    let kernel = |(index, kernel): (usize, &&str)| {
        timed(Row { build: "this machine".into(), ..row("b-4.3", kernel) }, 2.0 + index as f64)
    };
    let rows: Vec<Row> = ["moller", "badouel", "chirkov"].iter().enumerate().map(kernel).collect();
    let svg = drawn(&figure, &rows);
    assert_eq!(svg.matches("stroke-width=\"1.6\"").count(), 12);
    figure.file = "b-4.3-linear".into();
    figure.scale = Scale::Linear;
    drawn(&figure, &rows);
}

const CODES: &str = r#"
    file = "b-4.5"
    kind = "shares"
    question = "Where do Möller's calls end, and what does it cost to end there?"
    subtitle = "1 000 000 random pairs; below, pairs sorted by return code, each repeated in a row."
    x = "code"
    y = "share"
    y_below = "ns_per_test"
    normalise_to = "0"
    published = { table = "table_4_5", note = "Athlon 64 3000+, 2007" }
"#;

fn by_code(kernel: &str) -> Vec<Row> {
    let shares = [0.1211, 0.3177, 0.1213, 0.3181, 0.1214, 0.0001];
    let times = [2.4, 1.5, 2.2, 1.6, 2.3, 1.1];
    (0..6)
        .map(|code| {
            let row =
                Row { code: Some(code as u64), share: Some(shares[code]), ..row("b-4.5", kernel) };
            timed(row, times[code])
        })
        .collect()
}

#[test]
fn shares_and_times_by_return_code() {
    let svg = drawn(&figure(CODES), &by_code("moller"));
    assert_eq!(svg.matches("stroke-width=\"1.6\"").count(), 12);
    let texts = boxes::texts(&svg);
    for words in ["31.8", "12.1", "hit", "1.00"] {
        assert!(texts.iter().any(|text| text.words == words), "{words}");
    }
}

#[test]
fn shares_of_three_kernels() {
    let rows: Vec<Row> =
        ["moller", "moller0", "moller3"].iter().flat_map(|kernel| by_code(kernel)).collect();
    let mut figure = figure(CODES);
    figure.file = "codes-of-three".into();
    drawn(&figure, &rows);
}

const OPERATIONS: &str = r#"
    file = "b-4.9"
    kind = "counts"
    question = "How many operations does one call execute at most?"
    subtitle = "Longest path of each published listing, run on a counting number."
    published = { table = "table_4_9" }
"#;

fn counted(kernel: &str, [add, sub, neg, mul, div, condition]: [u64; 6]) -> Row {
    Row {
        ops_add: Some(add),
        ops_sub: Some(sub),
        ops_neg: Some(neg),
        ops_mul: Some(mul),
        ops_div: Some(div),
        ops_condition: Some(condition),
        ..row("b-4.9", kernel)
    }
}

#[test]
fn counts_beside_the_published_ones() {
    let rows = [
        counted("moller", [9, 15, 1, 25, 1, 4]),
        counted("badouel", [8, 11, 0, 13, 3, 4]),
        counted("badouel", [2, 1, 0, 5, 1, 1]),
        counted("chirkov", [11, 20, 0, 28, 1, 2]),
        counted("moller-trumbore-in-f64", [9, 15, 1, 25, 1, 4]),
    ];
    let svg = drawn(&figure(OPERATIONS), &rows);
    // A tick is one line of three points; a cross a path of two lines.
    assert_eq!(svg.matches("stroke=\"#007C5C\"").count(), 14);
    assert_eq!(svg.matches("stroke=\"#C44E00\"").count(), 1);
    assert!(svg.contains("moller: 9 additions (published 9), 16 subtractions (published 16)"));
}

#[test]
fn the_same_rows_give_the_same_bytes() {
    let rows = over_density(&["moller0", "moller1", "moller3"], 4);
    let once = || draw(&figure(TIMES), &rows, &published()).unwrap();
    assert_eq!(once(), once());
}
