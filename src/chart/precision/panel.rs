//! One panel of a work-precision chart.

use super::dot::{Dot, Standing, steps};
use super::placing::{FAR, Rectangle, Taken};
use super::{Plan, Times, shape};
use crate::chart::canvas::{Anchor, Place, Type};
use crate::chart::figure::Figure;
use crate::chart::frame::{Frame, SMALL};
use crate::chart::palette::{FAINT, GREY, INK, LEADER, PAPER};
use plotters::style::RGBColor;

/// Points of the front.
pub(super) const FRONT: RGBColor = RGBColor(0, 114, 178);
/// Points behind it.
pub(super) const BEHIND: RGBColor = RGBColor(168, 168, 168);
const WHISKER: RGBColor = RGBColor(120, 170, 205);
const STEPS: RGBColor = RGBColor(166, 206, 227);
const NAME: f64 = 11.5;
const SMALL_NAME: f64 = 9.5;

/// Where the drawing is.
pub(super) struct Area {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
    pub times: Times,
}

impl Area {
    fn at(&self, plan: &Plan, error: f64, time: f64) -> Place {
        (self.across(plan.x.place(error)), self.up(self.times.axis.place(time)))
    }

    fn across(&self, share: f64) -> f64 {
        self.left + share * (self.right - self.left)
    }

    fn up(&self, share: f64) -> f64 {
        self.bottom - share * (self.bottom - self.top)
    }
}

/// Draws a panel and returns the points whose labels found no room.
pub(super) fn drawn<'a>(
    frame: &mut Frame,
    figure: &Figure,
    plan: &'a Plan,
    panel: &str,
    area: &Area,
) -> Vec<&'a Dot> {
    axes(frame, plan, area);
    let in_panel = plan.dots.iter().filter(|dot| dot.panel == panel);
    let dots: Vec<&Dot> =
        in_panel.filter(|dot| !matches!(dot.standing, Standing::Apart(_))).collect();
    let (front, behind): (Vec<&Dot>, Vec<&Dot>) =
        dots.iter().partition(|dot| dot.standing == Standing::Front);
    let mut taken = Taken::new(Rectangle {
        left: area.left + 2.0,
        right: area.right - 2.0,
        top: area.top + 2.0,
        bottom: area.bottom - 2.0,
    });
    joins(frame, plan, area, &dots);
    for precision in &plan.precisions {
        let own: Vec<&Dot> =
            front.iter().copied().filter(|dot| dot.precision == *precision).collect();
        front_steps(frame, plan, area, &own, &mut taken);
    }
    front.iter().for_each(|dot| whiskers(frame, plan, area, dot, &mut taken));
    for (dots, radius, colour) in [(&behind, 3.4, BEHIND), (&front, 4.5, FRONT)] {
        for dot in dots {
            let at = area.at(plan, dot.error, dot.time);
            frame.canvas.marker(shape(plan, &dot.precision), at, radius, colour);
            taken.keep_off(Rectangle::around(at, 5.5, 5.5));
        }
    }
    taken.keep_off(better(frame, area));
    names(frame, figure, plan, area, (&front, &behind), &mut taken)
}

fn axes(frame: &mut Frame, plan: &Plan, area: &Area) {
    let style = Type::new(SMALL, GREY);
    for (value, words) in &area.times.ticks {
        let y = area.up(area.times.axis.place(*value));
        frame.canvas.line(&[(area.left, y), (area.right, y)], FAINT, 1.0);
        frame.canvas.text((area.left - 8.0, y), words, style.at(Anchor::End));
    }
    for (share, words) in plan.x.ticks(area.right - area.left, SMALL) {
        let x = area.across(share);
        frame.canvas.line(&[(x, area.top), (x, area.bottom + 4.0)], FAINT, 1.0);
        frame.canvas.text((x, area.bottom + 15.0), &words, style.at(Anchor::Middle));
    }
    for (from, to) in plan.x.pieces() {
        let ends = [(area.across(from), area.bottom), (area.across(to), area.bottom)];
        frame.canvas.line(&ends, LEADER, 1.0);
    }
    for cut in plan.x.cuts() {
        let x = area.across(cut);
        let ground = [(x - 10.0, area.top), (x + 10.0, area.bottom + 1.0)];
        frame.canvas.bar(ground[0], ground[1], PAPER);
        for side in [-4.0, 4.0] {
            let x = x + side;
            frame.canvas.line(
                &[(x - 3.0, area.bottom + 6.0), (x + 3.0, area.bottom - 6.0)],
                GREY,
                1.2,
            );
        }
    }
}

