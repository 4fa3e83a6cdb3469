//! Where rows stand in the whole sweep, whichever shard they are of.

use super::family::Family;
use super::forms::Form;
use super::precision::Precision;
use super::shots::RayClass;
use crate::table::Row;

/// A number for each row, which grows in the order of [`Sweep::run`](super::Sweep::run): settings
/// by family, precision, knob and class of rays, then knees by family and precision, then leaks;
/// within each by form. `forms` are those of all shards.
pub fn places(families: &[Family], forms: &[Form], rows: &[Row]) -> Vec<u64> {
    let ids: Vec<String> = forms.iter().map(|form| form.asked.id()).collect();
    let place = |row: &Row| {
        // The row of the inputs, which has no form, stands before those of the forms.
        let form = ids.iter().position(|id| *id == row.id).map_or(0, |place| place + 1);
        let family = families.iter().position(|family| family.id == row.family).unwrap_or(0);
        let precision = Precision::ALL.iter().position(|one| one.name() == row.precision);
        let precision = precision.unwrap_or(0);
        let knob = families
            .get(family)
            .map_or_else(Vec::new, |family| (family.knobs)(Precision::ALL[precision]));
        let knob = knob.iter().position(|knob| Some(*knob) == row.knob).unwrap_or(0);
        let class = RayClass::ALL.iter().position(|class| class.word() == row.ray_class);
        let class = class.unwrap_or(0);
        match row.record.as_str() {
            "leaks" => number([2, 0, 0, 0, 0, form]),
            "knee" => number([1, family, precision, 0, 0, form]),
            _ => number([0, family, precision, knob, class, form]),
        }
    };
    rows.iter().map(place).collect()
}

/// Indices, the first of which counts most, as one number. Each has so many bits that no sweep
/// needs more, and all together fewer than a JSON number keeps (53).
fn number(indices: [usize; 6]) -> u64 {
    const BITS: [u32; 6] = [2, 10, 1, 10, 3, 16];
    indices.iter().zip(BITS).fold(0, |number, (index, bits)| number << bits | *index as u64)
}
