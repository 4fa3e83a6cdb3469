//! Pictures and their figures.

use super::support::{Folder, said};

#[test]
fn a_picture_is_written_and_comes_again_bit_by_bit() {
    let folder = Folder::new("again");
    let row = &folder.rows(&["icosphere:1", "--size", "24x18"], 0)[0];
    assert_eq!((&row["triangles"], &row["rays_primary"]), (&80.into(), &(24 * 18).into()));
    assert_eq!((&row["frames"], &row["rays_saved"]), (&1.into(), &0.into()));
    for positive in ["seconds_per_frame", "seconds_without_intersection", "tests_per_ray"] {
        assert!(row[positive].as_f64().is_some_and(|number| number > 0.0), "{positive}");
    }
    assert!(row["intersection_percent"].as_f64().is_some_and(|share| share < 100.0));
    assert!(row["seconds_low"].is_null() && row["cracks"].is_null());
    let first = folder.read("out.png");
    assert!(first.starts_with(b"\x89PNG\r\n\x1a\n"));
    folder.rows(&["icosphere:1", "--size", "24x18", "-o", "again.png", "--frames", "2"], 0);
    assert_eq!(folder.read("again.png"), first);
    assert_eq!(folder.names(), ["again.png", "out.png"]);
}

#[test]
fn structures_and_grids_without_tolerance_change_no_picture_and_save_what_they_should() {
    let folder = Folder::new("same");
    let of = |words: &[&str]| folder.rows(&[&["soup:60", "--size", "32x24"], words].concat(), 0);
    let full = of(&["-o", "full.png", "--structure", "list"]);
    let grid = of(&["-o", "grid.png", "--grid", "5x7", "--tolerance", "0"]);
    assert_eq!(folder.read("full.png"), folder.read("grid.png"));
    // Every ray meets every triangle of a list, unless a shadow ray is stopped before.
    assert!(full[0]["tests"].as_u64() > grid[0]["tests"].as_u64());
    let coarse = of(&["--grid", "8x8", "--tolerance", "1", "--cast-only"]);
    assert!(coarse[0]["rays_saved"].as_u64() > Some(0), "{}", coarse[0]);
    assert_eq!((&coarse[0]["rays_shadow"], &coarse[0]["rays_reflected"]), (&0.into(), &0.into()));
}

#[test]
fn several_kernels_have_a_row_each_and_frames_enough_have_an_interval() {
    let folder = Folder::new("several");
    let words = ["icosphere:0", "--size", "8x8", "--frames", "6"];
    let kernels = ["moller1", "badouel", "chirkov-line", "chirkov"];
    let list = kernels.join(",");
    let rows = folder.rows(&[&words[..], &["--kernel", &list]].concat(), 0);
    let names: Vec<&str> = rows.iter().filter_map(|row| row["kernel"].as_str()).collect();
    assert_eq!(names, kernels);
    for row in &rows {
        assert_eq!(row["rays"], rows[0]["rays"]);
        let of = |name: &str| row[name].as_f64().expect("six frames have all of them");
        let [low, high] = [of("seconds_low"), of("seconds_high")];
        assert!(of("seconds_min") <= low && low <= of("seconds_per_frame"));
        assert!(of("seconds_per_frame") <= high && high <= of("seconds_max"));
    }
}

#[test]
fn text_has_a_line_a_figure_and_csv_a_column() {
    let folder = Folder::new("formats");
    let words = ["icosphere:0", "--size", "4x4"];
    let text = folder.render(&words);
    let stdout = String::from_utf8_lossy(&text.stdout).into_owned();
    assert!(
        stdout.lines().any(|line| line.trim_start().starts_with("frames_per_second")),
        "{stdout}"
    );
    assert!(!stdout.contains("cracks"), "{stdout}");
    assert!(said(&text).contains("4 x 4 pixels"), "{}", said(&text));
    let csv = folder.render(&[&words[..], &["--format", "csv"]].concat());
    let stdout = String::from_utf8_lossy(&csv.stdout).into_owned();
    assert_eq!(stdout.lines().count(), 2);
    assert!(stdout.starts_with("kernel,id,model,triangles,"), "{stdout}");
}
