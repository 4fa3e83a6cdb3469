//! `ray_test stability`: stiff and extreme cases, and where each kernel starts to fail.

use std::io::Write;
use std::num::NonZero;
use std::path::PathBuf;

use clap::Args;

use super::arguments::Format;
use super::failure::Failure;
use super::folder::Folder;
use super::show::print;
use super::sweep::{draw, sweep_into};
use super::{shards, stability_tables};
use crate::measure::Environment;
use crate::report::count;
use crate::shard::Shard;
use crate::stability::{Depth, Family, Precision, Sweep, families, forms, known_words};
use crate::workload::hash::Fnv;

/// What is said below the options.
pub const HELP: &str = "Examples:
  ray_test stability
  ray_test stability --families needle,far --precision f32 --out results/needles
  ray_test stability --kernels moller-trumbore,woop-watertight --format csv
  ray_test stability --shard 2/3 --out results/part-2

A kernel's id asks for its usual form, a variant's id for that form (in the early form with output
tuv; `ray_test list variants`). `ray_test list families` shows the families. No clock is read: the
rows are the same on every machine.";

/// `ray_test stability`
#[derive(Args, Debug)]
pub struct Stability {
    /// Only these families, separated by commas
    #[arg(long, value_delimiter = ',')]
    pub families: Vec<String>,
    /// Only these kernels or variants, separated by commas
    #[arg(long, value_delimiter = ',')]
    pub kernels: Vec<String>,
    /// Only this precision
    #[arg(long, value_enum)]
    pub precision: Option<PrecisionWord>,
    /// Folder for the results [default: results/<UTC time>-<config hash>]
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// How much is drawn: 1000, 10000 or 50000 cases a setting
    #[arg(long, value_enum, default_value_t = DepthWord::Standard)]
    pub depth: DepthWord,
    /// Where the random generators start
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Only the I-th of N parts, a share of the forms; `ray_test report` puts parts together
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// How the summary is printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// A precision.
#[derive(clap::ValueEnum, Clone, Copy, Debug)]
#[allow(missing_docs, reason = "the words explain themselves where they are used")]
pub enum PrecisionWord {
    F32,
    F64,
}

/// How much is drawn.
#[derive(clap::ValueEnum, Clone, Copy, Debug)]
#[allow(missing_docs, reason = "the words explain themselves where they are used")]
pub enum DepthWord {
    Quick,
    Standard,
    Thorough,
}

/// Checks everything, sweeps, writes rows and figures, prints the summary.
pub fn run(arguments: &Stability) -> Result<(), Failure> {
    let sweep = sweep(arguments)?;
    let environment = shards::environment();
    let hash = hash(arguments, &environment);
    let folder = Folder::new(arguments.out.as_deref(), hash, environment, String::new());
    let folder = arguments.shard.into_iter().fold(folder, Folder::of_shard);
    folder.create()?;
    let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
    say!(
        "{}, {} of kernels{}, about {:.0} s on {}; results in {}",
        count(sweep.families.len(), "family", "families"),
        count(sweep.forms.len(), "form", "forms"),
        arguments.shard.map_or(String::new(), |shard| format!(" (part {shard} of them)")),
        sweep.seconds(processors).ceil(),
        count(processors, "processor", "processors"),
        folder.path().display()
    );
    let outcome = sweep_into(&folder, &sweep)?;
    if outcome.complete && !folder.is_of_shard() {
        say!("{}", count(draw(&folder, &outcome)?, "figure", "figures"));
    }
    match arguments.format {
        Format::Text => write!(std::io::stdout(), "{}", stability_tables::text(&outcome.rows))?,
        format => print(&stability_tables::sheet(&outcome.rows), format)?,
    }
    if arguments.format == Format::Text {
        writeln!(std::io::stdout(), "{}", folder.path().display())?;
    }
    if !outcome.complete {
        say!("what was done is saved in {}", folder.path().display());
        return Err(Failure::Interrupted);
    }
    Ok(())
}

/// What is swept.
///
/// # Errors
/// Usage for families and kernels that there are not.
pub fn sweep(arguments: &Stability) -> Result<Sweep, Failure> {
    let precision = arguments.precision.map(|word| match word {
        PrecisionWord::F32 => Precision::F32,
        PrecisionWord::F64 => Precision::F64,
    });
    let depth = match arguments.depth {
        DepthWord::Quick => Depth::Quick,
        DepthWord::Standard => Depth::Standard,
        DepthWord::Thorough => Depth::Thorough,
    };
    let families = chosen(&arguments.families)?;
    let forms = forms(&arguments.kernels, precision).map_err(|unknown| {
        refused("--kernels", &unknown.word, &known_words(), "`ray_test list kernels` shows them")
    })?;
    if forms.is_empty() {
        let asked = arguments.kernels.join(",");
        return Err(Failure::Usage(format!(
            "--kernels: '{asked}' has no form in this precision; allowed: the other one, or other \
             kernels"
        )));
    }
    let shard = arguments.shard.unwrap_or_default();
    Ok(Sweep { families, forms, depth, seed: arguments.seed, shard })
}

/// The families asked for, in their usual order; all without a word.
fn chosen(words: &[String]) -> Result<Vec<Family>, Failure> {
    let mut all = families();
    let known: Vec<String> = all.iter().map(|family| family.id.to_owned()).collect();
    if let Some(word) = words.iter().find(|word| !known.contains(word)) {
        return Err(refused("--families", word, &known, &format!("allowed: {}", known.join(", "))));
    }
    all.retain(|family| words.is_empty() || words.iter().any(|word| word == family.id));
    Ok(all)
}

fn refused(option: &str, word: &str, known: &[String], allowed: &str) -> Failure {
    let alike = |known: &&String| strsim::jaro_winkler(word, known);
    let best = known.iter().max_by(|a, b| alike(a).total_cmp(&alike(b)));
    let best = best.map(|best| format!(" Did you mean '{best}'?")).unwrap_or_default();
    Failure::Usage(format!("{option}: '{word}' is not known; {allowed}.{best}"))
}

fn hash(arguments: &Stability, environment: &Environment) -> u64 {
    let mut hash = Fnv::default();
    let settings = format!(
        "{:?} {:?} {:?} {:?} {} {}",
        arguments.families,
        arguments.kernels,
        arguments.precision,
        arguments.depth,
        arguments.seed,
        arguments.shard.unwrap_or_default()
    );
    hash.bytes(settings.as_bytes());
    hash.bytes(format!("{:?}", environment.build).as_bytes());
    hash.finish()
}
