//! A small run, how it is started, and how what it leaves is read.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use ray_test::table::{Row, read_csv, read_journal, read_json, read_rounds};

/// The experiments: id, variants, workload. Of each kind that has pieces of its own, one.
const EXPERIMENTS: [(&str, &str, &str); 5] = [
    (
        // Two groups of listings, and one that cannot be asked; and a figure that has two rows in one
        // place, which is no reason to lose what was measured.
        "pairs",
        "'^(moller[0-3]|badouel|chirkov-line|wald)/f32/single/sse2/early/[a-z]+/plain/t(uv)?$', \
         '^keidy/f32/single/sse2/early/last/plain/tuv/query=point$'",
        "kind = 'pairs'\ncount = 60\nreshuffled_count = 60\ndensity = [0.25]\n\
         orders = ['literal', 'fixed', 'reshuffled']\nseconds_of_tests = 1000.0\n\
         [[figure]]\nfile = 'pairs'\nkind = 'bars'\nquestion = 'Which is the fastest?'\n\
         x = 'kernel'\ny = 'ns_per_test'\npanels = 'order'",
    ),
    (
        // Groups that take no turns, so that there are pieces before the end.
        "searches",
        "",
        "kind = 'structures'\nscenes = ['soup:20', 'soup:40', 'terrain:3']\n\
         rays = ['primary', 'random']\nwidth = 16\nlist_tests = 5000\n\
         kernels = ['moller-trumbore', 'wald']\nstructures = ['list']",
    ),
    (
        "codes",
        "'^(moller1|badouel)/f32/single/sse2/early/[a-z]+/plain/t$'",
        "kind = 'codes'\npairs = 2000\ntimed_pairs = 50\norders = ['literal', 'fixed']",
    ),
    (
        "priced",
        "'^moller1/f32/single/sse2/early/last/plain/t(/priced=dot(-control)?)?$'",
        "kind = 'pairs'\ncount = 40\nreshuffled_count = 40\ndensity = [0.25, 0.5]\n\
         orders = ['fixed']",
    ),
    ("units", "", "kind = 'arithmetic'"),
];

/// The ids, in the order in which they run.
pub fn experiments() -> impl Iterator<Item = &'static str> {
    EXPERIMENTS.iter().map(|(id, ..)| *id)
}

/// A folder with the experiments in it, removed when the test ends.
pub struct Place(PathBuf);

impl Place {
    pub fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("ray_test-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder for temporary files");
        for (id, variants, workload) in EXPERIMENTS {
            let text = format!(
                "id = '{id}'\ntitle = 'A test'\nquestion = 'Does it go on?'\nwhy = 'It must.'\n\
                 variants = [{variants}]\n[workload]\n{workload}\n"
            );
            fs::write(path.join(format!("{id}.toml")), text).expect("the folder was just made");
        }
        Place(path)
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// A run into a folder of this place, with a lock of its own and more words.
    pub fn run(&self, out: &str, more: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ray_test"));
        command.current_dir(&self.0).env("RAY_TEST_LOCK", self.path("lock")).arg("run");
        // Beside a neighbour the times are no good, and nobody here asks for them.
        command.env("RAY_TEST_PATIENCE", "0");
        command.args(experiments().map(|id| format!("{id}.toml")));
        command.arg("--out").arg(out).args(more);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    /// Runs to the end.
    pub fn finish(&self, out: &str, more: &[&str]) -> Output {
        let output = self.run(out, more).output().expect("the program starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        output
    }

    pub fn journal(&self, out: &str, id: &str) -> PathBuf {
        self.path(out).join(id).join("rows.ndjson")
    }

    /// The rows of a finished run; nothing of the way there may be left.
    pub fn rows(&self, out: &str) -> Vec<Row> {
        let mut all = Vec::new();
        for id in experiments() {
            let folder = self.path(out).join(id);
            let run = read_json(&folder.join("rows.json")).expect("a finished run has it");
            assert_eq!(run.environment["complete"], true, "{id}");
            let rows = read_csv(&folder.join("rows.csv")).expect("a finished run has it");
            assert_eq!(rows, run.rows, "{id}");
            all.extend(rows);
        }
        let rest = |path: &PathBuf| {
            let name = path.to_string_lossy();
            name.ends_with(".partial") || name.ends_with(".ndjson")
        };
        let rest: Vec<PathBuf> = files(&self.path(out)).into_iter().filter(rest).collect();
        assert!(rest.is_empty(), "{rest:?}");
        all
    }

    /// Rows that the journals of an unfinished run hold. Every file that it has left must parse.
    pub fn read_everything(&self, out: &str) -> Vec<Row> {
        let mut kept = Vec::new();
        for file in files(&self.path(out)) {
            let extension = file.extension().and_then(|text| text.to_str()).unwrap_or("");
            match extension {
                "csv" if file.ends_with("rounds.csv") => {
                    drop(read_rounds(&file).expect("rounds that can be read"));
                }
                "csv" if file.ends_with("rows.csv") => {
                    drop(read_csv(&file).expect("a whole table"));
                }
                "toml" => {
                    let text = fs::read_to_string(&file).expect("it can be read");
                    text.parse::<toml::Table>().expect("a whole experiment");
                }
                // What is made of the rows at the end, written as a whole.
                "csv" | "svg" | "html" | "md" => {}
                "ndjson" => {
                    let journal = read_journal(&file).expect("a journal that can be read");
                    let pieces = journal.expect("it is there").pieces;
                    kept.extend(pieces.into_iter().flat_map(|(_, rows)| rows));
                }
                "json" if file.ends_with("rows.json") => {
                    drop(read_json(&file).expect("whole rows"))
                }
                "json" => {
                    let text = fs::read(&file).expect("it can be read");
                    serde_json::from_slice::<serde_json::Value>(&text).expect("whole JSON");
                }
                "partial" => {}
                other => unreachable!("{other}: {}", file.display()),
            }
        }
        kept
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).ok();
    }
}

/// Every file below a folder; none if there is no such folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let paths = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    paths.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

/// Waits for what is sure to come; a minute is for machines that hang.
pub fn wait_for(what: &str, come: impl Fn() -> bool) {
    for _ in 0..60_000 {
        if come() {
            return;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    unreachable!("it never came: {what}");
}

/// Lines of a file; 0 if it is not there.
pub fn lines(path: &Path) -> usize {
    fs::read_to_string(path).map_or(0, |text| text.lines().count())
}

/// The rows without what the clock says.
pub fn without_clock(rows: &[Row]) -> Vec<Row> {
    rows.iter().map(Row::without_clock).collect()
}

/// Asserts that two runs have the same rows in the same order, but for what the clock says.
pub fn assert_same(now: &[Row], before: &[Row], when: &str) {
    assert_eq!(now.len(), before.len(), "{when}");
    assert!(now.iter().all(|row| !row.reason.starts_with("interrupted")), "{when}");
    for (now, before) in without_clock(now).iter().zip(&without_clock(before)) {
        assert_eq!(now.difference(before), None, "{when}: {}", now.id);
    }
}

/// Asserts that rows of a journal were taken as they are, and not measured again. Three columns are
/// of all rows together.
pub fn assert_taken(kept: &[Row], rows: &[Row], when: &str) {
    let own =
        |row: &Row| Row { seconds: None, seconds_mean: None, percent_slower: None, ..row.clone() };
    let rows: Vec<Row> = rows.iter().map(own).collect();
    for row in kept {
        assert!(rows.contains(&own(row)), "{when}: {} was measured again", row.id);
    }
}
