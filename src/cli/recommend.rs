//! `ray_test recommend`: from stored rows, the variant to take.

use std::io::Write;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use serde_json::json;

use super::arguments::Format;
use super::failure::Failure;
use super::known::known_variants;
use super::recommend_rows;
use super::show::{Sheet, print};
use crate::recommend::{Needs, Packets, Question, RecommendError, Recommendation, recommend};

/// What is said below the options.
pub const HELP: &str = "Examples:
  ray_test recommend
  ray_test recommend --precision f32 --needs t --rays-per-triangle 8
  ray_test recommend --watertight --from results/mine --format json
  ray_test recommend --tolerance 1e-6 --packets
  ray_test recommend --precision f32 --common-origin

Nothing is measured. Times are those of the newest run under results/, or of the folders of --from; run
`ray_test reproduce` first. Rays that no predictor can foresee decide (order `reshuffled`). Exit code 2 if
nothing that was timed fits.";

/// `ray_test recommend`
#[derive(Args, Debug)]
pub struct Recommend {
    /// Only this precision [default: either]
    #[arg(long, value_enum)]
    pub precision: Option<PrecisionWord>,
    /// What must be reported of a hit; what reports more will do
    #[arg(long, value_enum, default_value_t = NeedsWord::Tuv)]
    pub needs: NeedsWord,
    /// Rays that a triangle is tested against before it changes, so that what is prepared of it
    /// counts
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub rays_per_triangle: Option<u64>,
    /// No ray through a shared edge or vertex may be lost
    #[arg(long)]
    pub watertight: bool,
    /// Largest allowed error of a barycentric weight, at the 99th percentile of random hits
    #[arg(long, value_name = "X", value_parser = tolerance, allow_negative_numbers = true)]
    pub tolerance: Option<f64>,
    /// Packets of rays will do as well as single rays
    #[arg(long)]
    pub packets: bool,
    /// Packets of rays that start in one point will do as well
    #[arg(long)]
    pub common_origin: bool,
    /// Folders of results, of one machine [default: the newest under results/]
    #[arg(long, value_name = "DIR", num_args = 1..)]
    pub from: Vec<PathBuf>,
    /// How it is printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// A precision.
#[derive(ValueEnum, Clone, Copy, Debug)]
#[allow(missing_docs, reason = "the words explain themselves where they are used")]
pub enum PrecisionWord {
    F32,
    F64,
}

/// What must be reported.
#[derive(ValueEnum, Clone, Copy, Debug)]
#[allow(missing_docs, reason = "the words explain themselves where they are used")]
pub enum NeedsWord {
    Hit,
    T,
    Tuv,
    Surface,
}

fn tolerance(text: &str) -> Result<f64, String> {
    let positive = text.parse().ok().filter(|number: &f64| number.is_finite() && *number > 0.0);
    positive.ok_or_else(|| "allowed: a number above 0, such as 1e-6".to_owned())
}

/// Reads, chooses, prints.
///
/// # Errors
/// Usage for folders without rows, and where nothing that was timed fits.
pub fn run(arguments: &Recommend) -> Result<(), Failure> {
    let results = recommend_rows::read(&arguments.from)?;
    let found = recommend(&results, &question(arguments), &known_variants())?;
    match arguments.format {
        Format::Text => write!(std::io::stdout(), "{}", text(&found))?,
        Format::Csv => print(&sheet(&found), Format::Csv)?,
        Format::Json => {
            let json = serde_json::to_string_pretty(&found)
                .map_err(|error| Failure::Runtime(error.into()))?;
            writeln!(std::io::stdout(), "{json}")?;
        }
    }
    Ok(())
}

/// The question in the words of the library.
pub fn question(arguments: &Recommend) -> Question {
    let precision = arguments.precision.map(|word| match word {
        PrecisionWord::F32 => "f32",
        PrecisionWord::F64 => "f64",
    });
    Question {
        precision: precision.map(str::to_owned),
        needs: match arguments.needs {
            NeedsWord::Hit => Needs::Hit,
            NeedsWord::T => Needs::T,
            NeedsWord::Tuv => Needs::Tuv,
            NeedsWord::Surface => Needs::Surface,
        },
        rays_per_triangle: arguments.rays_per_triangle,
        watertight: arguments.watertight,
        tolerance: arguments.tolerance,
        packets: match (arguments.common_origin, arguments.packets) {
            (true, _) => Packets::FromOnePoint,
            (false, true) => Packets::OfAnyRays,
            (false, false) => Packets::None,
        },
    }
}

fn sheet(found: &Recommendation) -> Sheet {
    let columns = vec![
        "variant",
        "runner_up",
        "runner_up_costs_percent",
        "runner_up_costs_low_percent",
        "runner_up_costs_high_percent",
        "runner_up_is_slower",
        "because",
        "code",
    ];
    let row = vec![
        json!(found.variant),
        json!(found.runner_up),
        json!(found.runner_up_costs_percent),
        json!(found.runner_up_costs_low_percent),
        json!(found.runner_up_costs_high_percent),
        json!(found.runner_up_is_slower),
        json!(found.because.join(" ")),
        json!(found.code),
    ];
    Sheet { columns, rows: vec![row] }
}

/// Columns of a text.
const WIDTH: usize = 100;

/// A recommendation to read.
pub fn text(found: &Recommendation) -> String {
    let next = match (&found.runner_up, found.runner_up_costs_percent) {
        (Some(id), Some(percent)) => {
            let is_slower = found.runner_up_is_slower == Some(true);
            let words = if is_slower { format!("{percent:+.1} %") } else { "no difference".into() };
            format!("{id}  ({words})")
        }
        _ => "none".to_owned(),
    };
    let mut out = format!("take       {}\nnext best  {next}\n\nbecause\n", found.variant);
    for sentence in &found.because {
        out += &wrapped(sentence);
    }
    out += "\nin Rust\n";
    for line in found.code.lines() {
        out += &format!("  {line}\n");
    }
    out
}

/// A sentence as an item of a list, in lines of at most [`WIDTH`] columns; a word that is longer
/// stands alone.
fn wrapped(sentence: &str) -> String {
    let (mut out, mut line) = (String::new(), "  -".to_owned());
    for word in sentence.split_whitespace() {
        if line.chars().count() + 1 + word.chars().count() > WIDTH && line.trim() != "-" {
            out += &format!("{}\n", line.trim_end());
            line = "   ".to_owned();
        }
        line += &format!(" {word}");
    }
    format!("{out}{line}\n")
}

impl From<RecommendError> for Failure {
    fn from(error: RecommendError) -> Self {
        Failure::Usage(error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[test]
    fn texts_keep_to_the_width() {
        let words = wrapped(&"word ".repeat(60));
        assert!(words.lines().all(|line| line.len() <= WIDTH) && words.lines().count() == 4);
        assert_eq!(words.split_whitespace().filter(|word| *word == "word").count(), 60);
    }

    #[test]
    fn a_question_in_words_is_understood_as_it_was_meant() {
        #[derive(clap::Parser)]
        struct Parsed {
            #[command(flatten)]
            recommend: Recommend,
        }
        let all = Question {
            precision: Some("f64".to_owned()),
            needs: Needs::T,
            rays_per_triangle: Some(7),
            watertight: true,
            tolerance: Some(2.5e-7),
            packets: Packets::OfAnyRays,
        };
        let from_one = Question { packets: Packets::FromOnePoint, ..Question::default() };
        for meant in [all, from_one, Question::default()] {
            let words = format!("recommend{}", meant.arguments());
            let parsed = Parsed::try_parse_from(words.split(' ')).expect(&words);
            assert_eq!(question(&parsed.recommend), meant, "{words}");
        }
    }

    #[test]
    fn tolerances_are_positive_numbers() {
        assert_eq!(tolerance("1e-6"), Ok(1e-6));
        for wrong in ["0", "-1", "inf", "NaN", "small"] {
            assert!(tolerance(wrong).is_err(), "{wrong}");
        }
    }
}
