//! Structures and pictures as experiments: checked, counted, measured, kept, and what follows.
#![cfg(feature = "cli")]

mod support;

use ray_test::experiment::Outcome;
use ray_test::structure::KINDS;
use ray_test::table::Row;
use support::{Memory, plan, run_all, run_until};

const STRUCTURES: &str = "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
    [workload]\nkind = 'structures'\nscenes = ['soup:40', 'soup:160', 'terrain:5']\n\
    rays = ['primary', 'random']\nwidth = 16\nlist_tests = 20480\nbounded_most = 100\nkernels = ['moller-trumbore']\n\
    structures = ['list', 'box', 'grid', 'octree', 'kd-tree', 'surface', 'compressed', 'wide', 'peer-parry']\n\
    [workload.volumes]\ntriangles = [3, 20]\nradii = [1.0, 3.0]\n\
    [workload.counted]\nscenes = ['icosphere:2']\norders = 3\nlines = 4000\n";

const PICTURES: &str = "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
    [workload]\nkind = 'pictures'\nsize = [24, 16]\nkernels = ['moller1', 'wald']\n\
    [[workload.sets]]\nstructure = 'list'\nscenes = ['icosphere:1']\n\
    [[workload.sets]]\nstructure = 'surface'\nscenes = ['icosphere:1', 'cornell-box']\n\
    sampling = [{ grid = [1, 1], tolerance = 0.0 }, { grid = [4, 4], tolerance = 0.1 }]\n";

fn of<'a>(outcome: &'a Outcome, record: &str) -> Vec<&'a Row> {
    outcome.rows.iter().filter(|row| row.record == record).collect()
}

#[test]
fn structures_find_the_lists_hits_and_tell_what_they_cost() {
    let outcome = run_all(STRUCTURES, 16);
    assert!(outcome.wrong.is_empty(), "{:?}", outcome.wrong);
    let searches = of(&outcome, "search");
    assert!(searches.len() >= 6 * (6 + 1 + 1));
    // A volume around a list is left out of the larger soup.
    let boxes: Vec<_> = searches.iter().filter(|row| row.structure == "box").collect();
    assert_eq!(boxes.len(), 4);
    assert!(boxes.iter().all(|row| row.triangles <= Some(100)));
    let lists: Vec<&&Row> = searches.iter().filter(|row| row.structure == "list").collect();
    assert_eq!(lists.len(), 6);
    for row in &searches {
        if row.status == "skipped" {
            assert!(["wide", "peer-parry"].contains(&row.structure.as_str()), "{}", row.id);
            continue;
        }
        assert_eq!(row.status, "ok", "{} {}", row.id, row.reason);
        assert!(row.ns_per_test.is_some_and(|ns| ns > 0.0) && row.build_ms.is_some());
        assert_eq!(row.inexcusable, Some(0), "{}", row.id);
        if KINDS.iter().any(|kind| kind.id == row.structure) {
            assert_eq!(row.differences, row.excused, "{}", row.id);
            assert!(row.tests_per_ray.is_some() && row.structure_bytes.is_some());
        }
    }
    for list in lists {
        let rays = list.rays.unwrap_or(0);
        let triangles = list.triangles.unwrap_or(0);
        // As many rays as the budget of tests allows, and what has all of them tests no more.
        assert_eq!(rays, (20480 / triangles).min(256), "{}", list.scene);
        assert_eq!(list.tests_per_ray, Some(triangles as f64));
        let same = |row: &&&Row| {
            row.scene == list.scene
                && row.ray_class == list.ray_class
                && row.triangles == list.triangles
        };
        let surface = searches.iter().filter(same).find(|row| row.structure == "surface");
        let surface = surface.expect("a row of the same rays");
        assert_eq!(surface.rays, Some(256));
        assert!(surface.tests_per_ray < list.tests_per_ray);
    }
}

