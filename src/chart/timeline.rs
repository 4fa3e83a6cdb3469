//! Every round of a run in the order of time: was the machine quiet?

use super::axis::Axis;
use super::canvas::{Anchor, Type};
use super::figure::Kind;
use super::frame::{self, Frame, MARGIN, SMALL};
use super::palette::{AGREES, DIFFERS, FAINT, GREY, INK, LEADER, Shape};
use super::stability::blank;
use super::{ChartError, text};
use crate::stats::median;
use crate::table::Round;
use plotters::style::RGBColor;
use std::collections::BTreeMap;

const PLOT: (f64, f64) = (960.0, 260.0);
/// Of the plot's width, so that a run of any length makes a picture of the same size.
const COLUMNS: usize = 240;
const TICKS: usize = 6;
/// Times beyond stand at the edge: one round of three times the length says as much as one of ten.
const LIMITS: (f64, f64) = (0.8, 1.5);
/// Lines of experiments' names above the plot.
const NAME_LINES: usize = 5;
const NAME_HEIGHT: f64 = 14.0;

/// The states, with how they are drawn and what they mean.
const STATES: [(&str, RGBColor, Shape, &str); 3] = [
    ("clean", AGREES, Shape::Circle, "nothing was seen beside it"),
    ("crowded", INK, Shape::Diamond, "a neighbour on the core"),
    ("dirty", DIFFERS, Shape::Up, "dropped: something else ran in between"),
];

/// Draws the rounds of a run: the reference's time over its median in the same group, over the
/// seconds since the run began. Rounds of a narrow piece of time and one state are one mark, from the
/// shortest to the longest. Without rounds the picture says so.
///
/// # Errors
/// When the drawing itself fails.
pub fn timeline(rounds: &[Round]) -> Result<String, ChartError> {
    let question = "Was the machine quiet while this was measured?".to_owned();
    let mut figure = blank("timeline".to_owned(), Kind::Lines, question);
    let placed = placed(rounds);
    if placed.is_empty() {
        return frame::placeholder(&figure, "no round of a group with a reference was taken down");
    }
    figure.subtitle = timeline_words(rounds);
    let left = MARGIN + 44.0;
    let mut frame = Frame::new(&figure, left + PLOT.0 + MARGIN);
    key(&mut frame, rounds);
    let seconds: Vec<f64> = placed.iter().map(|one| one.round.at_s).collect();
    let x = Axis::exact(&seconds.iter().copied().chain([0.0]).collect::<Vec<_>>());
    let y =
        Axis::fitted(&placed.iter().map(|one| one.shown()).chain([1.0]).collect::<Vec<_>>(), TICKS);
    let area = Area { left, top: frame.top, x, y };
    let area = Area { top: names(&mut frame, &placed, &area), ..area };
    axes(&mut frame, &area);
    marks(&mut frame, &placed, &area);
    let beyond = placed.iter().filter(|one| one.ratio != one.shown()).count();
    let mut notes = vec![format!("n = {} rounds", placed.len())];
    if beyond > 0 {
        notes.push(format!("{beyond} below {} or above {} stand at the edge", LIMITS.0, LIMITS.1));
    }
    let description = "Time of the reference over its median in its group, over seconds.";
    frame.close(&figure, area.top + PLOT.1 + 44.0, &notes, description)
}

/// A round with a place in the picture.
struct Placed<'a> {
    round: &'a Round,
    /// The reference's time over its median in the group.
    ratio: f64,
}

impl Placed<'_> {
    fn shown(&self) -> f64 {
        self.ratio.clamp(LIMITS.0, LIMITS.1)
    }
}

/// The median is that of the clean rounds, where there are any.
fn placed(rounds: &[Round]) -> Vec<Placed<'_>> {
    let mut times: BTreeMap<(&str, &str), [Vec<f64>; 2]> = BTreeMap::new();
    for round in rounds {
        let of_cell = times.entry((&round.experiment, &round.cell)).or_default();
        let is_clean = usize::from(round.state == "clean");
        of_cell[is_clean].extend(round.reference_ns_per_test);
    }
    let typical: BTreeMap<(&str, &str), f64> = times
        .into_iter()
        .filter_map(|(cell, [others, clean])| Some((cell, median(&clean).or(median(&others))?)))
        .collect();
    let place = |round: &'_ Round| -> Option<f64> {
        let typical = typical.get(&(round.experiment.as_str(), round.cell.as_str()))?;
        Some(round.reference_ns_per_test? / typical)
    };
    let placed = rounds.iter().filter_map(|round| Some(Placed { round, ratio: place(round)? }));
    placed.filter(|one| one.ratio.is_finite() && one.round.at_s.is_finite()).collect()
}

fn count(rounds: &[Round], state: &str) -> usize {
    rounds.iter().filter(|round| round.state == state).count()
}

