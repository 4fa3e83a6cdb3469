//! Meshes, and what is built around them.

use ray_test::scene::look::Looks;
use ray_test::scene::mesh::read;
use ray_test::scene::rays::view;
use ray_test::structure::KINDS;

/// Wavefront's text.
pub fn obj(bytes: &[u8]) {
    mesh("mesh.obj", bytes);
}

/// The Stanford format: text, and binary of both orders.
pub fn ply(bytes: &[u8]) {
    mesh("mesh.ply", bytes);
}

/// Stereolithography, text and binary.
pub fn stl(bytes: &[u8]) {
    mesh("mesh.stl", bytes);
}

/// Larger ones are read and looked at as others are; what is built around them only takes longer.
const MOST: usize = 300;

fn mesh(name: &str, bytes: &[u8]) {
    let Ok(mesh) = read(name, bytes.to_vec()) else { return };
    let count = mesh.vertices.len();
    assert!(!mesh.triangles.is_empty());
    assert!(mesh.triangles.iter().flatten().all(|corner| (*corner as usize) < count));
    assert!(mesh.vertices.iter().all(|vertex| vertex.is_finite()));
    if mesh.triangles.len() > MOST {
        return;
    }
    Looks::of(&mesh);
    view(&mesh);
    let triangles = mesh.list();
    for kind in &KINDS {
        (kind.build)(&triangles).bytes();
    }
}
