//! What is read, and what of it is dropped.

use super::*;
use crate::scene::mesh::Dropped;

#[test]
fn every_format_holds_the_same_mesh() {
    let expected = TRIANGLES.map(|t| t.map(|corner| Vec3::from(VERTICES[corner as usize])));
    for (file, bytes) in files() {
        let mesh = read(file, bytes).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(places(&mesh), expected, "{file}");
        assert_eq!((mesh.vertices.len(), mesh.name.as_str()), (4, file));
        assert_eq!(mesh.dropped, Dropped::default(), "{file}");
    }
}

#[test]
fn a_byte_order_mark_takes_no_vertex_away() {
    let text = obj_text();
    let text = &text[text.find("v ").expect("a vertex")..];
    let mesh = read("a.obj", format!("\u{feff}{text}").into_bytes()).expect("a mesh");
    let plain = read("a.obj", text.into()).expect("a mesh");
    assert_eq!((mesh.vertices.len(), places(&mesh)), (4, places(&plain)));
}

#[test]
fn the_content_tells_the_format_where_the_ending_does_not() {
    for (file, bytes) in files() {
        for other in ["model", "model.dat", "model.obj"] {
            let mesh = read(other, bytes.clone());
            assert_eq!(mesh.map(|mesh| mesh.triangles.len()).ok(), Some(4), "{file} as {other}");
        }
    }
}

#[test]
fn names_of_solids_do_not_matter() {
    // A binary file whose name begins as a text does, and texts of one word or several.
    assert_eq!(read("a.stl", stl_binary("solid a")).map(|m| m.triangles.len()).ok(), Some(4));
    for name in ["", " ", " a b", " \u{e9}"] {
        let mesh = read("a.stl", stl_text(name).into_bytes()).expect("a mesh");
        assert_eq!(mesh.triangles.len(), 4, "{name}");
    }
    let two = stl_text(" a") + "\n\n" + &stl_text(" b");
    let mesh = read("a.stl", two.into_bytes()).expect("a mesh");
    assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (4, 8));
}

#[test]
fn polygons_are_cut_into_fans() {
    let obj = "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\nf -5 -4 -3 -2\nf 1 2\n";
    let mesh = read("a.obj", obj.into()).expect("a mesh");
    let expected = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 1, 2], [0, 2, 3]];
    assert_eq!(mesh.triangles, expected);
    assert_eq!((mesh.dropped.polygons, mesh.dropped.faces), (2, 1));
    let header = ply_header("ascii").replace("vertex 4", "vertex 5").replace("face 4", "face 3");
    let ply = header + "0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n4 0 1 2 3\n2 0 1\n";
    let other = read("a.ply", ply.into()).expect("a mesh");
    assert_eq!((other.triangles, other.dropped), (mesh.triangles, mesh.dropped));
}

#[test]
fn coordinates_are_rounded_once_and_counted() {
    // 2^24 + 1 is halfway between two f32 numbers and goes to the even one; 0.5 and 1 are exact.
    let obj = "v 16777217 0.5 0\nv 1 0 0\nv 0 1 0\nv 9 9 0.1\nf 1 2 3\n";
    let mesh = read("a.obj", obj.into()).expect("a mesh");
    assert_eq!(mesh.vertices[0], Vec3::new(16_777_216.0, 0.5, 0.0));
    // The fourth vertex is not used.
    let dropped = mesh.dropped;
    assert_eq!((dropped.vertices, dropped.coordinates_rounded), (1, 1));
    assert_eq!(dropped.largest_rounding, 1.0);
    let double = ply_text().replace("float x", "double x").replace("1 0 0\n", "16777217 0 0\n");
    let mesh = read("a.ply", double.into()).expect("a mesh");
    assert_eq!(mesh.dropped.coordinates_rounded, 1);
    let stl = stl_text("").replace("vertex 1 0 0", "vertex 16777217 0 0");
    let mesh = read("a.stl", stl.into()).expect("a mesh");
    // Three triangles have that corner.
    assert_eq!((mesh.dropped.coordinates_rounded, mesh.dropped.largest_rounding), (3, 1.0));
}

#[test]
fn the_extras_of_files_do_not_disturb() {
    let obj = "\u{feff}\r\nv 2 4 6 2\r\nv 1 0 0 .5 .5 .5 # red\r\nv 0 1 0\r\nvn nonsense\r\n\
               g \u{e9}\r\ns off\r\nf 1 \\\r\n2 3\r\nl 1 2\r\n";
    let mesh = read("a.obj", obj.into()).expect("a mesh");
    assert_eq!(mesh.vertices[0], Vec3::new(1.0, 2.0, 3.0));
    assert_eq!(mesh.triangles, [[0, 1, 2]]);
    let latin = b"# caf\xe9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    assert_eq!(read("a.obj", latin.to_vec()).map(|m| m.triangles.len()).ok(), Some(1));
    let extra = ply_text()
        .replace("element face", "property uchar red\nelement face")
        .replace("vertex_indices\n", "vertex_index\nelement edge 1\nproperty int vertex1\n")
        .replace("0 0 0\n", "0 0 0 1\n")
        .replace("1 0 0\n", "1 0 0 1\n")
        .replace("0 1 0\n", "0 1 0 1\n")
        .replace("0 0 0.5\n", "0 0 0.5 1\n");
    assert_eq!(read("a.ply", (extra + "7\n").into()).map(|m| m.triangles.len()).ok(), Some(4));
}

#[test]
fn files_are_read_from_the_disk() {
    let name = format!("ray_test-scene-{}.obj", std::process::id());
    let path = std::env::temp_dir().join(name);
    std::fs::write(&path, obj_text()).expect("the folder for temporary files can be written");
    let mesh = crate::scene::mesh::load(path.to_str().expect("a plain name"));
    std::fs::remove_file(&path).expect("it was written");
    assert_eq!(mesh.map(|mesh| mesh.triangles.len()).ok(), Some(4));
}
