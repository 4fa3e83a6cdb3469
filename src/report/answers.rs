//! Which kernel to take on this machine: the fastest of the rows that may be compared.
//!
//! Only rows of one cell are compared: the same experiment, workload, order, density and sizes,
//! and the same outputs.

use super::words::percent;
use crate::chart::short_figure;
use crate::results::Results;
use crate::table::Row;

/// A question that the top of the report answers.
struct Need {
    words: &'static str,
    precision: &'static str,
    rays: Rays,
    /// Whether only triangles as they are will do.
    plain: bool,
}

/// What the rays of a packet have in common.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Rays {
    Single,
    Packet,
    CommonOrigin,
}

const NEEDS: [Need; 7] = [
    Need::new("single rays", "f32", Rays::Single),
    Need { plain: true, ..Need::new("single rays, nothing prepared", "f32", Rays::Single) },
    Need::new("packets of any rays", "f32", Rays::Packet),
    Need { plain: true, ..Need::new("packets of any rays, nothing prepared", "f32", Rays::Packet) },
    Need::new("packets of rays from one point", "f32", Rays::CommonOrigin),
    Need::new("single rays in double precision", "f64", Rays::Single),
    Need::new("packets of any rays in double precision", "f64", Rays::Packet),
];

/// An answer in words; empty where there is none.
#[derive(Clone, Debug, Default)]
pub(super) struct Answer {
    pub need: String,
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
}

/// The answers for one machine; all rows are its own where there is only one.
pub(super) fn answers(results: &Results, machine: Option<&str>) -> Vec<Answer> {
    let is_here = |row: &&Row| machine.is_none_or(|machine| row.machine == machine);
    let rows: Vec<&Row> = results.rows().filter(is_here).collect();
    let mut answers: Vec<Answer> = NEEDS.iter().filter_map(|need| answered(need, &rows)).collect();
    answers.extend(super::robust::answer(&rows));
    answers
}

fn answered(need: &Need, rows: &[&Row]) -> Option<Answer> {
    let candidates = rows.iter().copied().filter(|row| need.admits(row));
    let cell = best_cell(&candidates.collect::<Vec<_>>())?;
    let best = fastest(cell.iter().copied())?;
    let others = cell.iter().copied().filter(|row| row.kernel != best.kernel);
    let runner_up = fastest(others).map_or(String::new(), |other| behind(best, other));
    Some(Answer { need: need.words.to_owned(), runner_up, ..picked(best, rows) })
}

impl Need {
    const fn new(words: &'static str, precision: &'static str, rays: Rays) -> Self {
        Need { words, precision, rays, plain: false }
    }

    fn admits(&self, row: &Row) -> bool {
        let number = |drive: &str| drive.chars().all(|c| c.is_ascii_digit());
        let rays = match row.drive.strip_prefix("packet") {
            None if row.drive.starts_with("single") => Some(Rays::Single),
            Some(rest) if number(rest) => Some(Rays::Packet),
            Some(rest) if rest.ends_with("-common-origin") => Some(Rays::CommonOrigin),
            _ => None,
        };
        rays == Some(self.rays)
            && row.precision == self.precision
            && (!self.plain || row.stored == "vertices")
            && serves(row)
    }
}

/// Whether a row is a time of a form that serves any scene: whole answers, of both faces, with all
/// boundary hits and without estimates or a known axis.
fn serves(row: &Row) -> bool {
    row.status == "ok"
        && row.ns_per_test.is_some_and(|time| time > 0.0)
        && row.output == "tuv"
        && row.cull != "on"
        && row.tests_form != "sign-bits"
        && ["", "divide"].contains(&row.reciprocal.as_str())
        && !["fixed", "batches"].contains(&row.projection.as_str())
}

/// An answer that has its variant, figures and cell.
pub(super) fn picked(row: &Row, rows: &[&Row]) -> Answer {
    let interval = |ends: Option<(f64, f64)>| {
        ends.map_or(String::new(), |(low, high)| format!(" {}", super::words::between(low, high)))
    };
    let times = row.ns_low.zip(row.ns_high).filter(|(low, _)| *low > 0.0);
    let time = row.ns_per_test.unwrap_or_default();
    let speeds = times.map(|(low, high)| (1e3 / high, 1e3 / low));
    Answer {
        variant: row.id.clone(),
        time: format!("{}{}", short_figure(time), interval(times)),
        speed: format!("{}{}", short_figure(1e3 / time), interval(speeds)),
        error: error_of(row, rows).map_or(String::new(), short_figure),
        cell: cell_words(row),
        experiment: row.experiment.clone(),
        ..Answer::default()
    }
}

