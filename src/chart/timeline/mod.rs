//! Every round of a run in the order of time: did the machine keep still?
//!
//! Three strips over the same seconds: how far the reference was from its usual time, how many rounds
//! were thrown away, and how many had a neighbour on the core.

mod strips;
mod windows;

use super::axis::Axis;
use super::canvas::Type;
use super::figure::{Figure, Kind};
use super::frame::{self, Frame, MARGIN, SMALL};
use super::palette::{FAINT, GREY};
use super::stability::blank;
use super::{ChartError, text};
use crate::stats::median;
use crate::table::Round;
use strips::{Area, LIMIT, WIDTH, strips};
use windows::{Placed, Window, placed, windows};

/// What the picture answers.
pub const TIMELINE_QUESTION: &str = "Did the machine keep still while this was measured?";
/// Lines of experiments' names above the plot.
const NAME_LINES: usize = 5;
const NAME_HEIGHT: f64 = 14.0;

/// Draws the rounds of a run in narrow windows of time. In each, the reference's times are held
/// against their median in the same group: the line is the window's median, the band the middle half
/// of its rounds, dropped ones left out; how many were dropped, and how many had a neighbour, stands
/// below. `bare` leaves question and sentence to the page. Without rounds the picture says so.
///
/// # Errors
/// When the drawing itself fails.
pub fn timeline(rounds: &[Round], bare: bool) -> Result<String, ChartError> {
    let figure = blank("timeline".to_owned(), Kind::Lines, TIMELINE_QUESTION.to_owned());
    let mut figure = Figure { bare, ..figure };
    let placed = placed(rounds);
    let windows = windows(&placed);
    if windows.is_empty() {
        return frame::placeholder(&figure, "no round of a group with a reference was taken down");
    }
    figure.subtitle = timeline_words(rounds);
    let left = MARGIN + 44.0;
    let mut frame = Frame::new(&figure, left + WIDTH + MARGIN);
    let ends = windows.iter().flat_map(|window| [window.from, window.to]);
    let x = Axis::exact(&ends.chain([0.0]).collect::<Vec<_>>());
    let mut area = Area { left, top: frame.top, x };
    let starts = starts(&placed, &area);
    let first = area.top;
    area.top += starts.iter().filter_map(|start| start.line).max().map_or(0.0, below);
    for start in &starts {
        let from = start.line.map_or(area.top, |line| first + below(line) - NAME_HEIGHT);
        frame.canvas.line(&[(start.x, from), (start.x, area.bottom())], FAINT, 1.0);
    }
    let bottom = strips(&mut frame, &windows, &area);
    // Behind all lines, so that none crosses a name.
    for start in &starts {
        if let Some(line) = start.line {
            let at = (start.x + 3.0, first + below(line) - NAME_HEIGHT + 6.0);
            frame.canvas.value(at, start.name, Type::new(SMALL, GREY));
        }
    }
    let description = "Time of the reference against its median in its group, rounds thrown away, \
                       and rounds with a neighbour, over seconds.";
    frame.close(&figure, bottom, &notes(&placed, &windows), description)
}

/// What stands below the picture.
fn notes(placed: &[Placed<'_>], windows: &[Window]) -> Vec<String> {
    let length = windows.first().map_or(0.0, |window| window.to - window.from);
    let seconds = super::short_figure(length);
    let mut notes =
        vec![format!("n = {} rounds", placed.len()), format!("a window is {seconds} s")];
    let is_beyond = |window: &&Window| {
        window.quartiles.is_some_and(|all| all.iter().any(|percent| percent.abs() > LIMIT))
    };
    let beyond = windows.iter().filter(is_beyond).count();
    if beyond > 0 {
        let plural = if beyond == 1 { "window reaches" } else { "windows reach" };
        notes.push(format!("{beyond} {plural} beyond {LIMIT} %, cut off there"));
    }
    notes
}

/// What the picture of these rounds shows, in words.
pub fn timeline_words(rounds: &[Round]) -> String {
    let placed = placed(rounds);
    let windows = windows(&placed);
    let off = windows.iter().filter_map(|window| Some(window.quartiles?[1].abs()));
    let off: Vec<f64> = off.collect();
    let farthest = off.iter().copied().fold(0.0, f64::max);
    let still = median(&off).map_or(String::new(), |half| {
        format!(
            "In half of the windows the median time of the reference kernel lay within {half:.1} % of its \
             usual time, at worst {farthest:.1} % off; a machine that keeps still draws a flat line at 0. "
        )
    });
    let share = |state| {
        let count = placed.iter().filter(|one| one.round.state == state).count();
        100.0 * count as f64 / placed.len().max(1) as f64
    };
    format!(
        "{still}Of {} rounds {:.1} % were thrown away, because something else ran in between, and \
         {:.1} % had a neighbour on the core.",
        placed.len(),
        share("dirty"),
        share("crowded")
    )
}

/// Where an experiment begins.
struct Start<'a> {
    name: &'a str,
    x: f64,
    /// The line of names that has room for this one.
    line: Option<usize>,
}

/// Lower end of a line of names, from the top of the first.
fn below(line: usize) -> f64 {
    (line + 1) as f64 * NAME_HEIGHT
}

/// Where the experiments begin, and which of their names have room.
fn starts<'a>(placed: &[Placed<'a>], area: &Area) -> Vec<Start<'a>> {
    let mut ends = [f64::NEG_INFINITY; NAME_LINES];
    let start = |of_one: &[Placed<'a>]| {
        let name = of_one[0].round.experiment.as_str();
        let x = area.across(of_one[0].round.at_s);
        let end = x + text::width(name, SMALL, false);
        let has_room = end < area.left + WIDTH + MARGIN;
        let line = ends.iter().position(|last| *last + 10.0 < x).filter(|_| has_room);
        if let Some(line) = line {
            ends[line] = end + 3.0;
        }
        Start { name, x, line }
    };
    placed
        .chunk_by(|one, other| one.round.experiment == other.round.experiment)
        .map(start)
        .collect()
}
