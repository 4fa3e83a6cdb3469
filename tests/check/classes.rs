//! Cases of every class, and numbers at the ends of the range: what each must be, by hand.

use super::support::{HEADER, Row, check, rows};
use ray_test::check::{Precision, form, kernels};

/// a = (0, 0, 0), b = (4, 0, 0), c = (0, 4, 0).
const TRIANGLE: &str = "0,0,0,4,0,0,0,4,0";

/// What stands in the cells `where`, `exact_t`, `exact_u`, `exact_v`.
type Expected = (&'static str, &'static str, &'static str, &'static str);

/// id, origin and direction, tmin and tmax, and what that is. From 2 above the plane straight down
/// the line meets it at t = 2, u = x / 4, v = y / 4.
const PLAIN: [(&str, &str, &str, Expected); 21] = [
    ("interior", "1,1,2,0,0,-1", ",", ("interior", "2", "0.25", "0.25")),
    ("edge-ab", "2,0,2,0,0,-1", ",", ("edge", "2", "0.5", "0")),
    ("edge-ac", "0,1,2,0,0,-1", ",", ("edge", "2", "0", "0.25")),
    ("edge-bc", "2,2,2,0,0,-1", ",", ("edge", "2", "0.5", "0.5")),
    ("vertex-a", "0,0,2,0,0,-1", ",", ("vertex", "2", "0", "0")),
    ("vertex-b", "4,0,2,0,0,-1", ",", ("vertex", "2", "1", "0")),
    ("vertex-c", "0,4,2,0,0,-1", ",", ("vertex", "2", "0", "1")),
    ("signed-zeros", "-0.0,-0.0,2,-0.0,0,-1", ",", ("vertex", "2", "0", "0")),
    ("coplanar", "-1,1,0,1,0,0", ",", ("coplanar", "", "", "")),
    ("parallel", "-1,1,1,1,0,0", ",", ("outside", "", "", "")),
    ("no-direction", "1,1,1,0,0,0", ",", ("outside", "", "", "")),
    ("no-direction-in-plane", "1,1,0,0,-0.0,0", ",", ("coplanar", "", "", "")),
    ("outside", "3,3,2,0,0,-1", ",", ("outside", "2", "0.75", "0.75")),
    ("behind", "1,1,-2,0,0,-1", ",", ("behind", "-2", "0.25", "0.25")),
    ("beyond", "1,1,2,0,0,-1", "0,1.5", ("behind", "2", "0.25", "0.25")),
    ("before", "1,1,2,0,0,-1", "2.5,inf", ("behind", "2", "0.25", "0.25")),
    ("backwards", "1,1,-2,0,0,-1", "-3,0", ("interior", "-2", "0.25", "0.25")),
    ("at-both-bounds", "1,1,2,0,0,-1", "2,2", ("interior", "2", "0.25", "0.25")),
    ("bounds-crossed", "1,1,2,0,0,-1", "3,1", ("behind", "2", "0.25", "0.25")),
    ("bounds-crossed-outside", "3,3,2,0,0,-1", "3,1", ("outside", "2", "0.75", "0.75")),
    ("at-the-origin", "1,1,0,0,0,-1", ",", ("interior", "0", "0.25", "0.25")),
];

fn run(text: &str) -> Vec<Row> {
    let output = check(&["-", "--format", "csv"], text);
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty(), "{}", super::support::said(&output));
    let printed = String::from_utf8(output.stdout.clone()).expect("it is UTF-8").to_lowercase();
    let bad = printed.split([',', '\n']).find(|cell| ["nan", "inf", "-inf"].contains(cell));
    assert_eq!(bad, None, "a number that is none");
    rows(&output)
}

fn of<'a>(rows: &'a [Row], id: &'a str, precision: &'a str) -> impl Iterator<Item = &'a Row> {
    let wanted = move |row: &&Row| row.cell("id") == id && row.cell("precision") == precision;
    let found: Vec<&Row> = rows.iter().filter(wanted).collect();
    assert!(!found.is_empty(), "no row of {id} in {precision}");
    found.into_iter()
}

/// The kernels that answer as the algebra of the closed triangle does, where every number is small
/// and whole. The listings know no range of t and have other conventions; the sum of angles rounds.
fn is_closed(row: &Row) -> bool {
    let kernel = row.cell("kernel");
    let is_listing = kernel.starts_with("moller") && kernel != "moller-trumbore";
    let others = ["badouel", "chirkov-line", "angle-sum"];
    !(is_listing && !kernel.contains('-') || others.contains(&kernel))
}

