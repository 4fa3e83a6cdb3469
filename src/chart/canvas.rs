//! What is drawn, collected first and handed to plotters when the height of the picture is known.

use super::palette::{PAPER, Shape};
use super::{ChartError, svg, text};
use plotters::backend::SVGBackend;
use plotters::drawing::IntoDrawingArea;
use plotters::element::{Circle, PathElement, Polygon, Text as PlottersText};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontStyle, IntoFont, RGBColor, ShapeStyle, TextStyle};

/// A place in the picture, in its own units, y downwards.
pub(super) type Place = (f64, f64);

/// Where a text's place is in the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text looks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Type {
    pub size: f64,
    pub bold: bool,
    pub colour: RGBColor,
    pub anchor: Anchor,
}

impl Type {
    /// Regular text that starts at its place.
    pub fn new(size: f64, colour: RGBColor) -> Self {
        Type { size, bold: false, colour, anchor: Anchor::Start }
    }

    /// The same in bold.
    pub fn bold(self) -> Self {
        Type { bold: true, ..self }
    }

    /// The same, anchored elsewhere.
    pub fn at(self, anchor: Anchor) -> Self {
        Type { anchor, ..self }
    }
}

enum Mark {
    Line {
        points: Vec<Place>,
        colour: RGBColor,
        width: f64,
    },
    Area {
        points: Vec<Place>,
        colour: RGBColor,
        opacity: f64,
    },
    /// A circle, filled or, with a width, drawn round.
    Round {
        at: Place,
        radius: f64,
        colour: RGBColor,
        width: Option<f64>,
    },
    Text {
        at: Place,
        text: String,
        style: Type,
    },
}

/// plotters places everything on whole numbers; drawn ten times as large and scaled back, lines that
/// nearly coincide keep their distance.
pub(super) const FINENESS: f64 = 10.0;
const FONTS: &str = "Inter, 'Helvetica Neue', Arial, sans-serif";

/// A list of marks.
#[derive(Default)]
pub(super) struct Canvas {
    marks: Vec<Mark>,
}

impl Canvas {
    /// A line through the points.
    pub fn line(&mut self, points: &[Place], colour: RGBColor, width: f64) {
        self.marks.push(Mark::Line { points: points.to_vec(), colour, width });
    }

