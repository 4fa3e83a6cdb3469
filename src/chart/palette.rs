//! Colours and marker shapes of the series. A series has both, so that colour is never the only code.

use plotters::style::RGBColor;
use std::f64::consts::PI;

/// Text and axes.
pub(super) const INK: RGBColor = RGBColor(34, 34, 34);
/// Subtitles, tick labels, footers.
pub(super) const GREY: RGBColor = RGBColor(96, 96, 96);
/// Grid lines.
pub(super) const FAINT: RGBColor = RGBColor(226, 226, 226);
/// Leaders from a line's end to its label.
pub(super) const LEADER: RGBColor = RGBColor(176, 176, 176);
/// Page ground.
pub(super) const PAPER: RGBColor = RGBColor(255, 255, 255);
/// "The same" in a comparison with published figures.
pub(super) const AGREES: RGBColor = RGBColor(0, 124, 92);
/// "Not the same".
pub(super) const DIFFERS: RGBColor = RGBColor(196, 78, 0);

/// Okabe and Ito 2008, which people with colour-blindness tell apart; their yellow is too faint for
/// a line on white and is replaced by a grey.
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
    RGBColor(128, 128, 128),
];

/// Seven shapes to eight colours: the pair repeats only after 56 series.
const SHAPES: [Shape; 7] = [
    Shape::Circle,
    Shape::Square,
    Shape::Up,
    Shape::Diamond,
    Shape::Down,
    Shape::Hexagon,
    Shape::Star,
];

/// Form of a marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    Circle,
    Square,
    Up,
    Diamond,
    Down,
    Hexagon,
    Star,
}

impl Shape {
    /// Corners around `centre`. Radii differ a little so that the shapes look equally large.
    pub fn corners(self, centre: (f64, f64), radius: f64) -> Vec<(f64, f64)> {
        let (count, turn, size) = match self {
            Shape::Circle => (24, 0.0, 1.0),
            Shape::Square => (4, PI / 4.0, 1.22),
            Shape::Up => (3, -PI / 2.0, 1.35),
            Shape::Diamond => (4, 0.0, 1.3),
            Shape::Down => (3, PI / 2.0, 1.35),
            Shape::Hexagon => (6, 0.0, 1.12),
            Shape::Star => (10, -PI / 2.0, 1.45),
        };
        let corner = |index: usize| {
            let inner = if self == Shape::Star && index % 2 == 1 { 0.45 } else { 1.0 };
            let angle = turn + 2.0 * PI * index as f64 / count as f64;
            let distance = radius * size * inner;
            (centre.0 + distance * angle.cos(), centre.1 + distance * angle.sin())
        };
        (0..count).map(corner).collect()
    }
}

/// How the series of that number looks.
pub(super) fn style(series: usize) -> (RGBColor, Shape) {
    (COLOURS[series % COLOURS.len()], SHAPES[series % SHAPES.len()])
}