#[test]
fn plain_cases_of_every_class_are_what_they_are() {
    let mut text = format!("id,{HEADER},tmin,tmax\n");
    for (id, ray, range, _) in PLAIN {
        text.push_str(&format!("{id},{ray},{TRIANGLE},{range}\n"));
    }
    let rows = run(&text);
    let forms = |precision| kernels().iter().filter(|id| form(id, precision).is_some()).count();
    let per_case: usize = Precision::ALL.into_iter().map(forms).sum();
    assert!(per_case >= 2 * 18);
    assert_eq!(rows.len(), PLAIN.len() * per_case);
    for (id, _, _, (place, t, u, v)) in PLAIN {
        for row in of(&rows, id, "f32").chain(of(&rows, id, "f64")) {
            let kernel = row.cell("kernel");
            let exact = ["where", "exact_t", "exact_u", "exact_v"].map(|column| row.cell(column));
            assert_eq!(exact, [place, t, u, v], "{id}, {kernel}");
            let is_hit = ["interior", "edge", "vertex"].contains(&place);
            assert_eq!(row.cell("exact_hit"), is_hit.to_string(), "{id}, {kernel}");
            let verdict = match (row.cell("hit") == "true", is_hit) {
                (true, false) => "false-hit",
                (false, true) => "false-miss",
                _ => "agree",
            };
            assert_eq!(row.cell("verdict"), verdict, "{id}, {kernel}");
            if is_closed(row) {
                assert_eq!(verdict, "agree", "{id}, {kernel}");
            }
        }
    }
}

#[test]
fn outputs_of_a_hit_are_held_against_the_exact_ones() {
    let rows = run(&format!("{HEADER}\n1,1,2,0,0,-1,{TRIANGLE}\n"));
    for row in rows.iter().filter(|row| is_closed(row)) {
        let cells = ["hit", "t", "u", "v"].map(|column| row.cell(column));
        assert_eq!(cells, ["true", "2", "0.25", "0.25"], "{}", row.cell("kernel"));
        let errors = ["err_t_ulp", "err_u_ulp", "err_v_ulp", "err_barycentric_abs"];
        assert_eq!(errors.map(|column| row.number(column)), [0.0; 4], "{}", row.cell("kernel"));
    }
    // It yields no u and v.
    let angles: Vec<&Row> = rows.iter().filter(|row| row.cell("kernel") == "angle-sum").collect();
    assert!(!angles.is_empty());
    for row in angles {
        assert_eq!(["u", "v", "err_u_ulp", "err_v_ulp"].map(|column| row.cell(column)), [""; 4]);
    }
    // The listing knows no range of t: a hit where the exact answer is a miss.
    let behind = run(&format!("{HEADER}\n1,1,-2,0,0,-1,{TRIANGLE}\n"));
    let listing = behind.iter().find(|row| row.cell("kernel") == "moller1").expect("it is there");
    assert_eq!(["hit", "t", "verdict"].map(|c| listing.cell(c)), ["true", "-2", "false-hit"]);
    assert_eq!(listing.cell("err_t_ulp"), "");
}

#[test]
fn triangles_without_area_are_degenerate_whatever_the_ray() {
    let mut text = format!("{HEADER}\n");
    // Through it, along it, beside it, with its range crossed, without a direction.
    for ray in ["1,0,2,0,0,-1", "0,0,0,1,0,0", "9,9,9,1,1,1", "0,0,0,0,0,0"] {
        for triangle in ["0,0,0,4,0,0,8,0,0", "1,1,1,1,1,1,1,1,1", "0,0,0,1,2,3,-2,-4,-6"] {
            text.push_str(&format!("{ray},{triangle}\n"));
        }
    }
    let rows = run(&text);
    assert!(rows.iter().all(|row| row.cell("where") == "degenerate"));
    assert!(rows.iter().all(|row| row.cell("exact_hit") == "false"));
}

#[test]
fn input_that_is_not_finite_is_a_miss_that_is_judged_by_nobody() {
    let plain = format!("1,1,2,0,0,-1,{TRIANGLE},0,9");
    let mut text = format!("{HEADER},tmin,tmax\n");
    let mut count = 0;
    for place in 0..17 {
        for word in ["nan", "-inf", "Infinity"] {
            // An infinite bound of t is allowed.
            if place >= 15 && word != "nan" {
                continue;
            }
            let mut cells: Vec<&str> = plain.split(',').collect();
            cells[place] = word;
            text.push_str(&(cells.join(",") + "\n"));
            count += 1;
        }
    }
    let rows = run(&text);
    let ids: std::collections::BTreeSet<&str> = rows.iter().map(|row| row.cell("id")).collect();
    assert_eq!(ids.len(), count);
    for row in &rows {
        let cells = ["where", "exact_hit", "exact_t", "verdict", "err_t_ulp"];
        let cells = cells.map(|column| row.cell(column));
        assert_eq!(cells, ["not-finite", "false", "", "undefined", ""], "{}", row.cell("id"));
    }
}

