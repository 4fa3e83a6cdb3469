//! Pictures that are held against the exact ones.

use super::support::{Folder, said};

/// A tetrahedron of that size.
fn tetrahedron(size: f64) -> String {
    let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let vertex = |corner: &[i32; 3]| {
        let [x, y, z] = corner.map(|one| f64::from(one) * size);
        format!("v {x} {y} {z}\n")
    };
    let vertices: String = corners.iter().map(vertex).collect();
    vertices + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
}

#[test]
fn a_watertight_kernel_has_no_cracks() {
    let folder = Folder::new("watertight");
    let words = ["icosphere:2", "--size", "40x30", "--kernel", "woop-watertight", "--compare"];
    let row = &folder.rows(&words, 0)[0];
    for column in ["cracks", "false_hits", "wrong_distances"] {
        assert_eq!(row[column], 0, "{column}");
    }
    assert_eq!(folder.names(), ["out-compare.png", "out.png"]);
}

#[test]
fn a_kernel_that_loses_small_triangles_is_found_out() {
    let folder = Folder::new("lost");
    folder.write("small.obj", &tetrahedron(1e-4));
    folder.write("large.obj", &tetrahedron(1.0));
    let words = ["--size", "20x20", "--compare", "--kernel", "moller1", "-o", "p.png"];
    let output = folder.render(&[&["small.obj"], &words[..]].concat());
    // Twice the area is 1e-8, below the listing's epsilon for the determinant: nothing is seen.
    assert_eq!(output.status.code(), Some(4), "{}", said(&output));
    assert!(said(&output).contains("moller1/f32/single"), "{}", said(&output));
    let row = &folder.rows(&[&["small.obj"], &words[..]].concat(), 4)[0];
    let cracks = row["cracks_pixels"].as_u64().expect("a number");
    assert!(cracks > 20, "{row}");
    assert_eq!(row["rays"], 400);
    folder.rows(&[&["large.obj"], &words[..]].concat(), 0);
    // Differences of several kernels go to a file each.
    let two =
        ["large.obj", "--size", "4x4", "--compare", "--kernel", "moller1,wald", "-o", "q.png"];
    folder.rows(&two, 0);
    let names = folder.names();
    for name in ["p-compare.png", "q-moller1-compare.png", "q-wald-compare.png"] {
        assert!(names.iter().any(|other| other == name), "{name} in {names:?}");
    }
}
