//! Fields of colour with a number in each: which series fails where.

use super::canvas::{Anchor, Type};
use super::figure::Figure;
use super::frame::{Frame, MARGIN, SMALL, title};
use super::palette::{GREY, INK, PAPER};
use super::select::{self, Point, Selection};
use super::{ChartError, text};
use crate::table::Row;
use plotters::style::RGBColor;

const FIELD: (f64, f64) = (62.0, 20.0);
const HEAD: f64 = 11.0;
const APART: f64 = 8.0;

/// From 0 to 1: dark to light by one hue and then another, so that it reads in grey and to
/// people with colour-blindness (after the scale "YlOrBr" of Brewer 2003).
const COLOURS: [RGBColor; 6] = [
    RGBColor(102, 37, 6),
    RGBColor(204, 76, 2),
    RGBColor(254, 153, 41),
    RGBColor(254, 217, 142),
    RGBColor(255, 247, 219),
    RGBColor(255, 255, 255),
];

/// Draws the figure.
pub(super) fn draw(figure: &Figure, rows: &[Row]) -> Result<String, ChartError> {
    let selection = Selection::new(figure, rows)?;
    let shares = selection.points(figure, &figure.y)?;
    let shown = shown(figure, &selection, &shares)?;
    let columns = select::distinct(&shares, |point| &point.x);
    let (series, gaps) = ordered(figure, &shares, columns.len());
    let names = series.iter().map(|name| text::width(&figure.label(name), SMALL, false));
    let left = MARGIN + names.fold(0.0, f64::max) + 12.0;
    let width = left + columns.len() as f64 * FIELD.0 + MARGIN;
    let mut frame = Frame::new(figure, width.max(560.0));
    let mut top = heads(&mut frame, figure, &columns, left);
    for name in &series {
        frame.canvas.text(
            (left - 8.0, top + FIELD.1 / 2.0),
            &figure.label(name),
            named(figure, name),
        );
        for (place, column) in columns.iter().enumerate() {
            let is_here = |point: &&Point| point.series == *name && point.x == *column;
            let at = (left + place as f64 * FIELD.0, top);
            if let Some(share) = shares.iter().find(is_here) {
                let words = shown.iter().find(is_here).map(|point| text::figure_short(point.y));
                field(&mut frame, at, share.y, words.as_deref().unwrap_or("–"));
            }
        }
        top += FIELD.1;
        if figure.apart.as_ref() == Some(name) {
            top += APART;
        }
    }
    top = key(&mut frame, figure, left, top + 16.0);
    let mut notes = vec![selection.source(), "– never".to_owned()];
    if gaps > 0 {
        notes.push(format!("with values in less than half of the columns, not drawn: {gaps}"));
    }
    let described = described(figure, &shares, &series);
    frame.close(figure, top, &notes, &described)
}

/// The numbers in the fields.
pub(super) fn shown(
    figure: &Figure,
    selection: &Selection<'_>,
    shares: &[Point],
) -> Result<Vec<Point>, ChartError> {
    let Some(column) = &figure.shown else { return Ok(shares.to_vec()) };
    match selection.points(figure, column) {
        Err(ChartError::Nothing(_)) => Ok(Vec::new()),
        other => other,
    }
}

fn named(figure: &Figure, name: &String) -> Type {
    let style = Type::new(SMALL, INK).at(Anchor::End);
    if figure.apart.as_ref() == Some(name) { style.bold() } else { style }
}

