//! `ray_test check`: cases of one's own through every kernel, against the exact answer.

use std::fs::File;
use std::io::{BufRead, BufReader, IsTerminal, stdout};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use clap::{Args, ValueEnum};

use super::arguments::Format;
use super::check_forms::{Chosen, chosen};
use super::check_rows::{Label, Printer};
use super::failure::Failure;
use super::interrupt;
use crate::check::read::{Answered, Answers, Cases, ReadError};
use crate::check::{Judged, Known, Precision, Reply};

/// What stands below the options in the help.
pub const HELP: &str = "\
Examples:
  ray_test check cases.csv --format csv >rows.csv
  ray_test check cases.csv --kernels moller-trumbore,wald --precision f32
  ./my_tracer cases.csv | ray_test check cases.csv --answers - --precision f32

cases.csv (tmin, tmax and id may be left out; as JSON lines: one object a line, the same names):
  id,ox,oy,oz,dx,dy,dz,ax,ay,az,bx,by,bz,cx,cy,cz,tmin,tmax
  1,0.25,0.25,1,0,0,-1,0,0,0,1,0,0,0,1,0,0,inf

answers.csv (in the order of the cases; t, u and v may be empty):
  id,hit,t,u,v
  1,true,1,0.25,0.25

One row for each case, kernel and precision. Without an id, cases are numbered from 1. t is in units
of the direction, u is the weight of b, v of c. `where` is degenerate, coplanar, outside, behind,
vertex, edge or interior, the first that applies, or not-finite; only vertex, edge and interior are
hits. exact_t, exact_u and exact_v are those of the rounded numbers, of misses too where the line
meets the plane. Errors are in units in the last place that the exact value has in the precision; at
a u or v of 0 that place is the smallest number there is, and err_barycentric_abs says more.
non_finite names the outputs of a hit that are NaN or infinite; their cells are empty.

A kernel stands for its single, early form with output tuv: plain rounding, signs compared, its own
stored form, divided last where it can be. `chirkov` is asked for a segment from the origin to a
rounded end at least twice as far as the plane, and judged on that.";

/// `ray_test check`
#[derive(Args, Debug)]
pub struct Check {
    /// Cases: CSV with a header, or JSON lines; `-` is stdin
    pub file: PathBuf,
    /// Kernels, or variants by their full id, separated by commas [default: every kernel]
    #[arg(long, value_delimiter = ',')]
    pub kernels: Option<Vec<String>>,
    /// Precision that the numbers are rounded to [default: both; with --answers f64, which leaves
    /// them as they are]
    #[arg(long, value_enum)]
    pub precision: Option<PrecisionWord>,
    /// Judge these answers instead of running kernels: columns id, hit, t, u, v, one for each case
    /// and in the same order; `-` is stdin
    #[arg(long, value_name = "ANSWERS", conflicts_with = "kernels")]
    pub answers: Option<PathBuf>,
    /// How rows are printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// The words of `--precision`.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum PrecisionWord {
    /// 24 bits
    F32,
    /// 53 bits
    F64,
}

impl PrecisionWord {
    fn value(self) -> Precision {
        match self {
            PrecisionWord::F32 => Precision::F32,
            PrecisionWord::F64 => Precision::F64,
        }
    }
}

/// Reads a case, prints its rows, and goes on; rows before a bad line are printed.
///
/// # Errors
/// Usage for unknown kernels and bad input, with the line.
pub fn run(arguments: &Check) -> Result<(), Failure> {
    let precision = arguments.precision.map(PrecisionWord::value);
    let chosen = chosen(arguments.kernels.as_deref(), precision)?;
    let cases = Cases::new(open(&arguments.file)?, &name(&arguments.file));
    let mut printer = Printer::new(arguments.format, Box::new(stdout()));
    let read = match &arguments.answers {
        None => ask(cases, &chosen, &mut printer),
        Some(file) => {
            if file == Path::new("-") && arguments.file == Path::new("-") {
                let message = "'-' twice: stdin holds the cases or the answers, not both";
                return Err(Failure::Usage(message.into()));
            }
            let answers = Answers::new(open(file)?, &name(file));
            let answered = Answered::new(cases, answers);
            judge(answered, precision.unwrap_or(Precision::F64), &mut printer)
        }
    };
    // What was printed before a bad line is whole as well.
    printer.finish()?;
    read
}

/// Every chosen form on every case.
///
/// # Errors
/// What is wrong with a case, and where.
pub fn ask(
    mut cases: Cases<impl BufRead>,
    chosen: &[Chosen],
    printer: &mut Printer,
) -> Result<(), Failure> {
    let turns = Turns::new();
    while let Some(case) = turns.next(|| cases.advance(), printer)? {
        for group in chosen.chunk_by(|a, b| a.precision == b.precision) {
            let precision = group[0].precision;
            let ray = Known::of_ray(case.query(precision), precision);
            let has_segments = group.iter().any(|chosen| chosen.form.is_segment);
            let segment = if has_segments { ray.of_segment() } else { ray };
            for Chosen { word, form, .. } in group {
                let known = if form.is_segment { &segment } else { &ray };
                let judged = Judged::of(&Reply::of(form, known), known);
                printer.row(Label { id: &case.id, kernel: word }, known, &judged)?;
            }
        }
    }
    Ok(())
}

/// Every answer against its case.
///
/// # Errors
/// What is wrong with a case or an answer, and where.
pub fn judge(
    mut answered: Answered<impl BufRead, impl BufRead>,
    precision: Precision,
    printer: &mut Printer,
) -> Result<(), Failure> {
    let turns = Turns::new();
    while let Some((case, reply)) = turns.next(|| answered.advance(), printer)? {
        let known = Known::of_ray(case.query(precision), precision);
        let judged = Judged::of(&reply, &known);
        printer.row(Label { id: &case.id, kernel: "answers" }, &known, &judged)?;
    }
    Ok(())
}

/// What happens between two cases.
struct Turns {
    cancel: &'static std::sync::atomic::AtomicBool,
    is_watched: bool,
}

impl Turns {
    fn new() -> Self {
        Turns { cancel: interrupt::flag(), is_watched: stdout().is_terminal() }
    }

    /// The next case, unless interrupted. Who watches sees the rows of one before the next.
    fn next<T>(
        &self,
        read: impl FnOnce() -> Result<Option<T>, ReadError>,
        printer: &mut Printer,
    ) -> Result<Option<T>, Failure> {
        if self.is_watched {
            printer.flush()?;
        }
        if self.cancel.load(Ordering::Relaxed) {
            return Err(Failure::Interrupted);
        }
        Ok(read()?)
    }
}

/// What messages call a file.
fn name(file: &Path) -> String {
    if file == Path::new("-") { "stdin".into() } else { file.display().to_string() }
}

fn open(file: &Path) -> Result<Box<dyn BufRead>, Failure> {
    if file == Path::new("-") {
        return Ok(Box::new(std::io::stdin().lock()));
    }
    let refused = |what: String| Failure::Usage(format!("{}: {what}", file.display()));
    if file.is_dir() {
        return Err(refused("a folder; allowed: a file, or - for stdin".into()));
    }
    let opened = File::open(file).map_err(|error| refused(error.to_string()))?;
    Ok(Box::new(BufReader::with_capacity(1 << 16, opened)))
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        match error {
            ReadError::Io { .. } => Failure::Runtime(error.into()),
            ReadError::Line { .. } | ReadError::Whole { .. } => Failure::Usage(error.to_string()),
        }
    }
}
