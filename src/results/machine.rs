//! Which folders are of the same machine and build, and what each is called.
//!
//! Two are of the same if `environment.json` has the same `testbed_id` (processor, caches, number
//! of processors, system) and the same `build` (version, commit, compiler, target, profile,
//! optimisation level, flags). Load, date and frequency may differ.

use serde_json::{Value, json};

/// What must be equal; `None` where the environment does not say, which is equal to nothing.
pub(super) fn identity(environment: &Value) -> Option<Value> {
    let testbed = environment.get("testbed_id").filter(|id| id.is_string())?;
    Some(json!([testbed, build(environment)?]))
}

/// What must be equal where no clock was read.
pub(super) fn build(environment: &Value) -> Option<Value> {
    environment.get("build").filter(|build| build.is_object()).cloned()
}

/// A name for each environment, different for each: the processor; where that is the same, what
/// else differs, coarsest first; `#2`, `#3` ... where nothing does, because they are different
/// measurements.
pub(super) fn labels(environments: &[&Value]) -> Vec<String> {
    let parts: Vec<[String; PARTS]> = environments.iter().map(|one| parts(one)).collect();
    let name = |of: &[String; PARTS], words: &[usize]| {
        let words: Vec<&str> = words.iter().map(|part| of[*part].as_str()).collect();
        let words = words.join(", ");
        if words.is_empty() { of[0].clone() } else { format!("{} ({words})", of[0]) }
    };
    // Which parts besides the processor each name has.
    let mut chosen: Vec<Vec<usize>> = vec![Vec::new(); parts.len()];
    for part in 1..PARTS {
        let names: Vec<String> =
            parts.iter().zip(&chosen).map(|(of, chosen)| name(of, chosen)).collect();
        for (index, own) in names.iter().enumerate() {
            let alike = (0..names.len()).filter(|other| names[*other] == *own);
            if alike.map(|other| &parts[other][part]).any(|other| *other != parts[index][part]) {
                chosen[index].push(part);
            }
        }
    }
    let names = parts.iter().zip(&chosen).map(|(of, chosen)| name(of, chosen));
    let mut labels: Vec<String> = Vec::new();
    let mut seen: Vec<String> = Vec::new();
    for name in names {
        let before = seen.iter().filter(|other| **other == name).count();
        labels.push(if before == 0 { name.clone() } else { format!("{name} #{}", before + 1) });
        seen.push(name);
    }
    labels
}

const PARTS: usize = 6;

/// What tells environments apart, coarsest first. What is not known is said so, since it may be
/// the only difference.
fn parts(environment: &Value) -> [String; PARTS] {
    let text = |pointer: &str| {
        let value = environment.pointer(pointer).filter(|value| !value.is_null());
        value.map(|value| value.as_str().map_or_else(|| value.to_string(), str::to_owned))
    };
    let known = |what: &str, pointer: &str| {
        text(pointer).map_or_else(|| format!("unknown {what}"), |text| format!("{what} {text}"))
    };
    let unnamed = || "unknown machine".to_owned();
    let target = text("/build/target").unwrap_or_else(|| "unknown target".to_owned());
    let flags =
        text("/build/flags").map_or("no flags".to_owned(), |flags| format!("flags {flags}"));
    let commit: String =
        known("commit", "/build/commit").chars().take("commit ".len() + 12).collect();
    [
        text("/machine/processor").unwrap_or_else(unnamed),
        known("id", "/machine/processor_id"),
        format!("{target}, {}", known("opt-level", "/build/opt_level")),
        flags,
        format!("{}, {commit}", known("compiler", "/build/compiler")),
        known("test bed", "/testbed_id"),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn environment(processor: &str, target: &str, level: &str, commit: &str) -> Value {
        json!({
            "testbed_id": processor,
            "machine": { "processor": processor, "processor_id": "A 1" },
            "build": { "target": target, "opt_level": level, "commit": commit, "compiler": "rustc 1" },
            "load_average": [0.5],
        })
    }

    #[test]
    fn the_same_machine_and_build_are_the_same_whatever_the_load() {
        let one = environment("P", "x86_64", "3", "aa");
        let mut other = one.clone();
        other["load_average"] = json!([7.0]);
        assert_eq!(identity(&one), identity(&other));
        for differing in [
            environment("Q", "x86_64", "3", "aa"),
            environment("P", "i686", "3", "aa"),
            environment("P", "x86_64", "3", "ab"),
        ] {
            assert_ne!(identity(&one), identity(&differing));
        }
        assert_eq!(identity(&json!({ "testbed_id": "P" })), None);
        assert_eq!(identity(&Value::Null), None);
    }

    #[test]
    fn a_name_says_what_differs_and_no_more() {
        let of = |environments: &[&Value]| labels(environments);
        let p = environment("P", "x86_64", "3", "aa");
        let q = environment("Q", "i686", "2", "bb");
        assert_eq!(of(&[&p]), ["P"]);
        assert_eq!(of(&[&p, &q]), ["P", "Q"]);
        let p2 = environment("P", "x86_64", "2", "aa");
        assert_eq!(of(&[&p, &q, &p2]), ["P (x86_64, opt-level 3)", "Q", "P (x86_64, opt-level 2)"]);
        let later = environment("P", "x86_64", "3", "bb");
        assert_eq!(
            of(&[&p, &later, &p2]),
            [
                "P (x86_64, opt-level 3, compiler rustc 1, commit aa)",
                "P (x86_64, opt-level 3, compiler rustc 1, commit bb)",
                "P (x86_64, opt-level 2)"
            ]
        );
        assert_eq!(of(&[&p, &p, &p]), ["P", "P #2", "P #3"]);
    }

    #[test]
    fn processors_of_one_name_are_told_apart_by_their_ids() {
        let p = environment("P", "x86_64", "3", "aa");
        let mut newer = p.clone();
        newer["machine"]["processor_id"] = json!("A 2");
        assert_eq!(labels(&[&p, &newer]), ["P (id A 1)", "P (id A 2)"]);
        assert_eq!(labels(&[&Value::Null, &p]), ["unknown machine", "P"]);
    }
}