/// The runner-up, how much slower it is, and whether the intervals tell the two apart.
pub(super) fn behind(best: &Row, other: &Row) -> String {
    let ratio = other.ns_per_test.zip(best.ns_per_test).map(|(other, best)| other / best - 1.0);
    let slower = ratio.map_or(String::new(), |slower| format!(", {} slower", percent(slower)));
    let overlap = other.ns_low.zip(best.ns_high).is_some_and(|(low, high)| low <= high);
    let overlap = if overlap { " (the intervals overlap)" } else { "" };
    format!("{}{slower}{overlap}", other.id)
}

/// The fastest; of equals the first by its id.
pub(super) fn fastest<'a>(rows: impl Iterator<Item = &'a Row>) -> Option<&'a Row> {
    let time = |row: &Row| row.ns_per_test.unwrap_or(f64::INFINITY);
    rows.min_by(|a, b| time(a).total_cmp(&time(b)).then(a.id.cmp(&b.id)))
}

/// A cell: rows of one experiment that may be compared.
struct Cell<'a> {
    /// What is worked on, in which order: the same in several experiments.
    work: [String; 8],
    experiment: &'a str,
    rows: Vec<&'a Row>,
}

impl Cell<'_> {
    fn kernels(&self) -> usize {
        kernels(self.rows.iter().copied())
    }

    fn best(&self) -> f64 {
        fastest(self.rows.iter().copied()).and_then(|row| row.ns_per_test).unwrap_or(f64::INFINITY)
    }
}

fn kernels<'a>(rows: impl Iterator<Item = &'a Row>) -> usize {
    let mut kernels: Vec<&str> = rows.map(|row| row.kernel.as_str()).collect();
    kernels.sort_unstable();
    kernels.dedup();
    kernels.len()
}

fn cells<'a>(rows: &[&'a Row]) -> Vec<Cell<'a>> {
    let mut cells: Vec<Cell<'a>> = Vec::new();
    for row in rows {
        let text = |column: &str| row.cell(column).map_or(String::new(), |cell| cell.to_string());
        let columns = [
            "workload",
            "order",
            "density",
            "triangles",
            "rays",
            "query",
            "spread",
            "workload_hash",
        ];
        let work = columns.map(text);
        let same = |cell: &&mut Cell| cell.work == work && cell.experiment == row.experiment;
        match cells.iter_mut().find(same) {
            Some(cell) => cell.rows.push(row),
            None => cells.push(Cell { work, experiment: &row.experiment, rows: vec![row] }),
        }
    }
    cells
}

/// The cell to take the answer from. First the work is chosen: the nearest hit before pairs,
/// `reshuffled` before `fixed`, then that on which most kernels were put to. Of the experiments on
/// it that compare three kernels or more, the one with the fastest row is taken.
pub(super) fn best_cell<'a>(rows: &[&'a Row]) -> Option<Vec<&'a Row>> {
    const FAIR: usize = 3;
    let cells = cells(rows);
    let worth = |cell: &Cell| {
        let orders = ["literal", "fixed", "reshuffled"];
        let order = orders.iter().position(|order| *order == cell.work[1]);
        let same = cells.iter().filter(|other| other.work == cell.work);
        let kernels = kernels(same.flat_map(|other| other.rows.iter().copied()));
        (cell.work[0].starts_with("nearest"), order, kernels)
    };
    let most = cells.iter().map(worth).max()?;
    // Of several that are equal, the first.
    let work = &cells.iter().find(|cell| worth(cell) == most)?.work;
    let on_it = || cells.iter().filter(|cell| cell.work == *work);
    let fair = on_it().map(Cell::kernels).max().unwrap_or(0).min(FAIR);
    let fair = on_it().filter(|cell| cell.kernels() >= fair);
    let best = fair.min_by(|a, b| a.best().total_cmp(&b.best()))?;
    Some(best.rows.clone())
}

/// `h-double: nearest-random, 32 triangles, 16 rays, order reshuffled`
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

/// The error of the same arithmetic on random hits: of the same id, else, where the rounding is
/// `plain`, of the same kernel, division and record in any drive and on any level, since those
/// give the same bits.
pub(super) fn error_of(row: &Row, rows: &[&Row]) -> Option<f64> {
    let arithmetic = |row: &Row| {
        let axes = [&row.kernel, &row.precision, &row.division, &row.rounding, &row.stored];
        (axes.map(String::clone), row.tests_form.clone(), row.reciprocal.clone())
    };
    let is_random = |other: &&&Row| {
        other.workload == "errors-random" && other.err_against != "moller-trumbore-f64"
    };
    let same = |other: &&&Row| {
        other.id == row.id || (row.rounding == "plain" && arithmetic(other) == arithmetic(row))
    };
    let mut errors: Vec<&Row> = rows.iter().filter(is_random).filter(same).copied().collect();
    errors.sort_by_key(|other| (other.id != row.id, std::cmp::Reverse(other.err_cases)));
    errors.iter().find_map(|other| other.err_b_p99).or(row.err_b_p99)
}
