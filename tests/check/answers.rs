//! Somebody else's answers.

use super::support::{File, HEADER, check, rows, said};

/// a hits at t = 1/3, u = v = 1/4; b misses; c is on an edge, t = 2, u = 1/2, v = 0; d is NaN.
fn cases() -> String {
    let triangle = "0,0,0,4,0,0,0,4,0";
    format!(
        "id,{HEADER}\na,1,1,1,0,0,-3,{triangle}\nb,5,1,1,0,0,-3,{triangle}\n\
         c,2,0,2,0,0,-1,{triangle}\nd,nan,0,2,0,0,-1,{triangle}\n"
    )
}

#[test]
fn each_answer_is_judged_in_the_precision_of_its_inputs() {
    let file = File::new("judged", &cases());
    // The nearest f32 to 1/3, in full; u is one last place of f32 too large.
    let answers = "id,hit,t,u,v\na,1,0.3333333432674407958984375,0.25000002980232238769,0.25\n\
                   b,1,0.5,nan,0\nc,0,,,\nd,0,,,\n";
    let words = [file.path(), "--answers", "-", "--precision", "f32", "--format", "csv"];
    let output = check(&words, answers);
    assert_eq!((output.status.code(), said(&output)), (Some(0), String::new()));
    let rows = rows(&output);
    let column =
        |name: &str| -> Vec<String> { rows.iter().map(|row| row.cell(name).to_owned()).collect() };
    assert_eq!(column("id"), ["a", "b", "c", "d"]);
    assert_eq!(column("kernel"), ["answers"; 4]);
    assert_eq!(column("precision"), ["f32"; 4]);
    assert_eq!(column("where"), ["interior", "outside", "edge", "not-finite"]);
    assert_eq!(column("verdict"), ["agree", "false-hit", "false-miss", "undefined"]);
    assert_eq!(column("non_finite"), ["", "u", "", ""]);
    assert_eq!(column("u")[1..], ["", "", ""]);
    // 11184811 / 2^25 is 1 / (3 2^25) above 1/3, a third of the last place.
    assert!((rows[0].number("err_t_ulp") - 1.0 / 3.0).abs() < 1e-12);
    // The text of u has 20 digits of 1/4 + 2^-25; the last place of 1 is 2^-23.
    assert!((rows[0].number("err_u_ulp") - 0.25).abs() < 1e-9);
    assert_eq!(rows[0].number("err_v_ulp"), 0.0);
    assert_eq!(column("err_t_ulp")[1..], ["", "", ""]);
}

#[test]
fn without_a_precision_numbers_stay_as_they_are() {
    // One last place of f64 beside the edge from a to c, which f32 does not know.
    let a = "0.10000000000000002,0,0";
    let case = format!("0.1,0.25,1,0,0,-1,{a},0.3,0,0,{}", a.replace(",0,", ",1,"));
    let file = File::new("double", &format!("{HEADER}\n{case}\n"));
    let answers = "{\"id\": 1, \"hit\": true, \"t\": 1, \"u\": null, \"v\": null}\n";
    let words = [file.path(), "--answers", "-", "--format", "csv"];
    let cells = |words: &[&str]| {
        let rows = rows(&check(words, answers));
        assert_eq!(rows.len(), 1);
        ["precision", "where", "t", "u", "exact_t", "verdict", "err_t_ulp", "err_u_ulp"]
            .map(|name| rows[0].cell(name).to_owned())
    };
    assert_eq!(cells(&words), ["f64", "outside", "1", "", "1", "false-hit", "", ""]);
    let single: Vec<&str> = words.into_iter().chain(["--precision", "f32"]).collect();
    assert_eq!(cells(&single), ["f32", "edge", "1", "", "1", "agree", "0", ""]);
}

#[test]
fn answers_that_do_not_fit_are_refused_with_their_id() {
    let file = File::new("misfits", &cases());
    let answers = |ids: &str| {
        let rows: String = ids.chars().map(|id| format!("{id},0,,,\n")).collect();
        format!("id,hit,t,u,v\n{rows}")
    };
    let refused = |text: &str, part: &str, printed: usize| {
        let output = check(&[file.path(), "--answers", "-", "--format", "csv"], text);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains(part), "no '{part}' in: {}", said(&output));
        let lines = String::from_utf8_lossy(&output.stdout).lines().count();
        assert_eq!(lines.saturating_sub(1), printed);
    };
    refused(&answers("abc"), "no answer for the case 'd'", 3);
    refused(&answers("acd"), "line 3: no answer for the case 'b'", 1);
    refused(&answers("abcde"), "line 6: an answer for 'e'", 4);
    refused(&answers("bacd"), "line 2: an answer for 'b' where 'a' is due", 0);
    refused("id,hit,t,u\na,0,,\n", "missing columns: v", 0);
    refused("id,hit,t,u,v\na,0,,,\nb,perhaps,,,\n", "line 3, column 2 (hit): 'perhaps'", 1);
    let both = check(&["-", "--answers", "-"], &cases());
    assert_eq!(both.status.code(), Some(2));
    assert!(said(&both).contains("'-' twice"));
}

#[test]
fn the_answers_of_a_kernel_are_judged_as_the_kernel_is() {
    let file = File::new("kernel", &cases());
    let form = ["--kernels", "moller-trumbore", "--precision", "f64", "--format", "csv"];
    let words: Vec<&str> = [file.path()].into_iter().chain(form).collect();
    let kernel = rows(&check(&words, ""));
    let columns = ["id", "hit", "t", "u", "v"];
    let lines = kernel.iter().map(|row| columns.map(|name| row.cell(name)).join(","));
    let answers = columns.join(",") + "\n" + &lines.collect::<Vec<_>>().join("\n");
    let judged = rows(&check(&[file.path(), "--answers", "-", "--format", "csv"], &answers));
    assert_eq!(judged.len(), 4);
    for (judged, kernel) in judged.iter().zip(&kernel) {
        for name in ["where", "t", "u", "v", "exact_t", "err_t_ulp", "err_u_ulp", "verdict"] {
            assert_eq!(judged.cell(name), kernel.cell(name), "{name}");
        }
    }
}
