//! Files that are no ledger are refused with file, claim and field.

use crate::claims::Ledger;

const GOOD: &str = r#"
place = 1

[[claim]]
id = "X-1"
source = "nobody"
statement = "Small."
series.x = { experiment = "e", filter = { level = "sse2" }, value = "ops_add", along = "kernel" }
let.half = "x / 2"
[[claim.part]]
what = "x"
measure = "mean(half)"
below = 2.0
"#;

fn error(text: &str) -> String {
    match Ledger::from_files(&[("x.toml", text)]) {
        Ok(_) => panic!("this was read:\n{text}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn the_good_one_is_read() {
    let ledger = Ledger::from_files(&[("x.toml", GOOD)]).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(ledger.claims()[0].experiments(), ["e"]);
}

#[test]
fn every_wrong_field_is_named() {
    for (good, bad, wanted) in [
        ("statement = \"Small.\"", "statement = \"\"", "claim 'X-1', statement: nothing"),
        ("statement =", "statment =", "unknown field `statment`"),
        ("\"ops_add\"", "\"ops_sad\"", "series.x.value: 'ops_sad' is not allowed; allowed: "),
        ("\"ops_add\"", "\"level\"", "series.x.value: 'level' is not allowed; allowed: a column"),
        ("{ level", "{ levl", "series.x.filter: 'levl' is not allowed"),
        ("along = \"kernel\"", "along = \"colonel\"", "series.x.along: 'colonel' is not"),
        ("experiment = \"e\", ", "", "series.x.experiment: nothing is not allowed"),
        (" }", ", keys = [\"a\"] }", "series.x.otherwise: allowed: together with keys"),
        ("\"x / 2\"", "\"y / 2\"", "let.half: 'y' is not allowed; allowed: x, half"),
        ("\"x / 2\"", "\"half / 2\"", "let.half: it needs itself"),
        ("let.half", "let.x", "let.x: there is a series of that name"),
        ("mean(half)", "mean(haf)", "part 1: 'haf' is not allowed; allowed: x, half"),
        ("mean(half)", "mean(half", "part 1: 'mean(half', character 10: this is not allowed"),
        ("below = 2.0", "", "part 1: allowed: one of below, above"),
        ("below = 2.0", "below = 2.0\nabove = 1.0", "part 1: allowed: one of below, above"),
        ("below = 2.0", "between = [2.0, 1.0]", "part 1: allowed: one of below, above"),
        ("source =", "not_testable = \"so\"\nsource =", "part: allowed: parts, or not_testable"),
    ] {
        // The last place only, so that the filter's closing brace stays.
        let at = GOOD.rfind(good).unwrap_or_else(|| panic!("no {good}"));
        let text = format!("{}{bad}{}", &GOOD[..at], &GOOD[at + good.len()..]);
        let error = error(&text);
        assert!(error.starts_with("x.toml") && error.contains(wanted), "{bad}: {error}");
    }
}

#[test]
fn an_id_is_there_once() {
    let second = GOOD.replace("place = 1", "place = 2");
    let twice = Ledger::from_files(&[("x.toml", GOOD), ("y.toml", &second)]);
    let error = twice.err().map(|error| error.to_string()).unwrap_or_default();
    assert!(error.contains("y.toml, claim 'X-1', id: is there twice"), "{error}");
}

#[test]
fn papers_stand_at_their_places() {
    let second = GOOD.replace("place = 1", "place = 0").replace("X-1", "A-1");
    let ledger = Ledger::from_files(&[("a.toml", GOOD), ("b.toml", &second)]);
    let ledger = ledger.unwrap_or_else(|error| panic!("{error}"));
    let ids: Vec<&str> = ledger.claims().iter().map(|claim| claim.id.as_str()).collect();
    assert_eq!(ids, ["A-1", "X-1"]);
}
