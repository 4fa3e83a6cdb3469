//! Counts, closedness, orientation, and that nothing moves.

use super::*;
use crate::number::Precision;
use crate::scene::look::Looks;
use crate::workload::hash;

fn mesh(text: &str) -> Mesh {
    named(text).expect("it is a scene").expect("of an allowed size")
}

fn looks(text: &str) -> Looks {
    Looks::of(&mesh(text))
}

#[test]
fn scenes_have_their_triangles() {
    for (text, count) in [
        ("cornell-box:1", 32),
        ("cornell-box:3", 272),
        ("icosphere:0", 20),
        ("icosphere:3", 1280),
        ("needle-sphere:1", 24),
        ("needle-sphere:10", 240),
        ("terrain:1", 2),
        ("terrain:7", 98),
        ("soup:1", 1),
        ("soup:123", 123),
        ("room-far:1", 344),
        ("room-far:4", 704),
    ] {
        assert_eq!(mesh(text).triangles.len(), count, "{text}");
        assert_eq!(mesh(text).name, text);
    }
}

#[test]
fn every_scene_is_as_sound_as_one_from_a_file() {
    for scene in &ALL {
        let mesh = mesh(scene.name);
        let count = mesh.vertices.len();
        assert!(mesh.triangles.iter().flatten().all(|corner| (*corner as usize) < count));
        assert!(mesh.vertices.iter().all(|vertex| vertex.is_finite()));
        let shapes = Looks::of(&mesh).shapes;
        let none = (shapes.zero_area, shapes.duplicate_triangles, shapes.duplicate_vertices);
        assert_eq!(none, (0, 0, 0), "{}", scene.name);
    }
}

#[test]
fn spheres_are_closed_and_seen_from_outside() {
    for (text, size) in [("icosphere:3", 642), ("needle-sphere:16", 194), ("needle-sphere:1", 14)] {
        let edges = looks(text).edges;
        assert!(edges.closed && edges.consistent, "{text}");
        assert_eq!((edges.shells, edges.outward, edges.inward), (1, 1, 0), "{text}");
        let mesh = mesh(text);
        // Euler: V - E + F = 2.
        assert_eq!(mesh.vertices.len() + mesh.triangles.len(), edges.manifold as usize + 2);
        assert_eq!(mesh.vertices.len(), size, "{text}");
        // A normalised vector is as long as 4 unit roundoffs allow, see `look::rays`. A coordinate of
        // the needles rounds six times (square, sum, difference, quotient, radius, product), and a
        // rounded square moves a point of the circle by at most one more.
        let off = |vertex: &glam::Vec3| (vertex.as_dvec3().length() - 1.0).abs();
        let worst = mesh.vertices.iter().map(off).fold(0.0, f64::max);
        assert!(worst <= 7.0 * Precision::F32.unit_roundoff(), "{text} {worst}");
    }
}

#[test]
fn needles_are_long_and_the_icosphere_is_even() {
    let median = |text: &str| looks(text).shapes.aspect.median.expect("triangles");
    assert!(median("needle-sphere") > 100.0, "{}", median("needle-sphere"));
    let largest = looks("icosphere:4").shapes.aspect.largest.expect("triangles");
    assert!(largest < 1.7, "{largest}");
}

#[test]
fn the_terrain_can_be_projected() {
    for text in ["terrain:1", "terrain:64", "terrain:200"] {
        let normals = looks(text).normals;
        assert!(normals.can_project[2] && normals.one_sided[2], "{text}");
        assert_eq!((normals.best_axis, normals.down[2]), (Some(2), 0));
        // A slope of sqrt(1/2) has a normal whose part upwards is sqrt(2/3).
        assert!(normals.smallest_share[2] > Some(0.816), "{text} {:?}", normals.smallest_share);
    }
    let edges = looks("terrain:8").edges;
    assert_eq!((edges.closed, edges.boundary, edges.shells), (false, 32, 1));
}

#[test]
fn rooms_are_seen_from_inside() {
    let room = looks("room-far");
    assert!(room.edges.closed && room.edges.consistent);
    assert_eq!((room.edges.shells, room.edges.outward, room.edges.inward), (3, 2, 1));
    assert_eq!(room.extent.lowest, [1e5; 3]);
    assert_eq!(room.extent.ulp, 1.0 / 128.0);
    let cornell = looks("cornell-box:2");
    // The front, the bottoms of both blocks, and the panel.
    assert_eq!((cornell.edges.boundary, cornell.edges.non_manifold), (8 + 2 * 8 + 4, 0));
    assert!(cornell.edges.consistent && !cornell.edges.closed);
    assert_eq!(cornell.edges.shells, 4);
    // All walls, both tops and the panel are across an axis.
    assert_eq!(cornell.shapes.across_axis, [16, 2 * 8 + 2 * 8 + 2, 8]);
}

#[test]
fn soup_hangs_together_nowhere() {
    let edges = looks("soup:300").edges;
    assert_eq!((edges.boundary, edges.manifold, edges.shells), (900, 0, 300));
}

#[test]
fn nothing_moves() {
    // Recorded when the scenes were written: f32 + - * / and square roots give these anywhere.
    let golden = [
        ("cornell-box", 9_461_780_115_201_466_656),
        ("icosphere", 7_408_028_863_645_447_041),
        ("needle-sphere", 15_935_879_414_792_698_061),
        ("terrain", 11_129_972_298_681_940_163),
        ("soup", 12_228_154_274_680_213_915),
        ("room-far", 8_085_317_026_392_936_051),
    ];
    let found = golden.map(|(name, _)| (name, hash::workload(&[], &mesh(name).list())));
    assert_eq!(found, golden);
}

#[test]
fn sizes_are_checked() {
    assert!(named("sphere").is_none() && named("a.obj").is_none());
    for text in ["icosphere:9", "icosphere:", "icosphere:-1", "icosphere:x", "icosphere:4:4"] {
        let error = named(text).expect("it is a scene").expect_err("of a wrong size").to_string();
        let start = format!("{text}: allowed behind the colon: 0 to 8 (");
        assert!(error.starts_with(&start), "{error}");
    }
}