    /// A dashed line through the points.
    pub fn dashed(&mut self, points: &[Place], colour: RGBColor, width: f64) {
        const DASH: f64 = 4.0;
        const PERIOD: f64 = 7.0;
        for (from, to) in points.iter().zip(points.iter().skip(1)) {
            let length = (to.0 - from.0).hypot(to.1 - from.1);
            let along = |distance: f64| {
                let part = (distance / length).min(1.0);
                (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1))
            };
            let dashes = (length / PERIOD).ceil() as usize;
            for dash in 0..dashes {
                let start = dash as f64 * PERIOD;
                self.line(&[along(start), along(start + DASH)], colour, width);
            }
        }
    }

    /// A filled polygon.
    pub fn area(&mut self, points: &[Place], colour: RGBColor, opacity: f64) {
        self.marks.push(Mark::Area { points: points.to_vec(), colour, opacity });
    }

    /// A filled rectangle between two corners.
    pub fn bar(&mut self, a: Place, b: Place, colour: RGBColor) {
        self.area(&[a, (b.0, a.1), b, (a.0, b.1)], colour, 1.0);
    }

    /// A marker with a white rim, so that it stays apart from lines beneath it.
    pub fn marker(&mut self, shape: Shape, at: Place, radius: f64, colour: RGBColor) {
        self.filled(shape, at, radius + 0.8, PAPER);
        self.filled(shape, at, radius, colour);
    }

    fn filled(&mut self, shape: Shape, at: Place, radius: f64, colour: RGBColor) {
        match shape {
            Shape::Circle => self.marks.push(Mark::Round { at, radius, colour, width: None }),
            other => self.area(&other.corners(at, radius), colour, 1.0),
        }
    }

    /// A hollow marker: what was published, not measured.
    pub fn hollow(&mut self, shape: Shape, at: Place, radius: f64, colour: RGBColor) {
        const WIDTH: f64 = 1.6;
        self.filled(shape, at, radius, PAPER);
        if shape == Shape::Circle {
            self.marks.push(Mark::Round { at, radius, colour, width: Some(WIDTH) });
            return;
        }
        let mut outline = shape.corners(at, radius);
        outline.extend(outline.first().copied());
        outline.extend(outline.get(1).copied());
        self.line(&outline, colour, WIDTH);
    }

    /// The interval from `low` to `high` with ends across it.
    pub fn whisker(&mut self, low: Place, high: Place, half_end: f64, colour: RGBColor) {
        let upright = (high.0 - low.0).abs() < (high.1 - low.1).abs();
        let (across, down) = if upright { (half_end, 0.0) } else { (0.0, half_end) };
        self.line(&[low, high], colour, 1.1);
        for end in [low, high] {
            self.line(
                &[(end.0 - across, end.1 - down), (end.0 + across, end.1 + down)],
                colour,
                1.1,
            );
        }
    }

    /// A text whose capitals are centred on the height of its place.
    pub fn text(&mut self, at: Place, text: &str, style: Type) {
        self.marks.push(Mark::Text { at, text: text.to_owned(), style });
    }

    /// A text on a piece of ground that covers the grid lines beneath it.
    pub fn value(&mut self, at: Place, text: &str, style: Type) {
        let width = text::width(text, style.size, style.bold);
        let left = match style.anchor {
            Anchor::Start => at.0,
            Anchor::Middle => at.0 - width / 2.0,
            Anchor::End => at.0 - width,
        };
        let half = style.size * 0.55;
        self.bar((left - 1.0, at.1 - half), (left + width + 1.0, at.1 + half), PAPER);
        self.text(at, text, style);
    }

    /// The picture as SVG text of the given size.
    pub fn render(&self, width: f64, height: f64) -> Result<String, ChartError> {
        let mut drawn = String::new();
        let size = ((width * FINENESS).ceil() as u32, (height * FINENESS).ceil() as u32);
        {
            let area = SVGBackend::with_string(&mut drawn, size).into_drawing_area();
            let failed = |error: &dyn std::fmt::Display| ChartError::Drawing(error.to_string());
            area.fill(&PAPER).map_err(|error| failed(&error))?;
            for mark in &self.marks {
                match mark {
                    Mark::Line { points, colour, width } => {
                        let style = colour.stroke_width((width * FINENESS).round() as u32);
                        area.draw(&PathElement::new(fine(points), style))
                    }
                    Mark::Area { points, colour, opacity } => {
                        area.draw(&Polygon::new(fine(points), colour.mix(*opacity).filled()))
                    }
                    Mark::Round { at, radius, colour, width } => {
                        let (at, radius) = (fine_place(*at), (radius * FINENESS).round() as i32);
                        area.draw(&Circle::new(at, radius, round_style(*colour, *width)))
                    }
                    Mark::Text { at, text, style } => {
                        area.draw(&PlottersText::new(text.as_str(), fine_place(*at), font(style)))
                    }
                }
                .map_err(|error| failed(&error))?;
            }
            area.present().map_err(|error| failed(&error))?;
        }
        Ok(svg::scaled(&drawn, FINENESS))
    }
}

fn round_style(colour: RGBColor, width: Option<f64>) -> ShapeStyle {
    match width {
        None => colour.filled(),
        Some(width) => colour.stroke_width((width * FINENESS).round() as u32),
    }
}

fn fine(points: &[Place]) -> Vec<(i32, i32)> {
    points.iter().copied().map(fine_place).collect()
}

fn fine_place(at: Place) -> (i32, i32) {
    ((at.0 * FINENESS).round() as i32, (at.1 * FINENESS).round() as i32)
}

fn font(style: &Type) -> TextStyle<'_> {
    // plotters writes the size divided by 1.24 into the SVG.
    let font = (FONTS, style.size * FINENESS * 1.24).into_font();
    let weight = if style.bold { FontStyle::Bold } else { FontStyle::Normal };
    let across = match style.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    TextStyle::from(font.style(weight)).color(&style.colour).pos(Pos::new(across, VPos::Center))
}
