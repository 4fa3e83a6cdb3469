//! What `render` prints.

use serde_json::{Value, json};

use super::failure::Failure;
use super::render::Render;
use super::render_frames::Shown;
use super::show::{Sheet, rounded};
use crate::render::{Frame, Interpolation, Stage, Way};
use crate::stats::{median, sign_interval};

/// What is the same for all kernels.
pub struct Common<'a> {
    /// The arguments.
    pub arguments: &'a Render,
    /// The stage.
    pub stage: &'a Stage,
    /// Seconds to build the structure.
    pub building: f64,
    /// Bytes of the structure.
    pub bytes: usize,
}

/// One row a kernel.
pub fn sheet(common: &Common<'_>, shown: &[&Shown]) -> Sheet {
    let rows: Vec<_> = shown.iter().map(|one| cells(common, one)).collect();
    let columns = rows.first().into_iter().flatten().map(|(name, _)| *name).collect();
    let values =
        |row: Vec<(&'static str, Value)>| row.into_iter().map(|(_, value)| value).collect();
    Sheet { columns, rows: rows.into_iter().map(values).collect() }
}

/// The same to be read: one column a kernel, one line a figure; figures that none has are left out.
pub fn lines(sheet: &Sheet) -> Vec<Vec<String>> {
    let of = |column: usize| sheet.rows.iter().map(move |row| &row[column]);
    let line = |(index, name): (usize, &&'static str)| {
        let values = of(index).map(rounded);
        std::iter::once((*name).to_owned()).chain(values).collect::<Vec<_>>()
    };
    let some = |(index, _): &(usize, &&'static str)| of(*index).any(|value| !value.is_null());
    sheet.columns.iter().enumerate().filter(some).map(line).collect()
}

fn cells(common: &Common<'_>, shown: &Shown) -> Vec<(&'static str, Value)> {
    let arguments = common.arguments;
    let mut cells = vec![
        ("kernel", json!(shown.chosen.word)),
        ("id", json!(shown.chosen.id)),
        ("model", json!(arguments.model)),
        ("triangles", json!(common.stage.triangles.len())),
        ("structure", json!(arguments.structure)),
        ("structure_bytes", json!(common.bytes)),
        ("width", json!(arguments.size[0])),
        ("height", json!(arguments.size[1])),
        ("grid_x", json!(arguments.grid[0])),
        ("grid_y", json!(arguments.grid[1])),
        ("tolerance", json!(arguments.tolerance)),
        ("interpolate", json!(interpolation(arguments.interpolate.value()))),
        ("depth", json!(arguments.depth)),
        ("cast_only", json!(arguments.cast_only)),
    ];
    cells.extend(times(common, shown));
    cells.extend(shown.frame.as_ref().into_iter().flat_map(|frame| counts(frame, &shown.seconds)));
    cells.extend(differences(shown));
    cells
}

fn interpolation(interpolation: Interpolation) -> &'static str {
    match interpolation {
        Interpolation::Bilinear => "bilinear",
        Interpolation::Nearest => "nearest",
    }
}

fn times(common: &Common<'_>, shown: &Shown) -> Vec<(&'static str, Value)> {
    let seconds = &shown.seconds;
    let (middle, interval) = (median(seconds), sign_interval(seconds));
    let extreme = |fold: fn(f64, f64) -> f64| seconds.iter().copied().reduce(fold);
    let without = median(&shown.without_tests);
    let share = middle.zip(without).map(|(all, rest)| (1.0 - rest / all) * 100.0);
    vec![
        ("seconds_to_build", json!(common.building)),
        ("seconds_to_prepare", json!(shown.preparing)),
        ("frames", json!(seconds.len())),
        ("seconds_per_frame", json!(middle)),
        ("seconds_low", json!(interval.map(|interval| interval.low))),
        ("seconds_high", json!(interval.map(|interval| interval.high))),
        ("seconds_min", json!(extreme(f64::min))),
        ("seconds_max", json!(extreme(f64::max))),
        ("frames_per_second", json!(middle.map(|seconds| 1.0 / seconds))),
        ("seconds_without_intersection", json!(without)),
        ("intersection_percent", json!(share)),
    ]
}

fn counts(frame: &Frame, seconds: &[f64]) -> Vec<(&'static str, Value)> {
    let rays = frame.rays;
    let per_second = median(seconds).map(|seconds| rays.all() as f64 / seconds * 1e-6);
    vec![
        ("rays", json!(rays.all())),
        ("rays_primary", json!(rays.primary)),
        ("rays_shadow", json!(rays.shadow)),
        ("rays_reflected", json!(rays.reflected)),
        ("rays_saved", json!(frame.saved())),
        ("tests", json!(frame.triangles_tested)),
        ("tests_per_ray", json!(frame.triangles_tested as f64 / rays.all() as f64)),
        ("mrays_per_s", json!(per_second)),
    ]
}

/// Columns of a kind: rays, those of them that rounding explains, pixels.
fn names(way: Way) -> [&'static str; 3] {
    match way {
        Way::Crack => ["cracks", "cracks_excused", "cracks_pixels"],
        Way::FalseHit => ["false_hits", "false_hits_excused", "false_hits_pixels"],
        Way::WrongTriangle => {
            ["wrong_triangles", "wrong_triangles_excused", "wrong_triangles_pixels"]
        }
        Way::WrongDistance => {
            ["wrong_distances", "wrong_distances_excused", "wrong_distances_pixels"]
        }
        Way::Outline => ["outlines", "outlines_excused", "outlines_pixels"],
        Way::Shadow => ["wrong_shadows", "wrong_shadows_excused", "wrong_shadows_pixels"],
    }
}

fn differences(shown: &Shown) -> Vec<(&'static str, Value)> {
    let known = shown.differences.as_ref();
    let of = |(place, way): (usize, Way)| {
        let count = known.map(|differences| differences.counts[place]);
        let [rays, excused, pixels] = names(way);
        [
            (rays, json!(count.map(|count| count.rays))),
            (excused, json!(count.map(|count| count.excused))),
            (pixels, json!(count.map(|count| count.pixels))),
        ]
    };
    Way::ALL.into_iter().enumerate().flat_map(of).collect()
}

/// The failure where kernels that claim right answers gave wrong ones that rounding does not explain.
pub fn verdict(shown: &[&Shown], width: u32) -> Result<(), Failure> {
    let reason = |one: &&Shown| {
        let (pixel, way) = one.differences.as_ref()?.first_wrong?;
        let (column, row) = (pixel % width as usize, pixel / width as usize);
        let [what, ..] = names(way);
        let id = &one.chosen.id;
        one.chosen
            .claims_exactness
            .then(|| format!("{id}: the first, of {what}, in column {column} of row {row}"))
    };
    let reasons: Vec<String> = shown.iter().filter_map(reason).collect();
    if reasons.is_empty() { Ok(()) } else { Err(Failure::WrongPicture(reasons)) }
}