/// The series that stands apart, then the others, the best (the largest mean) first; and how many
/// are left out: a line of gaps says nothing beside the others.
pub(super) fn ordered(figure: &Figure, shares: &[Point], columns: usize) -> (Vec<String>, usize) {
    let mut series = select::distinct(shares, |point| &point.series);
    let all = series.len();
    let fields = |name: &String| shares.iter().filter(|point| point.series == *name).count();
    series.retain(|name| 2 * fields(name) >= columns);
    let gaps = all - series.len();
    let mean = |name: &String| {
        let mine = shares.iter().filter(|point| point.series == *name).map(|point| point.y);
        let (sum, count) = mine.fold((0.0, 0.0), |(sum, count), y| (sum + y, count + 1.0));
        sum / count
    };
    let apart = |name: &String| figure.apart.as_ref() != Some(name);
    series.sort_by(|a, b| apart(a).cmp(&apart(b)).then(mean(b).total_cmp(&mean(a))));
    (series, gaps)
}

/// The columns' names, broken at hyphens; returns where the fields begin.
fn heads(frame: &mut Frame, figure: &Figure, columns: &[String], left: f64) -> f64 {
    let lines = |column: &String| -> Vec<String> {
        figure.label(column).split('-').map(str::to_owned).collect()
    };
    let most = columns.iter().map(|column| lines(column).len()).max().unwrap_or(1);
    let bottom = frame.top + HEAD * 1.3 * most as f64;
    for (place, column) in columns.iter().enumerate() {
        let lines = lines(column);
        let middle = left + (place as f64 + 0.5) * FIELD.0;
        for (line, words) in lines.iter().enumerate() {
            let up = (lines.len() - line) as f64 - 0.5;
            let at = (middle, bottom - HEAD * 1.3 * up);
            frame.canvas.text(at, words, Type::new(HEAD, INK).at(Anchor::Middle));
        }
    }
    bottom + 5.0
}

fn field(frame: &mut Frame, at: (f64, f64), share: f64, words: &str) {
    let colour = colour(share);
    let gap = 0.75;
    let corners = ((at.0 + gap, at.1 + gap), (at.0 + FIELD.0 - gap, at.1 + FIELD.1 - gap));
    frame.canvas.bar(corners.0, corners.1, colour);
    let middle = (at.0 + FIELD.0 / 2.0, at.1 + FIELD.1 / 2.0);
    let ink = if share >= 1.0 { GREY } else { readable(colour) };
    frame.canvas.text(middle, words, Type::new(SMALL, ink).at(Anchor::Middle));
}

/// Black or white, whichever stands out (ITU-R BT.601 luma).
fn readable(ground: RGBColor) -> RGBColor {
    let RGBColor(r, g, b) = ground;
    let luma = 0.299 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b);
    if luma < 140.0 { PAPER } else { INK }
}

fn colour(share: f64) -> RGBColor {
    let place = share.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let low = (place.floor() as usize).min(COLOURS.len() - 2);
    let part = place - low as f64;
    let mix = |a: u8, b: u8| (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as u8;
    let (RGBColor(r, g, b), RGBColor(s, h, c)) = (COLOURS[low], COLOURS[low + 1]);
    RGBColor(mix(r, s), mix(g, h), mix(b, c))
}

/// What the colours mean; returns where that ends.
fn key(frame: &mut Frame, figure: &Figure, left: f64, top: f64) -> f64 {
    const STEPS: usize = 20;
    const WIDTH: f64 = 200.0;
    for step in 0..STEPS {
        let share = step as f64 / STEPS as f64;
        let at = left + WIDTH * share;
        frame.canvas.bar((at, top), (at + WIDTH / STEPS as f64, top + 10.0), colour(share));
    }
    let words = figure.y_title.clone().unwrap_or_else(|| title(&figure.y));
    frame.canvas.text((left, top + 20.0), &words, Type::new(HEAD, GREY));
    top + 30.0
}

fn described(figure: &Figure, shares: &[Point], series: &[String]) -> String {
    let never = |name: &&String| {
        shares.iter().filter(|point| point.series == **name).all(|point| point.y >= 1.0)
    };
    let all: Vec<String> = series.iter().filter(never).map(|name| figure.label(name)).collect();
    let all = if all.is_empty() { "none".to_owned() } else { all.join(", ") };
    format!("Table of {} series in colours; without any dark field: {all}.", series.len())
}