/// What the picture of these rounds shows, in words.
pub fn timeline_words(rounds: &[Round]) -> String {
    let share = |state| 100.0 * count(rounds, state) as f64 / rounds.len() as f64;
    format!(
        "Time of the reference kernel in each round over its median in its group: a machine that is \
         quiet and keeps its speed draws a flat band at 1. Of {} rounds {:.1} % were clean, {:.1} % \
         beside a neighbour, and {:.1} % were disturbed and dropped.",
        rounds.len(),
        share("clean"),
        share("crowded"),
        share("dirty")
    )
}

fn key(frame: &mut Frame, rounds: &[Round]) {
    let (mut x, y) = (MARGIN + 5.0, frame.top);
    for (state, colour, shape, meaning) in STATES {
        let words = format!("{state} ({}): {meaning}", count(rounds, state));
        frame.canvas.marker(shape, (x, y), 4.0, colour);
        frame.canvas.text((x + 10.0, y), &words, Type::new(SMALL, GREY));
        x += 40.0 + text::width(&words, SMALL, false);
    }
    frame.top += 18.0;
}

struct Area {
    left: f64,
    top: f64,
    x: Axis,
    y: Axis,
}

impl Area {
    fn across(&self, at_s: f64) -> f64 {
        self.left + PLOT.0 * self.x.place(at_s)
    }

    fn down(&self, ratio: f64) -> f64 {
        self.top + PLOT.1 * (1.0 - self.y.place(ratio))
    }
}

/// A line where each experiment begins, and its name where there is room; returns where the plot
/// may begin.
fn names(frame: &mut Frame, placed: &[Placed<'_>], area: &Area) -> f64 {
    let top = area.top + NAME_LINES as f64 * NAME_HEIGHT;
    let mut ends = [f64::NEG_INFINITY; NAME_LINES];
    let (mut before, mut named) = ("", Vec::new());
    for one in placed {
        let name = one.round.experiment.as_str();
        if name == before {
            continue;
        }
        before = name;
        let x = area.across(one.round.at_s);
        let end = x + text::width(name, SMALL, false);
        let is_free = |last: &f64| *last + 10.0 < x;
        let line = ends.iter().position(is_free).filter(|_| end < area.left + PLOT.0 + MARGIN);
        let from = line.map_or(top, |line| area.top + line as f64 * NAME_HEIGHT);
        frame.canvas.line(&[(x, from), (x, top + PLOT.1)], FAINT, 1.0);
        if let Some(line) = line {
            ends[line] = end + 3.0;
            named.push(((x + 3.0, from + 6.0), name));
        }
    }
    // Behind the lines of all others, so that none crosses a name.
    for (at, name) in named {
        frame.canvas.value(at, name, Type::new(SMALL, GREY));
    }
    top
}

fn axes(frame: &mut Frame, area: &Area) {
    let style = Type::new(SMALL, GREY);
    let right = area.left + PLOT.0;
    for (value, words) in area.y.ticks(TICKS) {
        let y = area.down(value);
        frame.canvas.line(&[(area.left, y), (right, y)], FAINT, 1.0);
        frame.canvas.text((area.left - 8.0, y), &words, style.at(Anchor::End));
    }
    let one = area.down(1.0);
    frame.canvas.line(&[(area.left, one), (right, one)], LEADER, 1.2);
    let bottom = area.top + PLOT.1;
    for (value, words) in area.x.ticks_within(PLOT.0, SMALL) {
        let x = area.across(value);
        frame.canvas.line(&[(x, bottom + 2.0), (x, bottom + 6.0)], LEADER, 1.0);
        frame.canvas.text((x, bottom + 17.0), &words, style.at(Anchor::Middle));
    }
    let words = "seconds since the run began; upright lines: experiments";
    frame.canvas.text((area.left, bottom + 36.0), words, style);
}

/// One mark a column and state: what is clean first, so that the rest stands before it.
fn marks(frame: &mut Frame, placed: &[Placed<'_>], area: &Area) {
    for (state, colour, shape, _) in STATES {
        let mut columns: BTreeMap<usize, (f64, f64)> = BTreeMap::new();
        for one in placed.iter().filter(|one| one.round.state == state) {
            let column = (area.x.place(one.round.at_s) * (COLUMNS - 1) as f64).round() as usize;
            let (low, high) = columns.entry(column).or_insert((one.shown(), one.shown()));
            (*low, *high) = (low.min(one.shown()), high.max(one.shown()));
        }
        for (column, (low, high)) in columns {
            let x = area.left + PLOT.0 * column as f64 / (COLUMNS - 1) as f64;
            let (low, high) = (area.down(low), area.down(high));
            if state == "clean" {
                // A mark of one round is still to be seen.
                frame.canvas.line(&[(x, low + 0.8), (x, high - 0.8)], colour, 2.0);
            } else {
                frame.canvas.line(&[(x, low), (x, high)], colour, 1.0);
                frame.canvas.marker(shape, (x, high), 2.6, colour);
            }
        }
    }
}
