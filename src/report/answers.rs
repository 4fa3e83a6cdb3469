//! Which kernel to take on this machine: the questions that the top of the report answers. What is
//! chosen, [`choose`] decides, as for `ray_test recommend`; here it is only shown.

use super::words::{between, listed, percent};
use crate::chart::short_figure;
use crate::recommend::{Behind, Choice, KnownVariant, Packets, Question, choose};
use crate::results::Results;
use crate::table::Row;

/// An answer in words; empty where there is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Answer {
    pub need: String,
    /// The command that gives the same answer from the same rows.
    pub command: String,
    pub variant: String,
    /// What else is to be said of it.
    pub note: String,
    pub time: String,
    pub speed: String,
    pub error: String,
    /// The best of another kernel, and how much slower it is.
    pub runner_up: String,
    /// What was compared.
    pub cell: String,
    /// The experiment, for a link.
    pub experiment: String,
    /// Sentences that say why.
    pub because: Vec<String>,
}

/// The questions, with the words for them.
pub(super) fn needs() -> Vec<(&'static str, Question)> {
    let in_precision =
        |precision: &str| Question { precision: Some(precision.to_owned()), ..Question::default() };
    let (single, double) = (in_precision("f32"), in_precision("f64"));
    let few = |rays| Question { rays_per_triangle: Some(rays), ..single.clone() };
    let packets = Packets::OfAnyRays;
    vec![
        ("single rays", single.clone()),
        ("single rays, each triangle tested once", few(1)),
        (
            "single rays, none lost between triangles",
            Question { watertight: true, ..single.clone() },
        ),
        ("packets of any rays", Question { packets, ..single.clone() }),
        ("packets, each triangle tested by 16 rays", Question { packets, ..few(16) }),
        ("packets of rays from one point", Question { packets: Packets::FromOnePoint, ..single }),
        ("single rays in double precision", double.clone()),
        ("packets of any rays in double precision", Question { packets, ..double }),
    ]
}

/// The answers for one machine; all rows are its own where there is only one. What no row answers
/// is left out.
pub(super) fn answers(
    results: &Results,
    machine: Option<&str>,
    known: &[KnownVariant],
) -> Vec<Answer> {
    // The report is about the machine that measured: what it has timed, it has.
    let has = |variant: &KnownVariant| KnownVariant { available: true, ..variant.clone() };
    let known: Vec<KnownVariant> = known.iter().map(has).collect();
    let answered = |(need, question): (&str, Question)| {
        let choice = choose(results, machine, &question, &known).ok()?;
        let note = note(&choice, &question, results, machine);
        Some(Answer { note, ..shown(need, &question, &choice) })
    };
    needs().into_iter().filter_map(answered).collect()
}

/// An answer with its variant, figures and cell.
fn shown(need: &str, question: &Question, choice: &Choice<'_>) -> Answer {
    let row = choice.row;
    let interval = |ends: Option<(f64, f64)>| {
        ends.map_or(String::new(), |(low, high)| format!(" {}", between(low, high)))
    };
    let times = row.ns_low.zip(row.ns_high).filter(|(low, _)| *low > 0.0);
    let speeds = times.map(|(low, high)| (1e3 / high, 1e3 / low));
    // A time that is no time, from broken rows, has no speed.
    let time = row.ns_per_test.filter(|time| *time > 0.0);
    let with = |value: f64, ends| format!("{}{}", short_figure(value), interval(ends));
    Answer {
        need: need.to_owned(),
        command: format!("ray_test recommend{}", question.arguments()),
        variant: row.id.clone(),
        note: String::new(),
        time: time.map_or(String::new(), |time| with(time, times)),
        speed: time.map_or(String::new(), |time| with(1e3 / time, speeds)),
        error: choice.error.map_or(String::new(), short_figure),
        runner_up: match &choice.other_kernel {
            Some(other) => behind(other),
            None => "no other kernel that was timed there fits".to_owned(),
        },
        cell: cell_words(row),
        experiment: row.experiment.clone(),
        because: choice.because.clone(),
    }
}

/// The runner-up, and how much slower it is, where that can be told.
fn behind(other: &Behind<'_>) -> String {
    let (low, high) = other.interval;
    let (slower, ends) = (percent(other.share), format!("[{}, {}]", percent(low), percent(high)));
    let words = match (other.is_slower, low > 0.0) {
        (true, _) => format!("{slower} slower {ends}"),
        (false, true) => {
            let floor = percent(other.floor);
            format!("{slower} slower, less than copies of one kernel differ by ({floor})")
        }
        (false, false) => format!("no difference that can be measured {ends}"),
    };
    format!("{}, {words}", other.row.id)
}

/// What the figures do not say: what preparing has to do with the choice, and how the form bears
/// stiff cases where no ray may be lost.
fn note(
    choice: &Choice<'_>,
    question: &Question,
    results: &Results,
    machine: Option<&str>,
) -> String {
    if question.rays_per_triangle.is_some() {
        return "chosen with what preparing costs; the time is that of the test alone".to_owned();
    }
    if !question.watertight {
        return String::new();
    }
    let leaks =
        choice.leaks.map(|(lost, rays)| format!("lost {lost} of {rays} rays at closed meshes"));
    let stiff = super::stiff::words(results, machine, choice.row);
    let parts: Vec<String> = leaks.into_iter().chain(stiff).collect();
    listed(&parts)
}

/// `nearest-random, 32 triangles, 16 rays, order reshuffled`
fn cell_words(row: &Row) -> String {
    let mut parts = vec![row.workload.clone()];
    parts.extend(row.density.map(|density| format!("density {density}")));
    parts.extend(row.triangles.map(|count| format!("{count} triangles")));
    if row.rays != row.triangles {
        parts.extend(row.rays.map(|count| format!("{count} rays")));
    }
    parts.push(format!("order {}", row.order));
    parts.join(", ")
}
