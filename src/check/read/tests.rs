//! Files as people write them, good and bad.

use super::*;
use crate::check::Precision::{F32, F64};
use crate::check::{Case, Reply};

const HEADER: &str = "ox,oy,oz,dx,dy,dz,ax,ay,az,bx,by,bz,cx,cy,cz";

fn read(text: &str) -> Result<Vec<Case>, ReadError> {
    let mut cases = Cases::new(text.as_bytes(), "cases");
    let mut all = Vec::new();
    while let Some(case) = cases.advance()? {
        all.push(case);
    }
    Ok(all)
}

fn refusal(text: &str) -> String {
    read(text).expect_err("it must be refused").to_string()
}

#[test]
fn columns_stand_in_any_order_and_the_range_and_id_may_be_missing() {
    let cases = read(&format!("{HEADER}\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15\n")).expect("a case");
    let query = cases[0].query(F64);
    assert_eq!(cases[0].id, "1");
    assert_eq!((query.origin, query.direction), ([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]));
    assert_eq!(query.triangle, [[7.0, 8.0, 9.0], [10.0, 11.0, 12.0], [13.0, 14.0, 15.0]]);
    assert_eq!((query.t_min, query.t_max), (0.0, f64::INFINITY));
    let turned = "id,tmax,tmin,cz,cy,cx,bz,by,bx,az,ay,ax,dz,dy,dx,oz,oy,ox\n\
                  left,17,16,15,14,13,12,11,10,9,8,7,6,5,4,3,2,1\n";
    let turned = read(turned).expect("a case");
    assert_eq!(turned[0].id, "left");
    let expected = crate::oracle::Query { t_min: 16.0, t_max: 17.0, ..query };
    assert_eq!(turned[0].query(F64), expected);
}

#[test]
fn json_lines_read_as_csv_does() {
    let csv = format!("{HEADER},tmax,id\n0.1,-0.0,1e38,nan,inf,1e-45,7,8,9,1,1,1,2,2,3,,a\n");
    let json = r#"{"id":"a","ox":0.1,"oy":-0.0,"oz":1e38,"dx":"nan","dy":"inf","dz":1e-45,
        "ax":7,"ay":8,"az":9,"bx":1,"by":1,"bz":1,"cx":2,"cy":2,"cz":3,"tmax":null}"#;
    let (csv, json) = (read(&csv), read(&json.replace('\n', "")));
    let text = |cases: Result<Vec<Case>, _>| format!("{:?}", cases.expect("a case"));
    assert_eq!(text(csv), text(json));
}

#[test]
fn blank_lines_marks_and_line_ends_do_not_count() {
    let row = "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15";
    let text = format!("\u{feff}\r\n{HEADER} ,id\r\n\r\n{row},\"a, b\" \r\n  \n {row},\n{row},c");
    let ids: Vec<String> = read(&text).expect("cases").into_iter().map(|case| case.id).collect();
    assert_eq!(ids, ["a, b", "2", "c"]);
}

#[test]
fn numbers_are_rounded_to_each_precision() {
    let cases = read(&format!("{HEADER}\n0.1,1e39,1e-46,0,0,1,0,0,0,1,0,0,0,1,0\n")).expect("one");
    let [single, double] = [F32, F64].map(|precision| cases[0].query(precision).origin);
    assert_eq!(single, [f64::from(0.1_f32), f64::INFINITY, 0.0]);
    assert_eq!(double, [0.1, 1e39, 1e-46]);
}

#[test]
fn a_wrong_header_is_named() {
    let missing = refusal("ox,oy,oz\n1,2,3\n");
    assert!(missing.starts_with("cases, line 1: missing columns: dx, dy, dz, ax"), "{missing}");
    let unknown = refusal(&format!("{HEADER},tmaxx\n"));
    assert!(unknown.starts_with("cases, line 1, column 16: unknown name 'tmaxx'"), "{unknown}");
    assert!(unknown.ends_with("Did you mean 'tmax'?"), "{unknown}");
    let twice = refusal(&format!("\n{HEADER},ox\n"));
    assert!(twice.starts_with("cases, line 2, column 16: 'ox' stands there twice"), "{twice}");
}

#[test]
fn a_wrong_row_is_named_by_line_and_column() {
    let row = "1,2,3,4,5,6,7,8,9,10,11,12,13,14";
    let text = refusal(&format!("{HEADER}\n{row},15\n\n{row},x5\n"));
    assert_eq!(
        text,
        "cases, line 4, column 15 (cz): 'x5' is not allowed; allowed: a number, nan or inf"
    );
    let short = refusal(&format!("{HEADER}\n{row}\n"));
    assert_eq!(short, "cases, line 2, column 15: 14 values; allowed: 15, as the header has");
    let long = refusal(&format!("{HEADER}\n{row},15,16\n"));
    assert_eq!(long, "cases, line 2, column 16: 16 values; allowed: 15, as the header has");
    let empty = refusal(&format!("{HEADER}\n{row},\n"));
    assert!(empty.starts_with("cases, line 2, column 15 (cz): '' is not allowed"), "{empty}");
}

