//! Shares of what needs no clock: put together, they are the whole, bit for bit.
#![cfg(feature = "cli")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use ray_test::table::read_json;

/// Experiments that need no clock, in whole or in part, and one that needs nothing else: id,
/// variants, workload.
const EXPERIMENTS: [(&str, &str, &str); 4] = [
    (
        "errors",
        "'^(wald|keidy|chirkov)/f(32|64)/single/sse2/early/(first|last)/plain/tuv$', \
         '^wald/f32/packet4/sse2/early/last/plain/tuv$'",
        "kind = 'errors'\nhits = 60\nseeds = 2",
    ),
    ("operations", "", "kind = 'counts'"),
    (
        "both",
        "'^(wald|keidy)/f(32|64)/single/sse2/early/last/plain/tuv$'",
        "kind = 'pairs'\ncount = 40\nreshuffled_count = 40\ndensity = [0.5]\norders = ['fixed']\n\
         errors = { hits = 50, seeds = 3 }\n\
         stiff = { cases = 80, knobs = { needle = 3, tiny = 12, grazing = 3 } }",
    ),
    (
        "times",
        "'^wald/f32/single/sse2/early/last/plain/tuv$'",
        "kind = 'pairs'\ncount = 40\nreshuffled_count = 40\ndensity = [0.5]\norders = ['fixed']",
    ),
];

/// Those of them that are shared out.
const SHARED: [&str; 3] = ["errors", "operations", "both"];

/// A folder with the experiments in it, removed when the test ends.
struct Place(PathBuf);