#[test]
fn cells_volumes_orders_and_chances_are_counted() {
    let outcome = run_all(STRUCTURES, 16);
    let searches = of(&outcome, "search");
    for row in searches.iter().filter(|row| row.status == "ok") {
        let has_cells = ["grid", "octree", "kd-tree"].contains(&row.structure.as_str());
        let cells = row.cells_per_ray.unwrap_or(0.0);
        assert_eq!(cells > 0.0, has_cells, "{} {cells}", row.id);
    }
    let orders = of(&outcome, "insertion");
    let volumes: Vec<Option<f64>> = orders.iter().map(|row| row.volumes_per_ray).collect();
    assert_eq!(orders.len(), 3);
    assert!(volumes.iter().all(|one| one.is_some_and(|one| one > 1.0)));
    assert!(volumes[0] != volumes[1] && volumes[1] != volumes[2]);
    assert!(orders.iter().all(|row| row.hits == orders[0].hits && row.ns_per_test.is_none()));
    let [chance] = of(&outcome, "chance")[..] else { panic!("one scene") };
    assert!(chance.chance_pairs.is_some_and(|pairs| pairs > 5));
    // Five standard errors come once in two million pairs.
    assert!(chance.chance_error_max.is_some_and(|error| error > 0.0 && error < 5.0));
}

#[test]
fn volumes_are_timed_alone_and_around_lists() {
    let outcome = run_all(STRUCTURES, 16);
    let bounded = of(&outcome, "bounded");
    let alone = of(&outcome, "volume");
    // Of every cell the list, nothing, and four volumes.
    let emptied = of(&outcome, "emptied");
    assert_eq!((bounded.len(), alone.len(), emptied.len()), (4 * 6, 4 * 4, 4 * 4));
    assert!(emptied.iter().all(|row| row.hits == Some(0)));
    for row in bounded.iter().chain(&alone).chain(&emptied) {
        assert_eq!(row.status, "ok", "{} {}", row.id, row.reason);
        let is_volume = !["list", "nothing"].contains(&row.structure.as_str());
        assert_eq!(row.passed_share.is_some(), is_volume, "{}", row.id);
        let is_foretold = is_volume && row.record == "bounded";
        assert_eq!(row.predicted_ratio.is_some(), is_foretold, "{}", row.id);
    }
    // A ball three times as large: fewer lines meet what is in it.
    let share = |radius: f64, structure: &str| {
        let mut own = bounded.iter().filter(|row| row.structure == structure);
        let found = own.find(|row| row.knob == Some(radius) && row.triangles == Some(20));
        found.and_then(|row| row.passed_share).expect("a volume")
    };
    for structure in ["sphere", "box", "slabs", "sphere-and-box"] {
        assert!(share(3.0, structure) < 0.5 * share(1.0, structure), "{structure}");
    }
}

#[test]
fn growth_is_told_once_a_line() {
    let outcome = run_all(STRUCTURES, 16);
    let growth = of(&outcome, "growth");
    let mut lines: Vec<(&String, &String, &String)> =
        growth.iter().map(|row| (&row.id, &row.scene, &row.ray_class)).collect();
    let count = lines.len();
    lines.sort();
    lines.dedup();
    assert_eq!(lines.len(), count);
    // On a clock that counts its readings a block of one window takes as long as of any other.
    let timed = growth.iter().filter(|row| row.status == "ok");
    assert!(timed.count() >= 4 * 6);
}

#[test]
fn searches_that_were_interrupted_are_gone_on_with() {
    for text in [STRUCTURES, PICTURES] {
        let mut whole = Memory::default();
        let undisturbed = run_until(text, usize::MAX, &mut whole);
        for blocks in [1, 100] {
            let mut memory = Memory::default();
            let interrupted = run_until(text, blocks, &mut memory);
            assert!(interrupted.interrupted && memory.0.len() < whole.0.len(), "{blocks}");
            assert_eq!(memory.0, whole.0[..memory.0.len()], "{blocks}");
            let gone_on = run_until(text, usize::MAX, &mut memory);
            assert_eq!(gone_on.rows.len(), undisturbed.rows.len());
            for (row, wanted) in gone_on.rows.iter().zip(&undisturbed.rows) {
                assert_eq!(row.without_clock(), wanted.without_clock());
            }
            assert!(memory.0.iter().map(|(name, _)| name).eq(whole.0.iter().map(|(name, _)| name)));
        }
    }
}

