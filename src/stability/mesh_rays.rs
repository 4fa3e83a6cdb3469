//! The rows of rays through the edges and vertices of closed meshes.

use super::draw::Draw;
use super::family::{Family, MeshKind, segment_of};
use super::forms::Form;
use super::leaks::Tally;
use super::mesh::Mesh;
use super::rows;
use super::shots::Range;
use super::sweep::Setting;
use crate::table::Row;
use std::sync::atomic::{AtomicBool, Ordering};

/// The rows of one mesh, offset, precision and class of rays: one a form. `None` once cancelled,
/// which is looked at before every ray.
pub fn rows_of(
    family: &Family,
    kind: MeshKind,
    setting: &Setting,
    forms: &[Form],
    cancel: &AtomicBool,
) -> Option<Vec<Row>> {
    let Some(class) = setting.class else { return Some(Vec::new()) };
    let precision = setting.precision;
    let usual = |form: &&Form| form.precision == precision && !form.flushes();
    let forms: Vec<&Form> = forms.iter().filter(usual).collect();
    let mesh = Mesh::new(kind, setting.knob, precision);
    let purpose = format!("{} {}", family.id, class.word());
    let mut draw = Draw::new(setting.seed, &purpose, setting.knob, precision);
    let range = Range::new(&mesh, kind, class, &mut draw);
    let tallies = tallies(&range, &mut draw, &forms, (setting.count, cancel))?;
    let row = |(form, tally): (&&Form, Tally)| {
        let mut row = rows::of_setting(family, setting, form);
        row.ray_class = class.word().into();
        row.triangles = Some(mesh.triangles.len() as u64);
        tally.put(&mut row);
        row
    };
    Some(forms.iter().zip(tallies).map(row).collect())
}

/// What each form did with so many rays; `None` once cancelled.
fn tallies(
    range: &Range<'_>,
    draw: &mut Draw,
    forms: &[&Form],
    (count, cancel): (usize, &AtomicBool),
) -> Option<Vec<Tally>> {
    let mut tallies = vec![Tally::default(); forms.len()];
    for _ in 0..count {
        if cancel.load(Ordering::Relaxed) {
            return None;
        }
        let (query, aim, sees_all) = range.shot(draw);
        let has = |segment: bool| forms.iter().any(|form| form.asked.is_segment == segment);
        for is_segment in [false, true].into_iter().filter(|segment| has(*segment)) {
            let query = if is_segment { segment_of(&query, draw) } else { query };
            let met = range.met(&query, &aim, sees_all);
            for (form, tally) in forms.iter().zip(&mut tallies) {
                if form.asked.is_segment == is_segment && met.is_one {
                    tally.add(range.hits(form.asked.ask, &query, &met));
                }
            }
        }
    }
    Some(tallies)
}