impl Place {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("ray_test-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder for temporary files");
        for (id, variants, workload) in EXPERIMENTS {
            let text = format!(
                "id = '{id}'\ntitle = 'A test'\nquestion = 'Does it add up?'\nwhy = 'It must.'\n\
                 variants = [{variants}]\n[workload]\n{workload}\n"
            );
            fs::write(path.join(format!("{id}.toml")), text).expect("ours");
        }
        Place(path)
    }

    fn program(&self, words: &str) -> Output {
        let program = env!("CARGO_BIN_EXE_ray_test");
        let mut command = Command::new(program);
        command.current_dir(&self.0).args(words.split(' '));
        // Of its own: nothing here looks at times.
        command.env("RAY_TEST_LOCK", self.0.join("lock")).env("RAY_TEST_PATIENCE", "0");
        command.output().expect("the program starts")
    }

    /// Runs the program, which must succeed; what it says on stderr.
    fn succeed(&self, words: &str) -> String {
        let output = self.program(words);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{words}: {message}");
        message
    }

    /// Runs the program, which must refuse and say these words.
    fn refused(&self, words: &str, parts: &[&str]) {
        let output = self.program(words);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{words}: {message}");
        for part in parts {
            assert!(message.contains(part), "{words}: no '{part}' in: {message}");
        }
    }

    fn table(&self, run: &str, id: &str) -> Vec<u8> {
        let file = self.0.join(run).join(id).join("rows.csv");
        fs::read(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
    }

    fn lines(&self, run: &str, id: &str) -> usize {
        self.table(run, id).iter().filter(|byte| **byte == b'\n').count()
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const ALL: &str = "errors.toml operations.toml both.toml times.toml";

#[test]
fn merged_shards_are_the_unsplit_run_bit_for_bit() {
    let place = Place::new("shards");
    for part in 1..=3 {
        let said = place.succeed(&format!("run {ALL} --shard {part}/3 --out part-{part}"));
        assert!(said.contains("only what needs no clock is shared out: times"), "{said}");
        assert!(said.contains("their times, as well: both"), "{said}");
        assert!(!place.0.join(format!("part-{part}/times")).exists());
    }
    place.succeed(&format!("run {ALL} --shard 1/1 --out whole"));
    place.succeed("report part-3 part-1 part-2 --out merged");
    for id in SHARED {
        assert!(place.table("merged", id) == place.table("whole", id), "{id}");
        // Each part has work of its own, about as much as the others.
        let lines = [1, 2, 3].map(|part| place.lines(&format!("part-{part}"), id) - 1);
        let whole = place.lines("whole", id) - 1;
        assert_eq!(lines.iter().sum::<usize>(), whole, "{id}: {lines:?}");
        assert!(lines.iter().all(|lines| *lines > whole / 6), "{id}: {lines:?}");
        let run = |of: &str| read_json(&place.0.join(of).join(id).join("rows.json")).expect("json");
        let (merged, whole) = (run("merged"), run("whole"));
        assert_eq!(merged.workload_hash, whole.workload_hash);
        assert_eq!((merged.seed, &merged.rows), (whole.seed, &whole.rows));
        assert_eq!(merged.environment["complete"], true);
    }
    // Without --shard the same rows, where nothing else is measured.
    place.succeed("run errors.toml operations.toml --out unsplit");
    for id in ["errors", "operations"] {
        assert!(place.table("unsplit", id) == place.table("whole", id), "{id}");
    }
    // What was put together is a result like any other.
    place.succeed("compare merged whole");
    let said = place.succeed("report part-1 part-3 --out gap");
    assert!(said.contains("errors: of an interrupted run, or a part is missing"), "{said}");
}

#[test]
fn stiff_cases_in_parts_by_form() {
    let place = Place::new("shards-stability");
    let words = "stability --depth quick --families tiny,grazing,lattice-mesh,spawned-rays \
                 --kernels wald,chirkov,woop-watertight,keidy";
    for part in 1..=3 {
        place.succeed(&format!("{words} --shard {part}/3 --out part-{part}"));
    }
    place.succeed(&format!("{words} --out whole"));
    place.succeed("report part-2 part-3 part-1 --out merged");
    assert!(place.table("merged", "stability") == place.table("whole", "stability"));
    // The figures, too, which parts have none of.
    let figures = |run: &str| -> Vec<PathBuf> {
        let files = fs::read_dir(place.0.join(run).join("stability")).expect("it was made");
        let files = files.map(|file| file.expect("ours").path());
        let mut files: Vec<PathBuf> =
            files.filter(|file| file.extension().is_some_and(|end| end == "svg")).collect();
        files.sort();
        files
    };
    assert!(figures("part-1").is_empty() && figures("whole").len() > 2);
    let name = |file: &Path| file.file_name().map(ToOwned::to_owned);
    for (merged, whole) in figures("merged").iter().zip(figures("whole")) {
        assert_eq!(name(merged), name(&whole));
        assert!(fs::read(merged).expect("ours") == fs::read(&whole).expect("ours"), "{whole:?}");
    }
    assert_eq!(figures("merged").len(), figures("whole").len());
}

#[test]
fn words_that_name_no_share_are_refused() {
    let place = Place::new("shards-words");
    for word in ["0/3", "4/3", "3", "a/b", "1/0", "+1/2"] {
        for verb in ["run errors.toml", "reproduce", "stability"] {
            place.refused(&format!("{verb} --shard {word}"), &["--shard", word, "1 <= I <= N"]);
        }
    }
    place.refused("run times.toml --shard 1/2 --out no", &["--shard", "times", "allowed"]);
    place.refused("run errors.toml --shard 1/2 --save-baseline x", &["--shard"]);
    assert!(!place.0.join("no").exists());
}

#[test]
fn a_share_is_gone_on_with_as_the_same_share() {
    let place = Place::new("shards-resume");
    let first = place.succeed("run errors.toml operations.toml --shard 1/2 --out part");
    assert!(!first.contains("finished before"), "{first}");
    fs::remove_dir_all(place.0.join("part/operations")).expect("it was made");
    let again = place.succeed("run errors.toml operations.toml --shard 1/2 --out part --resume");
    assert_eq!(again.matches("finished before").count(), 1, "{again}");
    assert!(place.lines("part", "operations") > 1);
    let other = "run errors.toml operations.toml --shard 2/2 --out part --resume";
    place.refused(other, &["--resume", "another config", "--shard 1/2", "--shard 2/2"]);
    place.refused("run errors.toml --out part --resume", &["--resume", "--shard 1/2"]);
}

#[test]
fn a_report_is_made_where_nothing_is_lost() {
    let place = Place::new("shards-report");
    place.succeed("run errors.toml --shard 1/1 --out one");
    let rows = place.table("one", "errors");
    place.succeed("report one");
    assert!(place.table("one", "errors") == rows);
    place.refused("report one one/errors", &["--out", "allowed"]);
    place.refused("report one/errors", &["--out", "allowed"]);
    place.refused("report one one/errors --out one", &["--out", "would be lost"]);
    place.refused("report missing", &["missing", "allowed"]);
    fs::create_dir_all(place.0.join("empty")).expect("ours");
    place.refused("report empty", &["empty", "allowed"]);
    place.refused("report", &["DIR"]);
    place.succeed("report one/errors --out of-one");
    assert!(place.table("of-one", "errors") == rows);
    // What describes the experiment comes along.
    let text = |run: &str| fs::read(place.0.join(run).join("errors/experiment.toml")).expect(run);
    assert_eq!(text("of-one"), text("one"));
}
