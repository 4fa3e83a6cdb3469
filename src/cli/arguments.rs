//! What may stand on the command line.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};

use super::baseline::Baselines;
use super::check::{self, Check};
use super::compare::Compare;
use super::manual::{self, Completions, Manual};
use super::recommend::{self, Recommend};
use super::render::{self, Render};
use super::report::{self, Report};
use super::scene::{self, Scene};
use super::slips::slip;
use super::stability::{self, Stability};
use super::words::words;
use crate::experiment::Profile;
use crate::measure::{Order, Pin};
use crate::shard::Shard;
use crate::workload::Generator;

const EXAMPLES: &str = "\
Examples:
  ray_test 0.3 2000 10000      2000 pairs of which exactly 600 hit, each 10000 times in a row
  ray_test all 2000 1000       densities 0, 0.25, 0.5, 0.75 and 1
  ray_test reproduce           every experiment, some two minutes; then the report
  ray_test list kernels        what there is";

/// Which ray-triangle routine to use, how fast it is, and how wrong.
///
/// Without a verb it is the program of the 2007 thesis: Moeller, Badouel and Chirkov on pairs of a
/// chosen hit density. DENSITY missing, or no number in [0, 1], means the sweep 0, 0.25, 0.5,
/// 0.75, 1.
#[derive(Parser, Debug)]
#[command(version, after_help = EXAMPLES, args_conflicts_with_subcommands = true)]
pub struct Arguments {
    /// What to do instead of the thesis's test.
    #[command(subcommand)]
    pub verb: Option<Verb>,
    /// The thesis form.
    #[command(flatten)]
    pub thesis: Thesis,
}

/// `ray_test [DENSITY] [TRIANGLES] [REPEATS]`
#[derive(Args, Debug)]
pub struct Thesis {
    /// Share of pairs that hit, 0 to 1; `all` for the sweep
    #[arg(allow_hyphen_values = true)]
    pub density: Option<String>,
    /// Number of pairs
    #[arg(default_value = "25000", allow_hyphen_values = true)]
    pub triangles: String,
    /// How often each pair is computed
    #[arg(default_value = "20000", allow_hyphen_values = true)]
    pub repeats: String,
    /// Where the random generator starts
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// `msvc` is the 15-bit generator of the thesis
    #[arg(long, value_enum, default_value_t = GeneratorWord::Pcg)]
    pub generator: GeneratorWord,
    /// `literal` repeats each pair in a row, as the thesis does; `fixed` replays the set;
    /// `reshuffled` permutes it before every pass
    #[arg(long, value_enum, default_value_t = OrderWord::Literal)]
    pub order: OrderWord,
    /// Kernels, separated by commas; `moller` is moller1, `chirkov` is chirkov-line
    #[arg(long, value_delimiter = ',', default_values_t = ["moller".to_owned(), "badouel".to_owned(), "chirkov".to_owned()])]
    pub kernels: Vec<String>,
    /// With or without barycentric coordinates
    #[arg(long, value_enum, default_value_t = OutputWord::T)]
    pub output: OutputWord,
    /// How results are printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// The verbs.
#[derive(Subcommand, Debug)]
pub enum Verb {
    /// Run experiments from TOML files
    #[command(
        after_help = "Examples:\n  ray_test run configs/b-4.2.toml --profile standard --out results/mine\n  ray_test run configs/b-4.2.toml --profile standard --out results/mine --resume\n\nEnvironment:\n  RAY_TEST_LOCK      file that keeps two runs from measuring at once [default: ray_test.lock in the folder for temporary files]\n  RAY_TEST_PATIENCE  how many groups of a run are measured again beside a neighbour, for every 64 rounds, however long that takes: 0 where the machine is never quiet, and nothing is [default: what fits into 10 s, single blocks included]"
    )]
    Run(Run),
    /// Run every built-in experiment
    #[command(
        after_help = "Examples:\n  ray_test reproduce\n  ray_test reproduce --dry-run\n  ray_test reproduce --filter '^wald/' --out results/wald"
    )]
    Reproduce(Reproduce),
    /// Tell whether this machine can measure, and how finely
    #[command(
        after_help = "Examples:\n  ray_test doctor\n  ray_test doctor --self-test --format json"
    )]
    Doctor(Doctor),
    /// Show kernels, variants, experiments, claims, levels or families
    #[command(after_help = "Example:\n  ray_test list variants --format csv")]
    List(List),
    /// Hold two results against each other; exit 3 if something got worse
    #[command(
        after_help = "Examples:\n  ray_test compare results/before results/after\n  ray_test compare a/b-4.2/rows.json b/b-4.2/rows.json --threshold 5% --format markdown"
    )]
    Compare(Compare),
    /// Draw everything again from stored rows; put several folders together, or compare them
    #[command(after_help = report::HELP)]
    Report(Report),
    /// Sweep stiff and extreme cases: where each kernel starts to fail, which rays it loses
    #[command(after_help = stability::HELP)]
    Stability(Stability),
    /// Put cases of your own through every kernel, against the exact answer
    #[command(after_help = check::HELP)]
    Check(Check),
    /// Tell what a mesh and its rays need of a test, what can be left out, and what that saves
    #[command(after_help = scene::HELP)]
    Scene(Scene),
    /// Tell which variant to take, by stored rows
    #[command(after_help = recommend::HELP)]
    Recommend(Recommend),
    /// Make a picture of a scene with any kernel: its time, and where it differs from the exact one
    #[command(after_help = render::HELP)]
    Render(Render),
    /// Print the script by which a shell completes
    #[command(after_help = manual::COMPLETIONS_HELP)]
    Completions(Completions),
    /// Print a page for man
    #[command(after_help = manual::MAN_HELP, hide = true)]
    Man(Manual),
}