/// Lines between the points of one name.
fn joins(frame: &mut Frame, plan: &Plan, area: &Area, dots: &[&Dot]) {
    for (index, dot) in dots.iter().enumerate() {
        let next = dots[index + 1..].iter().find(|other| other.name == dot.name);
        if let Some(other) = next {
            let ends = [dot, other].map(|dot| area.at(plan, dot.error, dot.time));
            frame.canvas.line(&ends, FAINT, 1.0);
        }
    }
}

/// From the fastest point to the most exact one. Between two of them the time of the slower one
/// must be paid for any error below that of the faster one.
fn front_steps(frame: &mut Frame, plan: &Plan, area: &Area, front: &[&Dot], taken: &mut Taken) {
    let corners = steps(front);
    let mut line: Vec<Place> = Vec::new();
    for (error, time) in corners {
        let at = area.at(plan, error, time);
        if let Some(before) = line.last().copied() {
            line.push((before.0, at.1));
        }
        line.push(at);
    }
    frame.canvas.line(&line, STEPS, 2.2);
    line.windows(2).for_each(|ends| taken.keep_off_line(ends[0], ends[1]));
}

fn whiskers(frame: &mut Frame, plan: &Plan, area: &Area, dot: &Dot, taken: &mut Taken) {
    let upright = [dot.times.0, dot.times.1].map(|time| area.at(plan, dot.error, time));
    let level = [dot.errors.0, dot.errors.1].map(|error| area.at(plan, error, dot.time));
    for [low, high] in [upright, level] {
        if low != high {
            frame.canvas.whisker(low, high, 3.0, WHISKER);
            taken.keep_off_line(low, high);
        }
    }
}

/// Says which way is better, and what that takes.
fn better(frame: &mut Frame, area: &Area) -> Rectangle {
    let tip = (area.left + 12.0, area.bottom - 12.0);
    let tail = (tip.0 + 26.0, tip.1 - 26.0);
    frame.canvas.line(&[tail, tip], GREY, 1.4);
    frame.canvas.line(&[(tip.0, tip.1 - 9.0), tip, (tip.0 + 9.0, tip.1)], GREY, 1.4);
    frame.canvas.text((tail.0 + 5.0, tail.1), "better", Type::new(SMALL, GREY));
    Rectangle { left: tip.0 - 4.0, right: tail.0 + 52.0, top: tail.1 - 9.0, bottom: tip.1 + 4.0 }
}

/// Labels: those of the front first, where they find the best places.
fn names<'a>(
    frame: &mut Frame,
    figure: &Figure,
    plan: &Plan,
    area: &Area,
    (front, behind): (&[&'a Dot], &[&'a Dot]),
    taken: &mut Taken,
) -> Vec<&'a Dot> {
    let mut unnamed = Vec::new();
    let styles = [Type::new(NAME, INK).bold(), Type::new(SMALL_NAME, GREY)];
    for (dots, style) in [front, behind].into_iter().zip(styles) {
        let mut order: Vec<&&Dot> = dots.iter().collect();
        order.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.name.cmp(&b.name)));
        for dot in order {
            let point = area.at(plan, dot.error, dot.time);
            let words = figure.label(&dot.name);
            match taken.place(point, &words, style.size, style.bold) {
                None => unnamed.push(*dot),
                Some((middle, distance)) => {
                    if distance > FAR {
                        frame.canvas.line(&[point, middle], LEADER, 0.7);
                    }
                    frame.canvas.value(middle, &words, style.at(Anchor::Middle));
                }
            }
        }
    }
    unnamed
}
