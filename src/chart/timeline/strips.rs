//! The three strips of the timeline, each with its words above it, and the seconds below them.

use super::windows::Window;
use crate::chart::axis::Axis;
use crate::chart::canvas::{Anchor, Type};
use crate::chart::frame::{Frame, SMALL};
use crate::chart::palette::{DIFFERS, FAINT, GREY, INK, LEADER, style};
use plotters::style::RGBColor;

/// Of the strips.
pub(super) const WIDTH: f64 = 960.0;
/// Percent beyond which nothing is drawn: half as slow again says as much as ten times.
pub(super) const LIMIT: f64 = 30.0;
/// Heights of the strips and of the words above each.
const TIMES: f64 = 170.0;
const SHARES: f64 = 54.0;
const WORDS: f64 = 30.0;
const TICKS: usize = 6;
/// How much of the ground the band covers.
const BAND: f64 = 0.28;

/// Where the strips are.
pub(super) struct Area {
    /// Left end of the strips.
    pub left: f64,
    /// Above the words of the first.
    pub top: f64,
    /// Seconds.
    pub x: Axis,
}

impl Area {
    /// The place of a moment.
    pub fn across(&self, at_s: f64) -> f64 {
        self.left + WIDTH * self.x.place(at_s)
    }

    /// Lower end of the last strip.
    pub fn bottom(&self) -> f64 {
        self.top + 3.0 * WORDS + TIMES + 2.0 * SHARES
    }
}

/// A strip: where its values lie.
struct Strip<'a> {
    area: &'a Area,
    top: f64,
    height: f64,
    y: Axis,
}

impl Strip<'_> {
    fn down(&self, value: f64) -> f64 {
        self.top + self.height * (1.0 - self.y.place(value))
    }

    /// Its words above it, its grid, and a stronger line at 0.
    fn ground(&self, frame: &mut Frame, words: &str, ticks: &[(f64, String)]) {
        let (left, right) = (self.area.left, self.area.left + WIDTH);
        for (value, words) in ticks {
            let y = self.down(*value);
            let colour = if *value == 0.0 { LEADER } else { FAINT };
            frame.canvas.line(&[(left, y), (right, y)], colour, 1.0);
            let style = Type::new(SMALL, GREY).at(Anchor::End);
            frame.canvas.text((left - 8.0, y), words, style);
        }
        let at = (left, self.top - WORDS / 2.0 + 1.0);
        frame.canvas.value(at, words, Type::new(SMALL, INK).bold());
    }
}

/// Draws them; gives where the figure may go on.
pub(super) fn strips(frame: &mut Frame, windows: &[Window], area: &Area) -> f64 {
    times(frame, windows, area);
    let of = |count: fn(&Window) -> usize| {
        let (all, some) = windows
            .iter()
            .fold((0, 0), |(all, some), window| (all + window.rounds, some + count(window)));
        100.0 * some as f64 / all.max(1) as f64
    };
    let dirty: fn(&Window) -> usize = |window| window.dirty;
    let crowded: fn(&Window) -> usize = |window| window.crowded;
    let first = area.top + 2.0 * WORDS + TIMES;
    let words = format!("Rounds thrown away, % of each window ({:.1} % of all)", of(dirty));
    shares(frame, windows, &share_strip(area, first), &words, (DIFFERS, dirty));
    let words = format!(
        "Rounds with a neighbour on the core, % of each window ({:.1} % of all)",
        of(crowded)
    );
    let (neighbour, _) = style(3);
    let second = first + SHARES + WORDS;
    shares(frame, windows, &share_strip(area, second), &words, (neighbour, crowded));
    seconds(frame, area)
}

fn share_strip(area: &Area, top: f64) -> Strip<'_> {
    Strip { area, top, height: SHARES, y: Axis::exact(&[0.0, 100.0]) }
}

/// Median and middle half of the reference's times.
fn times(frame: &mut Frame, windows: &[Window], area: &Area) {
    let shown = |percent: f64| percent.clamp(-LIMIT, LIMIT);
    let all = windows.iter().filter_map(|window| window.quartiles).flatten().map(shown);
    // A machine that kept still to a tenth of a percent is drawn flat, not blown up.
    let y = Axis::fitted(&all.chain([-1.0, 1.0]).collect::<Vec<_>>(), TICKS);
    let ticks = y.ticks(TICKS);
    let strip = Strip { area, top: area.top + WORDS, height: TIMES, y };
    let words = "Reference's time against its usual one, %: line = median of a window, band = middle half of its rounds";
    strip.ground(frame, words, &ticks);
    let (colour, _) = style(0);
    let drawn = || windows.iter().filter_map(|window| Some((window, window.quartiles?.map(shown))));
    for (window, [low, _, high]) in drawn() {
        let (left, right) = (area.across(window.from), area.across(window.to));
        let (low, high) = (strip.down(low), strip.down(high));
        let corners = [(left, low), (right, low), (right, high), (left, high)];
        frame.canvas.area(&corners, colour, BAND);
    }
    for (window, [_, middle, _]) in drawn() {
        let y = strip.down(middle);
        let ends = [(area.across(window.from), y), (area.across(window.to), y)];
        frame.canvas.line(&ends, colour, 2.2);
    }
}

/// A bar a window: which share of its rounds it is.
fn shares(
    frame: &mut Frame,
    windows: &[Window],
    strip: &Strip<'_>,
    words: &str,
    (colour, count): (RGBColor, fn(&Window) -> usize),
) {
    let ticks = [0.0, 50.0, 100.0].map(|percent| (percent, format!("{percent}")));
    strip.ground(frame, words, &ticks);
    for window in windows.iter().filter(|window| count(window) > 0) {
        let share = 100.0 * count(window) as f64 / window.rounds as f64;
        let (left, right) = (strip.area.across(window.from), strip.area.across(window.to));
        frame.canvas.bar((left, strip.down(share)), (right, strip.down(0.0)), colour);
    }
}

fn seconds(frame: &mut Frame, area: &Area) -> f64 {
    let (style, bottom) = (Type::new(SMALL, GREY), area.bottom());
    for (value, words) in area.x.ticks_within(WIDTH, SMALL) {
        let x = area.across(value);
        frame.canvas.line(&[(x, bottom + 2.0), (x, bottom + 6.0)], LEADER, 1.0);
        frame.canvas.text((x, bottom + 17.0), &words, style.at(Anchor::Middle));
    }
    let words = "seconds since the run began; upright lines: where an experiment begins";
    frame.canvas.text((area.left, bottom + 36.0), words, style);
    bottom + 44.0
}