/// The same triangle and ray in other units: t = 2, u = v = 1/4, as far as decimals can say it.
fn scaled(one: &str, two: &str, four: &str) -> String {
    format!("{one},{one},{two},0,0,-{one},0,0,0,{four},0,0,0,{four},0")
}

#[test]
fn numbers_at_the_ends_of_the_range_are_exact_as_well() {
    let mut text = format!("id,{HEADER}\n");
    for (id, case) in [
        // Units of 2^-149, the smallest f32: the decimals are nearest to 1, 2 and 4 of them.
        ("subnormal", scaled("1.4e-45", "2.8e-45", "5.6e-45")),
        // 1, 2 and 4 units of 2^-1074, the smallest f64; in f32 they are all 0.
        ("smallest", scaled("5e-324", "1e-323", "2e-323")),
        ("large", "1e38,1e38,2e38,0,0,-1,0,0,0,3e38,0,0,0,3e38,0".into()),
        ("small", "1e-38,1e-38,2e-38,0,0,-1,0,0,0,3e-38,0,0,0,3e-38,0".into()),
        ("too-large", "1e39,1e39,2e39,0,0,-1,0,0,0,4e39,0,0,0,4e39,0".into()),
        ("beyond-f64", "1e400,1,1,0,0,-1,0,0,0,1,0,0,0,1,0".into()),
    ] {
        text.push_str(&format!("{id},{case}\n"));
    }
    let rows = run(&text);
    let expect = |id: &str, precision: &str, place: &str, t: Option<f64>, u: Option<f64>| {
        for row in of(&rows, id, precision) {
            let kernel = row.cell("kernel");
            assert_eq!(row.cell("where"), place, "{id}, {precision}, {kernel}");
            for (column, exact) in [("exact_t", t), ("exact_u", u)] {
                let cell = row.cell(column).parse::<f64>().ok();
                let is_near = match (kernel, cell, exact) {
                    // The end of its segment is rounded, which turns and stretches it by as much
                    // as the unit roundoff; the value itself is rounded as well.
                    ("chirkov", Some(cell), Some(exact)) => {
                        let step =
                            if precision == "f32" { f32::EPSILON.into() } else { f64::EPSILON };
                        (cell - exact).abs() <= step * exact
                    }
                    _ => cell == exact,
                };
                assert!(is_near, "{id}, {precision}, {kernel}: {column} {cell:?}, not {exact:?}");
            }
        }
    };
    expect("subnormal", "f32", "interior", Some(2.0), Some(0.25));
    // 5.6 and 2.8 are 4 and 2 times 1.4 in f64 as well: powers of two keep the rounding.
    expect("subnormal", "f64", "interior", Some(2.0), Some(0.25));
    expect("smallest", "f32", "degenerate", None, None);
    expect("smallest", "f64", "interior", Some(2.0), Some(0.25));
    // t is the height of the origin. u is a quotient of two rounded numbers, which f64 divides with
    // one rounding: it is correctly rounded itself.
    let single = |x: f32| Some(f64::from(x));
    expect(
        "large",
        "f32",
        "interior",
        single(2e38),
        Some(f64::from(1e38_f32) / f64::from(3e38_f32)),
    );
    expect("large", "f64", "interior", Some(2e38), Some(1e38 / 3e38));
    let small = Some(f64::from(1e-38_f32) / f64::from(3e-38_f32));
    expect("small", "f32", "interior", single(2e-38), small);
    expect("small", "f64", "interior", Some(2e-38), Some(1e-38 / 3e-38));
    expect("too-large", "f32", "not-finite", None, None);
    expect("too-large", "f64", "interior", Some(2e39), Some(0.25));
    expect("beyond-f64", "f32", "not-finite", None, None);
    expect("beyond-f64", "f64", "not-finite", None, None);
}

#[test]
fn an_infinite_bound_is_no_bound() {
    let text = format!("{HEADER},tmin,tmax\n1,1,2,0,0,-1,{TRIANGLE},-inf,inf\n");
    let text = text + &format!("1,1,2,0,0,-1,{TRIANGLE},inf,-inf\n");
    for row in run(&text) {
        let place = if row.cell("id") == "1" { "interior" } else { "behind" };
        assert_eq!(row.cell("where"), place, "{}", row.cell("kernel"));
    }
}
