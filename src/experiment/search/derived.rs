//! What follows from the times of all sizes of a scene: how they grow, and from which size on a structure
//! pays.

use crate::table::Row;

/// Fewest triangles of a size that tells the growth: below, what a search costs by itself shows.
const LEAST: u64 = 64;
/// Rays of a picture of 320 x 240 pixels, for which building has to pay.
const PICTURE: f64 = 76_800.0;
/// The structure that others have to pay against.
const LIST: &str = "list";

/// One size of a scene: triangles, time of a ray in ns, time of building in ns.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Size {
    triangles: f64,
    ns: f64,
    build_ns: f64,
}

impl Size {
    fn of(row: &Row) -> Option<Self> {
        let build_ns = row.build_ms? * 1e6;
        Some(Size { triangles: row.triangles? as f64, ns: row.ns_per_test?, build_ns })
    }

    fn searching(self) -> f64 {
        self.ns
    }

    fn with_building(self) -> f64 {
        self.build_ns + PICTURE * self.ns
    }
}

/// A row of each search on the sizes of a scene. Rows of searches are told from how many rays on building
/// pays.
pub fn rows(rows: &mut [Row]) -> Vec<Row> {
    put_rays(rows);
    let searches: Vec<&Row> = rows.iter().filter(|row| row.record == "search").collect();
    let mut found: Vec<Row> = Vec::new();
    for row in &searches {
        let mut line = of_line(row);
        if found.iter().any(|other| same_line(other, &line)) {
            continue;
        }
        let sizes = sizes(&searches, |other| same_line(other, row));
        let of_list = |other: &Row| other.structure == LIST && same_rays(other, row);
        let list = list_sizes(&searches, of_list);
        line.growth = growth(&sizes);
        if row.structure != LIST {
            line.pays_triangles = crossing(&sizes, &list, Size::searching);
            line.pays_triangles_built = crossing(&sizes, &list, Size::with_building);
        }
        line.status = if sizes.is_empty() { "not-measured" } else { "ok" }.into();
        found.push(line);
    }
    found
}

fn same_line(one: &Row, other: &Row) -> bool {
    one.id == other.id && same_rays(one, other)
}

fn same_rays(one: &Row, other: &Row) -> bool {
    one.scene == other.scene && one.ray_class == other.ray_class
}

/// The columns of a search that are the same for all sizes.
fn of_line(row: &Row) -> Row {
    Row {
        experiment: row.experiment.clone(),
        id: row.id.clone(),
        kernel: row.kernel.clone(),
        precision: row.precision.clone(),
        drive: row.drive.clone(),
        level: row.level.clone(),
        structure: row.structure.clone(),
        scene: row.scene.clone(),
        ray_class: row.ray_class.clone(),
        workload: row.workload.clone(),
        order: row.order.clone(),
        query: row.query.clone(),
        seed: row.seed,
        build: row.build.clone(),
        record: "growth".into(),
        ..Row::default()
    }
}

fn sizes(searches: &[&Row], belongs: impl Fn(&Row) -> bool) -> Vec<Size> {
    let own = searches.iter().filter(|row| belongs(row));
    let mut sizes: Vec<Size> = own.filter_map(|row| Size::of(row)).collect();
    sizes.sort_by(|one, other| one.triangles.total_cmp(&other.triangles));
    sizes
}

/// Those of the first list: of several kernels, the first one's.
fn list_sizes(searches: &[&Row], belongs: impl Fn(&Row) -> bool) -> Vec<Size> {
    let first = searches.iter().find(|row| belongs(row)).map(|row| &row.id);
    sizes(searches, |row| belongs(row) && first == Some(&row.id))
}

/// Slope of the straight line of least squares through the logarithms of time and number.
fn growth(sizes: &[Size]) -> Option<f64> {
    let wanted = sizes.iter().filter(|size| size.triangles >= LEAST as f64);
    let points: Vec<[f64; 2]> = wanted.map(|size| [size.triangles.ln(), size.ns.ln()]).collect();
    if points.len() < 2 {
        return None;
    }
    let mean = |axis: usize| points.iter().map(|one| one[axis]).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(0), mean(1));
    let sum = |f: &dyn Fn(&[f64; 2]) -> f64| points.iter().map(f).sum::<f64>();
    let square = sum(&|one| (one[0] - x).powi(2));
    let slope = sum(&|one| (one[0] - x) * (one[1] - y)) / square;
    slope.is_finite().then_some(slope)
}