#[test]
fn pictures_are_made_by_every_kernel_and_without_any() {
    let outcome = run_all(PICTURES, 32);
    assert!(outcome.wrong.is_empty(), "{:?}", outcome.wrong);
    let (pictures, recorded) = (of(&outcome, "picture"), of(&outcome, "recorded"));
    assert_eq!((pictures.len(), recorded.len()), (2 * 5, 5));
    for row in &pictures {
        assert_eq!((row.status.as_str(), row.differences), ("ok", row.excused), "{}", row.reason);
        assert!(row.seconds_per_frame.is_some_and(|seconds| seconds > 0.0));
        assert!(row.intersection_percent.is_some() && row.ratio_to_reference.is_some());
        let filled = row.filled_percent.expect("it was made");
        assert_eq!(filled > 0.0, row.variation != "every pixel", "{} {filled}", row.variation);
    }
    // The same picture from the answers of the first kernel, to the bit; another may see the other one
    // of two triangles at their common edge.
    for row in &recorded {
        let same = |other: &&&Row| {
            [&other.structure, &other.scene, &other.variation]
                == [&row.structure, &row.scene, &row.variation]
        };
        for picture in pictures.iter().filter(same).filter(|row| row.kernel == "moller1") {
            assert_eq!(picture.outputs_hash, row.outputs_hash, "{} {}", row.id, row.variation);
        }
    }
    let in_list = |row: &&&Row| row.scene == "icosphere" && row.variation == "every pixel";
    let mut lists = pictures.iter().filter(in_list);
    let list = lists.find(|row| row.structure == "list").expect("a picture in a list");
    assert_eq!(list.tests_per_ray.map(|tests| tests > 60.0), Some(true));
}

#[test]
fn wrong_workloads_are_refused_by_name() {
    let refused = |text: &str, parts: &[&str]| {
        let message = plan(text).map(|_| ()).expect_err("it is wrong");
        for part in parts {
            assert!(message.contains(part), "no '{part}' in: {message}");
        }
    };
    let other = |from: &str, to: &str| {
        let changed = STRUCTURES.replace(from, to);
        assert_ne!(changed, STRUCTURES);
        changed
    };
    refused(&other("soup:160", "soap:160"), &["workload.scenes", "soap:160", "icosphere"]);
    refused(&other("soup:160", "soup:0"), &["workload.scenes", "soup:0", "triangles"]);
    refused(&other("'octree'", "'octopus'"), &["workload.structures", "octopus", "kd-tree"]);
    refused(&other("'moller-trumbore'", "'chirkov'"), &["workload.kernels", "chirkov", "wald"]);
    refused(&other("width = 16", "width = 20"), &["workload.width", "20", "multiples of 16"]);
    refused(&other("list_tests = 20480", "list_tests = 0"), &["workload.list_tests", "0"]);
    refused(&other("'primary', ", "'sideways', "), &["sideways", "primary"]);
    refused(&other("1.0, 3.0", "0.5"), &["workload.volumes.radii", "0.5", "1 to"]);
    refused(&other("[3, 20]", "[0]"), &["workload.volumes.triangles", "0"]);
    refused(&other("orders = 3", "orders = 1"), &["workload.counted.orders", "1", "2 to"]);
    refused(&other("icosphere:2", "sphere"), &["workload.counted.scenes", "sphere"]);
    refused(&other("width", "widths"), &["widths"]);
    let other = |from: &str, to: &str| {
        let changed = PICTURES.replacen(from, to, 1);
        assert_ne!(changed, PICTURES);
        changed
    };
    refused(&other("[24, 16]", "[24, 0]"), &["workload.size", "0", "1 to"]);
    refused(&other("'wald'", "'walt'"), &["workload.kernels", "walt"]);
    refused(&other("'list'", "'lists'"), &["workload.sets.structure", "lists", "surface"]);
    refused(&other("cornell-box", "cornel"), &["workload.sets.scenes", "cornel"]);
    refused(&other("tolerance = 0.1", "tolerance = -1.0"), &["tolerance", "-1", "0 or more"]);
    refused(&other("[4, 4]", "[4, 0]"), &["workload.sets.sampling.grid", "0"]);
    refused(&other("size", "depth = 99\nsize"), &["workload.depth", "99", "0 to 16"]);
}

#[test]
fn peers_are_left_out_of_builds_without_them() {
    let outcome = run_all(STRUCTURES, 16);
    let peers: Vec<&Row> =
        outcome.rows.iter().filter(|row| row.structure == "peer-parry").collect();
    assert!(!peers.is_empty());
    for row in peers.iter().filter(|row| row.record == "search") {
        if cfg!(feature = "peers") {
            assert_eq!((row.status.as_str(), row.differences), ("ok", None));
            assert_eq!((row.false_misses, row.false_hits), (Some(0), Some(0)), "{}", row.scene);
        } else {
            assert_eq!(row.status, "skipped");
            assert!(row.reason.contains("peers"), "{}", row.reason);
        }
    }
}
