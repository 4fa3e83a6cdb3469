//! The command line: one file per verb.

#[macro_use]
mod say;

mod addresses;
mod arguments;
mod baseline;
mod batch;
mod built_in;
mod check;
mod check_forms;
mod check_rows;
mod check_summary;
mod compare;
mod comparison;
mod describe;
mod doctor;
#[doc(hidden)]
pub mod doors;
mod estimate;
mod failure;
mod folder;
mod instruments;
mod interrupt;
mod known;
mod list;
mod lock;
mod manual;
mod progress;
mod publish;
mod recommend;
mod recommend_rows;
mod render;
mod render_files;
mod render_frames;
mod render_kernels;
mod render_rows;
mod report;
mod rounds;
mod scene;
mod scene_text;
mod shards;
mod show;
mod slices;
mod slips;
mod stability;
mod stability_tables;
mod stored;
mod sweep;
mod thesis;
mod thesis_asked;
mod unfinished;
mod words;

use std::process::ExitCode;

use arguments::{Arguments, Verb};
use failure::Failure;

/// Parses the arguments, runs the verb, and tells the exit code: 0 done, 1 failed at run time,
/// 2 wrong usage, config or input, 3 a confirmed regression, 4 a wrong answer, 130 interrupted.
pub fn main() -> ExitCode {
    interrupt::let_writes_fail();
    addresses::on_own_stack(parse_and_run)
}

fn parse_and_run() -> ExitCode {
    let outcome = match arguments::parse(std::env::args_os()) {
        Ok(arguments) => run(arguments),
        // Help and version are no failures; clap knows which stream they belong to.
        Err(error) => {
            let printed = error.print();
            if error.use_stderr() {
                return ExitCode::from(2);
            }
            printed.map_err(Failure::from)
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.print();
            ExitCode::from(failure.code())
        }
    }
}

fn run(arguments: Arguments) -> Result<(), Failure> {
    let measures = |verb: &Verb| {
        matches!(
            verb,
            Verb::Run(_) | Verb::Reproduce(_) | Verb::Doctor(_) | Verb::Render(_) | Verb::Scene(_)
        )
    };
    if arguments.verb.as_ref().is_none_or(measures) {
        addresses::settle();
    }
    match arguments.verb {
        None => thesis::run(&arguments.thesis),
        Some(Verb::Run(run)) => batch::run(&run),
        Some(Verb::Reproduce(reproduce)) => batch::reproduce(&reproduce),
        Some(Verb::Doctor(doctor)) => doctor::run(&doctor),
        Some(Verb::List(list)) => list::run(&list),
        Some(Verb::Compare(compare)) => compare::run(&compare),
        Some(Verb::Report(report)) => report::run(&report),
        Some(Verb::Stability(stability)) => stability::run(&stability),
        Some(Verb::Check(check)) => check::run(&check),
        Some(Verb::Scene(scene)) => scene::run(&scene),
        Some(Verb::Recommend(recommend)) => recommend::run(&recommend),
        Some(Verb::Render(render)) => render::run(&render),
        Some(Verb::Completions(asked)) => manual::completions(&asked),
        Some(Verb::Man(asked)) => manual::man(&asked),
    }
}
