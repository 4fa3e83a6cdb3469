//! Rays that start where a kernel says that another one hit: do they hit the same triangle again?

use super::draw::{Draw, REACH};
use super::families::find;
use super::family::{Family, Work, segment_of};
use super::forms::Form;
use super::precision::power_of_two;
use super::rows;
use super::sweep::Setting;
use crate::job::Answer;
use crate::oracle::{Query, classify};
use crate::table::Row;
use glam::DVec3;
use std::sync::atomic::{AtomicBool, Ordering};

/// Offsets that are tried: so many powers of two of the unit roundoff, from a quarter on.
const OFFSETS: i32 = 26;
const FIRST_OFFSET: i32 = -2;

/// One case: the ray that hits, and the way of the ray that starts there.
struct Bounce {
    query: Query,
    /// Normal on the side that the first ray comes from.
    normal: DVec3,
    way: DVec3,
}

/// The rows of a setting: one a form. `None` once cancelled, which is looked at before every case
/// that is drawn and before every form.
pub fn rows_of(
    family: &Family,
    setting: &Setting,
    forms: &[Form],
    cancel: &AtomicBool,
) -> Option<Vec<Row>> {
    let mut draw = Draw::new(setting.seed, family.id, setting.knob, setting.precision);
    let bounces = bounces(&mut draw, setting, cancel)?;
    let usual = |form: &&Form| form.precision == setting.precision && !form.flushes();
    let row = |form: &Form| {
        if cancel.load(Ordering::Relaxed) {
            return None;
        }
        let mut row = rows::of_setting(family, setting, form);
        put(&mut row, form, &bounces, &draw);
        Some(row)
    };
    forms.iter().filter(usual).map(row).collect()
}

/// Exact hits of the family `far`, at that distance; `None` once cancelled.
fn bounces(draw: &mut Draw, setting: &Setting, cancel: &AtomicBool) -> Option<Vec<Bounce>> {
    let Some(Work::Aimed(generator)) = find("far").map(|family| family.work) else {
        return Some(Vec::new());
    };
    let mut bounces = Vec::new();
    for _ in 0..setting.count {
        if cancel.load(Ordering::Relaxed) {
            return None;
        }
        let query = generator(draw, setting.knob, true);
        let [a, b, c] = query.triangle.map(DVec3::from_array);
        let normal = (b - a).cross(c - a).normalize();
        let comes_from = -normal.dot(DVec3::from_array(query.direction)).signum();
        let normal = normal * comes_from;
        let way = draw.towards(normal);
        let way = way * way.dot(normal).signum();
        if normal.is_finite() && classify(&query).is_hit() {
            bounces.push(Bounce { query, normal, way });
        }
    }
    Some(bounces)
}

fn put(row: &mut Row, form: &Form, bounces: &[Bounce], draw: &Draw) {
    let (mut spawned, mut again, mut needed) = (0, 0, 0);
    for bounce in bounces {
        let first = posed(form, bounce.query, draw);
        let answer = (form.asked.ask)(&first);
        if answer.triangle.is_none() || !answer.t.is_finite() {
            continue;
        }
        spawned += 1;
        let point = point(&first, &answer, draw);
        let hits = |offset: f64| {
            let from = point + bounce.normal * offset;
            let corners = bounce.query.triangle.map(DVec3::from_array);
            let query = posed(form, draw.ray(from, bounce.way, corners, (0.0, REACH)), draw);
            (form.asked.ask)(&query).triangle.is_some()
        };
        again += u64::from(hits(0.0));
        let rounding = form.precision.unit_roundoff() * largest(&bounce.query);
        let offset = |step: i32| power_of_two(FIRST_OFFSET + step) * rounding;
        let last = (0..OFFSETS).rev().find(|step| hits(offset(*step)));
        // The next step up is the smallest that stopped it.
        needed = needed.max(last.map_or(0, |step| step + 1));
    }
    row.cases = Some(spawned);
    row.spawned_hits = Some(again);
    let is_known = spawned > 0 && needed < OFFSETS;
    row.spawned_offset = is_known.then(|| power_of_two(FIRST_OFFSET + needed));
}

fn posed(form: &Form, query: Query, draw: &Draw) -> Query {
    if form.asked.is_segment { segment_of(&query, draw) } else { query }
}

/// The point of a hit as a renderer computes it: origin plus t times direction, each rounded.
fn point(query: &Query, answer: &Answer, draw: &Draw) -> DVec3 {
    let round = |x: f64| draw.precision.round(x);
    let along = |i: usize| round(answer.t * round(query.direction[i]));
    DVec3::from_array([0, 1, 2].map(|i| round(query.origin[i] + along(i))))
}

/// The largest coordinate of the triangle.
fn largest(query: &Query) -> f64 {
    query.triangle.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()))
}
