//! Small files, good and broken.

mod broken;
mod fuzzed;
mod good;
mod large;

use super::{Mesh, read};
use glam::Vec3;

/// A tetrahedron, its triangles counter-clockwise from outside.
const VERTICES: [[f32; 3]; 4] =
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]];
const TRIANGLES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

/// The header of the tetrahedron as PLY.
fn ply_header(format: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\ncomment made here\nelement vertex 4\nproperty float x\n\
         property float y\nproperty float z\nelement face 4\n\
         property list uchar int vertex_indices\nend_header\n"
    )
}

fn ply_text() -> String {
    let mut text = ply_header("ascii");
    for [x, y, z] in VERTICES {
        text += &format!("{x} {y} {z}\n");
    }
    for [a, b, c] in TRIANGLES {
        text += &format!("3 {a} {b} {c}\n");
    }
    text
}

fn ply_binary(big: bool) -> Vec<u8> {
    let mut bytes =
        ply_header(if big { "binary_big_endian" } else { "binary_little_endian" }).into_bytes();
    let word = |bytes: &mut Vec<u8>, bits: u32| {
        bytes.extend(if big { bits.to_be_bytes() } else { bits.to_le_bytes() });
    };
    for x in VERTICES.iter().flatten() {
        word(&mut bytes, x.to_bits());
    }
    for corners in TRIANGLES {
        bytes.push(3);
        corners.iter().for_each(|corner| word(&mut bytes, *corner));
    }
    bytes
}

fn obj_text() -> String {
    let mut text = String::from("# made here\nmtllib none.mtl\no tetrahedron\n");
    for [x, y, z] in VERTICES {
        text += &format!("v {x} {y} {z}\n");
    }
    for [a, b, c] in TRIANGLES.map(|corners| corners.map(|corner| corner + 1)) {
        text += &format!("f {a}/1/9 {b}//7 {c}\n");
    }
    text
}

fn stl_text(name: &str) -> String {
    let mut text = format!("solid{name}\n");
    for corners in TRIANGLES {
        text += " facet normal 0 0 0\n  outer loop\n";
        for [x, y, z] in corners.map(|corner| VERTICES[corner as usize]) {
            text += &format!("   vertex {x} {y} {z}\n");
        }
        text += "  endloop\n endfacet\n";
    }
    text + "endsolid" + name + "\n"
}

fn stl_binary(name: &str) -> Vec<u8> {
    let mut bytes = name.as_bytes().to_vec();
    bytes.resize(80, 0);
    bytes.extend(4u32.to_le_bytes());
    for corners in TRIANGLES {
        bytes.extend([0; 12]);
        for x in corners.iter().flat_map(|corner| VERTICES[*corner as usize]) {
            bytes.extend(x.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// One good file of each kind, with a name whose ending fits.
fn files() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("a.obj", obj_text().into_bytes()),
        ("a.ply", ply_text().into_bytes()),
        ("b.ply", ply_binary(false)),
        ("c.ply", ply_binary(true)),
        ("a.stl", stl_text(" a").into_bytes()),
        ("b.stl", stl_binary("")),
    ]
}

fn refusal(file: &str, bytes: impl Into<Vec<u8>>) -> String {
    read(file, bytes.into()).expect_err("it must be refused").to_string()
}

/// The corners of every triangle.
fn places(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    mesh.list().iter().map(|triangle| [triangle.a, triangle.b, triangle.c]).collect()
}