/// `ray_test run`
#[derive(Args, Debug)]
pub struct Run {
    /// TOML files, one experiment each
    #[arg(required = true)]
    pub configs: Vec<PathBuf>,
    /// What `run` and `reproduce` share.
    #[command(flatten)]
    pub batch: Batch,
}

/// `ray_test reproduce`
#[derive(Args, Debug)]
pub struct Reproduce {
    /// What `run` and `reproduce` share.
    #[command(flatten)]
    pub batch: Batch,
}

/// What `run` and `reproduce` share.
#[derive(Args, Debug)]
pub struct Batch {
    /// How much is measured: 64, 256 or 1024 rounds
    #[arg(long, value_enum, default_value_t = ProfileWord::Quick)]
    pub profile: ProfileWord,
    /// Folder for the results [default: results/<UTC time>-<config hash>]
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Only variants whose id matches this regular expression
    #[arg(long, value_name = "RE")]
    pub filter: Option<String>,
    /// Say what would run and how long it would take
    #[arg(long)]
    pub dry_run: bool,
    /// Processor to measure on: `auto` (between groups, the quietest), `off` (any), or its number
    #[arg(long, default_value_t = Pin::Auto)]
    pub pin: Pin,
    /// Go on with an interrupted run in the folder of --out; experiment, --profile, --filter,
    /// program and machine must be the same
    #[arg(long, requires = "out")]
    pub resume: bool,
    /// Only the I-th of N parts of what needs no clock, and nothing else; `ray_test report` puts
    /// parts together
    #[arg(long, value_name = "I/N", conflicts_with_all = ["save_baseline", "baseline"])]
    pub shard: Option<Shard>,
    /// Results to keep or to be held against.
    #[command(flatten)]
    pub baselines: Baselines,
}

/// `ray_test doctor`
#[derive(Args, Debug)]
pub struct Doctor {
    /// Test the verdicts as well: a kernel against its own copies, and slowed down by known work
    /// (some minutes)
    #[arg(long)]
    pub self_test: bool,
    /// Processor to measure on: `auto` (between groups, the quietest), `off` (any), or its number
    #[arg(long, default_value_t = Pin::Auto)]
    pub pin: Pin,
    /// How it is printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// Comparisons of the self-test, a third in each order
    #[arg(long, default_value_t = 3000, hide = true, value_parser = few)]
    pub comparisons: u64,
    /// Slow-downs of the self-test
    #[arg(long, default_value_t = 100, hide = true, value_parser = few)]
    pub trials: u64,
    /// Their size, percent
    #[arg(long, default_value_t = 2.0, hide = true)]
    pub inject: f64,
    /// Time the exact answers alone, and examine nothing else
    #[arg(long, hide = true)]
    pub oracle: bool,
}

/// Comparisons that can be waited for, and counted together.
fn few(text: &str) -> Result<u64, String> {
    const MOST: u64 = 1_000_000;
    let number = text.parse().ok().filter(|number| *number <= MOST);
    number.ok_or_else(|| format!("allowed: a number from 0 to {MOST}"))
}

/// `ray_test list`
#[derive(Args, Debug)]
pub struct List {
    /// What to show
    #[arg(value_enum)]
    pub what: Listed,
    /// How it is printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// What can be shown.
#[derive(ValueEnum, Clone, Copy, Debug)]
pub enum Listed {
    /// Algorithms
    Kernels,
    /// Compiled forms
    Variants,
    /// Built-in experiments
    Experiments,
    /// Published statements
    Claims,
    /// Instruction-set levels
    Levels,
    /// Families of stiff and extreme cases
    Families,
}

/// How results are printed.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A table to read
    Text,
    /// CSV with a header
    Csv,
    /// A JSON array of flat objects
    Json,
}

words! {
    /// Order of the pairs.
    OrderWord for Order {
        Literal => Order::Literal,
        Fixed => Order::Fixed,
        Reshuffled => Order::Reshuffled,
    }
}
words! {
    /// Random generator.
    GeneratorWord for Generator {
        Pcg => Generator::Pcg,
        Msvc => Generator::Msvc,
    }
}
words! {
    /// What is computed of a hit.
    OutputWord for &'static str {
        T => "t",
        Tuv => "tuv",
    }
}
words! {
    /// How much is measured.
    ProfileWord for Profile {
        Quick => Profile::Quick,
        Standard => Profile::Standard,
        Thorough => Profile::Thorough,
    }
}

/// Parses arguments, the first of which is the name of the program.
///
/// # Errors
/// clap's, with its own message; help and version come as errors that are none.
pub fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Arguments, clap::Error> {
    let arguments = Arguments::try_parse_from(words)?;
    if arguments.verb.is_none()
        && let Some(word) = &arguments.thesis.density
        && let Some(message) = slip(word)
    {
        return Err(Arguments::command().error(clap::error::ErrorKind::InvalidSubcommand, message));
    }
    Ok(arguments)
}