#[test]
fn wrong_json_is_named_by_line_and_field() {
    let good = r#"{"ox":1,"oy":1,"oz":1,"dx":1,"dy":1,"dz":1,"ax":1,"ay":1,"az":1,"bx":1,"by":1,"bz":1,"cx":1,"cy":1,"cz":1}"#;
    let second = |line: &str| refusal(&format!("{good}\n{line}\n"));
    let field = second(&good.replace(r#""by":1"#, r#""by":"one""#));
    assert!(field.starts_with("cases, line 2, field 'by': 'one' is not allowed"), "{field}");
    let list = second(&good.replace(r#""by":1"#, r#""by":[1]"#));
    assert!(list.starts_with("cases, line 2, field 'by': '[1]' is not allowed"), "{list}");
    let missing = second(&good.replace(r#""by":1,"#, ""));
    assert_eq!(missing, "cases, line 2: missing fields: by");
    let twice = second(&good.replace(r#""by":1,"#, r#""by":1,"by":2,"#));
    assert!(twice.starts_with("cases, line 2: 'by' stands there twice"), "{twice}");
    let unknown = second(&good.replace(r#""by":1"#, r#""by":1,"tmim":0"#));
    assert!(unknown.ends_with("Did you mean 'tmin'?"), "{unknown}");
    let broken = second(r#"{"ox": 1, "#);
    assert!(broken.starts_with("cases, line 2, column 10: EOF while parsing"), "{broken}");
    assert!(second("[1]").contains("one object a line"));
    assert!(refusal("[{}]").contains("a JSON array; allowed: JSON lines"));
}

#[test]
fn nothing_is_no_case() {
    for text in ["", "\n \n", HEADER, &format!("{HEADER}\n\n")] {
        assert!(refusal(text).starts_with("cases: no case; allowed"), "{text}");
    }
}

#[test]
fn what_is_no_text_or_no_line_is_refused() {
    let mut bytes = HEADER.as_bytes().to_vec();
    bytes.extend(b"\n\xff\xfe\n");
    let error = Cases::new(bytes.as_slice(), "cases").advance().expect_err("it is not UTF-8");
    assert_eq!(error.to_string(), "cases, line 2: not UTF-8; allowed: UTF-8");
    let long = "1".repeat(1 << 21);
    assert!(refusal(&long).starts_with("cases, line 1: allowed: lines of less than 1048576"));
}

fn answered(answers: &str) -> Result<Vec<(String, Reply)>, String> {
    let row = "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15";
    let cases = format!("{HEADER},id\n{row},a\n{row},b\n{row},c\n");
    let answers = Answers::new(answers.as_bytes(), "answers");
    let mut both = Answered::new(Cases::new(cases.as_bytes(), "cases"), answers);
    let mut all = Vec::new();
    while let Some((case, reply)) = both.advance().map_err(|error| error.to_string())? {
        all.push((case.id, reply));
    }
    Ok(all)
}

#[test]
fn answers_are_read_beside_their_cases() {
    let read = answered("id,hit,t,u,v\na,1,0.5,nan,\nb,False,,,\nc,TRUE,1,2,3\n").expect("three");
    let (a, c) = (read[0].1, read[2].1);
    assert!(a.hit && a.t == Some(0.5) && a.u.is_some_and(f64::is_nan) && a.v.is_none());
    assert_eq!(read[1], ("b".into(), Reply::default()));
    assert_eq!(c, Reply { hit: true, t: Some(1.0), u: Some(2.0), v: Some(3.0) });
    let json = r#"{"id":"a","hit":true,"t":1,"u":2,"v":3}"#;
    let lines = format!("{json}\n{}\n{}\n", json.replace("\"a\"", "\"b\""), json.replace('a', "c"));
    assert_eq!(answered(&lines).expect("three").len(), 3);
}

#[test]
fn answers_that_do_not_fit_are_named_by_their_ids() {
    let with = |ids: &[&str]| {
        let rows: String = ids.iter().map(|id| format!("{id},0,,,\n")).collect();
        answered(&format!("id,hit,t,u,v\n{rows}")).expect_err("it must be refused")
    };
    assert_eq!(with(&["a", "b"]), "answers: no answer for the case 'c'");
    assert_eq!(with(&["a", "c"]), "answers, line 3: no answer for the case 'b'");
    let superfluous = "an answer for 'x', which is no case or had its answer";
    assert_eq!(with(&["a", "b", "c", "x"]), format!("answers, line 5: {superfluous}"));
    assert_eq!(with(&["a", "x", "b", "c"]), format!("answers, line 3: {superfluous}"));
    assert!(with(&["c", "b", "a"]).starts_with("answers, line 2: an answer for 'c' where 'a' is"));
    assert_eq!(with(&[]), "answers: no answer for the case 'a'");
    let text = answered("id,hit,t,u,v\na,maybe,,,\n").expect_err("no decision");
    assert!(text.starts_with("answers, line 2, column 2 (hit): 'maybe' is not allowed"), "{text}");
}