/// The number of triangles from which on `cost` is below the list's at every size, between two sizes as if
/// both were powers of the number.
fn crossing(own: &[Size], list: &[Size], cost: fn(Size) -> f64) -> Option<f64> {
    let over = |size: &Size| {
        let same = list.iter().find(|other| other.triangles == size.triangles)?;
        Some((size.triangles.ln(), (cost(*size) / cost(*same)).ln()))
    };
    let over: Vec<(f64, f64)> = own.iter().filter_map(over).collect();
    let paying = over.iter().rev().take_while(|(_, ratio)| *ratio < 0.0).count();
    let first = over.len() - paying;
    let (at, ratio) = *over.get(first)?;
    let Some((before, ratio_before)) = first.checked_sub(1).map(|place| over[place]) else {
        return Some(at.exp());
    };
    Some((before + (at - before) * ratio_before / (ratio_before - ratio)).exp())
}

/// From how many rays on a structure's building is paid for, by the list's time.
fn put_rays(rows: &mut [Row]) {
    let lists: Vec<Row> = rows.iter().filter(|row| row.structure == LIST).cloned().collect();
    for row in rows.iter_mut().filter(|row| row.record == "search" && row.structure != LIST) {
        let same = |other: &&Row| same_rays(other, row) && other.triangles == row.triangles;
        let list = lists.iter().find(|other| other.record == "search" && same(other));
        let (Some(own), Some(list)) = (Size::of(row), list.and_then(Size::of)) else { continue };
        let gain = list.ns - own.ns;
        row.build_pays_rays = (gain > 0.0).then(|| (own.build_ns - list.build_ns).max(0.0) / gain);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(structure: &str, triangles: u64, ns: f64, build_ms: f64) -> Row {
        Row {
            record: "search".into(),
            id: structure.into(),
            structure: structure.into(),
            scene: "soup".into(),
            ray_class: "random".into(),
            triangles: Some(triangles),
            ns_per_test: Some(ns),
            build_ms: Some(build_ms),
            ..Row::default()
        }
    }

    #[test]
    fn growth_and_crossings_are_those_of_the_powers() {
        let mut all = Vec::new();
        for triangles in [10u64, 100, 1000, 10_000] {
            let count = triangles as f64;
            all.push(row("list", triangles, 2.0 * count, 0.0));
            all.push(row("root", triangles, 20.0 * count.sqrt(), 0.0));
            all.push(row("slow", triangles, 3.0 * count, 0.0));
            // Building takes as long as n ns for every ray of a picture.
            all.push(row("built", triangles, 1.0, count * PICTURE * 1e-6));
        }
        let derived = rows(&mut all);
        let of = |name: &str| derived.iter().find(|row| row.structure == name).expect("a line");
        assert!((of("list").growth.expect("three sizes") - 1.0).abs() < 1e-12);
        assert!((of("root").growth.expect("three sizes") - 0.5).abs() < 1e-12);
        // 2 n = 20 n^(1/2) at n = 100, a measured size that does not pay yet.
        let root = of("root").pays_triangles.expect("it pays");
        assert!((root - 100.0).abs() < 1e-9, "{root}");
        assert_eq!((of("slow").pays_triangles, of("list").pays_triangles), (None, None));
        // It pays at the smallest size already.
        assert!((of("built").pays_triangles.expect("it pays") - 10.0).abs() < 1e-9);
        // Building takes n ns a ray of a picture and searching 1: below 2 n from the first size on.
        assert!((of("built").pays_triangles_built.expect("it pays") - 10.0).abs() < 1e-9);
        // Building n R ns is paid for by 2 n - 1 ns a ray.
        let built = all.iter().find(|row| row.structure == "built").expect("a row");
        let rays = built.build_pays_rays.expect("it pays");
        assert!((rays - 10.0 * PICTURE / 19.0).abs() < 1e-6 * rays);
        assert!(
            all.iter().filter(|row| row.structure == "slow").all(|r| r.build_pays_rays.is_none())
        );
    }

    #[test]
    fn a_structure_that_pays_in_between_only_does_not_pay_from_there_on() {
        let mut all = vec![
            row("list", 10, 10.0, 0.0),
            row("list", 100, 100.0, 0.0),
            row("list", 1000, 1000.0, 0.0),
            row("dip", 10, 20.0, 0.0),
            row("dip", 100, 50.0, 0.0),
            row("dip", 1000, 2000.0, 0.0),
        ];
        let derived = rows(&mut all);
        assert_eq!(derived.iter().map(|row| row.pays_triangles).collect::<Vec<_>>(), [None, None]);
    }
}
