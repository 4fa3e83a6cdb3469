//! Rays from inside a closed mesh, aimed at its edges and vertices: the kernels that call themselves
//! watertight lose none, and others do.

use std::collections::HashMap;

use ray_test::oracle::Query;
use ray_test::registry::{Asked, asked};
use ray_test::workload::Pcg;

type Point = [f64; 3];

/// A bumpy sphere around `center`: an octahedron whose faces are divided `times` times by four.
/// Coordinates are f32 values, which f64 holds too.
fn mesh(center: f64, times: usize, draw: &mut Pcg) -> (Vec<Point>, Vec<[usize; 3]>) {
    let mut points: Vec<Point> = Vec::new();
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            points.push(std::array::from_fn(|i| if i == axis { sign } else { 0.0 }));
        }
    }
    let mut faces = Vec::new();
    for (x, y, z) in (0..8).map(|i| (i & 1, 2 + (i >> 1 & 1), 4 + (i >> 2))) {
        let mirrored = (x + y + z) % 2 == 1;
        faces.push(if mirrored { [x, z, y] } else { [x, y, z] });
    }
    for _ in 0..times {
        let mut between: HashMap<[usize; 2], usize> = HashMap::new();
        let mut middle = |a: usize, b: usize| {
            *between.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                points.push(std::array::from_fn(|i| (points[a][i] + points[b][i]) / 2.0));
                points.len() - 1
            })
        };
        faces = faces
            .iter()
            .flat_map(|&[a, b, c]| {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    for point in &mut points {
        let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
        let radius = 1.0 + draw.below(1 << 20) as f64 / f64::from(1 << 22);
        *point = point.map(|x| f64::from((center + x / length * radius) as f32));
    }
    (points, faces)
}

/// Rays from near the center, of which two in three are aimed at an edge, the rest at a vertex.
fn rays(points: &[Point], faces: &[[usize; 3]], center: f64, draw: &mut Pcg) -> Vec<[Point; 2]> {
    let mut rays = Vec::new();
    let unit = |draw: &mut Pcg| draw.below(1 << 24) as f64 / 16_777_216.0;
    for i in 0..12_000 {
        let [a, b, _] = faces[draw.below(faces.len() as u64) as usize];
        let share = if i % 3 == 0 { 0.0 } else { unit(draw) };
        let origin: Point =
            std::array::from_fn(|_| f64::from((center + (unit(draw) - 0.5) / 8.0) as f32));
        let direction = std::array::from_fn(|i| {
            let target = points[a][i] + share * (points[b][i] - points[a][i]);
            f64::from((target - origin[i]) as f32)
        });
        rays.push([origin, direction]);
    }
    rays
}

/// Rays that hit nothing.
fn leaks(form: &Asked, center: f64) -> usize {
    let mut draw = Pcg::new(31);
    let (points, faces) = mesh(center, 2, &mut draw);
    let rays = rays(&points, &faces, center, &mut draw);
    let lost = |[origin, direction]: &&[Point; 2]| {
        faces.iter().all(|face| {
            let query = Query {
                origin: *origin,
                direction: *direction,
                end: None,
                triangle: face.map(|corner| points[corner]),
                t_min: 0.0,
                t_max: f64::INFINITY,
            };
            (form.ask)(&query).triangle.is_none()
        })
    };
    rays.iter().filter(lost).count()
}

fn form(id: &str) -> &'static Asked {
    asked().iter().find(|form| form.id() == id).unwrap_or_else(|| panic!("no {id}"))
}

#[test]
fn watertight_forms_lose_no_ray() {
    for division in ["first", "last"] {
        for id in [
            format!("woop-watertight/f32/single/sse2/early/{division}/plain/tuv"),
            format!("woop-watertight/f64/single/sse2/early/{division}/plain/tuv"),
            format!("woop-watertight/f32/single/sse2/early/{division}/plain/tuv/edges=exact-sign"),
            format!("woop-watertight/f32/single/avx2/early/{division}/fused/tuv/edges=exact-sign"),
            format!("woop-watertight/f64/single/avx2/early/{division}/fused/tuv/edges=exact-sign"),
        ] {
            let id = on_this_processor(&id);
            for center in [0.0, 1000.0] {
                assert_eq!(leaks(form(&id), center), 0, "{id} around {center}");
            }
        }
    }
}

#[test]
fn other_forms_lose_some() {
    for id in [
        "woop-watertight/f32/single/avx2/early/last/fused/tuv",
        "moller-trumbore/f32/single/sse2/early/last/plain/tuv",
        "baldwin-weber/f32/single/sse2/early/last/plain/tuv",
        "woop-affine/f32/single/sse2/early/last/plain/tuv",
    ] {
        let leaks = leaks(form(&on_this_processor(id)), 0.0);
        println!("{id}: {leaks} of 12000");
        assert!(leaks > 0, "{id}");
    }
}

/// The same form where levels have other names.
fn on_this_processor(id: &str) -> String {
    if cfg!(target_arch = "aarch64") {
        id.replace("sse2", "neon").replace("avx2", "neon")
    } else {
        id.to_owned()
    }
}
