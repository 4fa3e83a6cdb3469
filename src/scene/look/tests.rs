//! Small meshes whose looks are known.

use super::*;
use crate::oracle::nearest;
use crate::scene::mesh::Dropped;
use crate::workload::{Pcg, Triangle};
use glam::Vec3;

fn mesh(vertices: &[[f32; 3]], triangles: &[[u32; 3]]) -> Mesh {
    Mesh {
        name: "test".into(),
        vertices: vertices.iter().copied().map(Vec3::from).collect(),
        triangles: triangles.to_vec(),
        dropped: Dropped::default(),
        view: None,
    }
}

/// Corners of a tetrahedron, and its triangles counter-clockwise from outside.
const CORNERS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
const SIDES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

fn tetrahedron() -> Mesh {
    mesh(&CORNERS, &SIDES)
}

#[test]
fn a_tetrahedron_looks_like_one() {
    let looks = Looks::of(&tetrahedron());
    assert_eq!((looks.shapes.triangles, looks.shapes.vertices), (4, 4));
    assert_eq!(looks.shapes.across_axis, [1, 1, 1]);
    assert_eq!(looks.shapes.axis_aligned_share, 0.75);
    assert_eq!((looks.shapes.edge.smallest, looks.shapes.edge.median), (Some(4.0), Some(4.0)));
    // Legs of 4 and a right angle: twice the area is 16, the longest edge squared 32.
    assert_eq!(looks.shapes.aspect.largest, Some(2.0));
    assert_eq!(looks.extent.diagonal, 48f64.sqrt());
    assert_eq!((looks.extent.farthest_coordinate, looks.extent.ulp), (4.0, 2f64.powi(-21)));
    assert_eq!(looks.extent.ulp_over_smallest_edge, Some(2f64.powi(-23)));
    assert_eq!(looks.extent.offset_over_size, Some(0.5));
    let edges = &looks.edges;
    assert_eq!((edges.boundary, edges.manifold, edges.turned), (0, 6, 0));
    assert!(edges.closed && edges.consistent);
    assert_eq!((edges.shells, edges.outward, edges.inward), (1, 1, 0));
    assert_eq!(looks.normals.edge_on, [2, 2, 2]);
    assert_eq!((looks.normals.can_project, looks.normals.best_axis), ([false; 3], None));
    assert_eq!((looks.normals.up, looks.normals.down), ([1; 3], [1; 3]));
}

#[test]
fn one_turned_triangle_is_seen() {
    let mut turned = tetrahedron();
    turned.triangles[2].swap(0, 1);
    let edges = Looks::of(&turned).edges;
    assert!(edges.closed && !edges.consistent);
    assert_eq!((edges.turned, edges.outward, edges.inward), (3, 0, 0));
    let mut inside_out = tetrahedron();
    inside_out.triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1));
    let edges = Looks::of(&inside_out).edges;
    assert_eq!((edges.turned, edges.outward, edges.inward), (0, 0, 1));
}

#[test]
fn a_missing_and_a_doubled_triangle_are_seen() {
    let mut open = tetrahedron();
    open.triangles.pop();
    let edges = Looks::of(&open).edges;
    assert_eq!((edges.boundary, edges.manifold, edges.closed), (3, 3, false));
    let mut double = tetrahedron();
    double.triangles.push([3, 0, 2]);
    let looks = Looks::of(&double);
    assert_eq!((looks.shapes.duplicate_triangles, looks.edges.non_manifold), (1, 3));
    assert!(!looks.edges.closed && !looks.edges.consistent);
}

#[test]
fn vertices_at_one_place_are_one() {
    // Every triangle with vertices of its own, one of them with a zero of the other sign.
    let corners: Vec<[f32; 3]> =
        SIDES.iter().flatten().map(|corner| CORNERS[*corner as usize]).collect();
    let triangles: Vec<[u32; 3]> = (0..4).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mut apart = mesh(&corners, &triangles);
    apart.vertices[0].x = -0.0;
    let looks = Looks::of(&apart);
    assert_eq!((looks.shapes.vertices, looks.shapes.duplicate_vertices), (12, 8));
    assert_eq!(looks.edges, Looks::of(&tetrahedron()).edges);
}

#[test]
fn zero_areas_are_found_exactly() {
    // Collinear by whole numbers; by one unit in the last place not; a point; a folded segment.
    let next = f32::from_bits(3.0f32.to_bits() + 1);
    let corners = [
        [1.0, 1.0, 1.0],
        [2.0, 2.0, 2.0],
        [3.0, 3.0, 3.0],
        [3.0, 3.0, next],
        [1e-30, 0.0, 0.0],
        [1e30, 0.0, 0.0],
        [0.0, 1e-45, 0.0],
    ];
    let triangles = [[0, 1, 2], [0, 1, 3], [0, 0, 0], [0, 1, 0], [4, 5, 6]];
    let looks = Looks::of(&mesh(&corners, &triangles));
    assert_eq!(looks.shapes.zero_area, 3);
    assert!(looks.shapes.height.smallest > Some(0.0));
    // Neither the point nor the folded segment has edges.
    assert_eq!(looks.edges.boundary + 2 * looks.edges.manifold, 9);
    let only = Looks::of(&mesh(&corners, &[[0, 1, 2]]));
    assert_eq!(only.shapes.aspect, Quantiles::default());
    assert_eq!((only.extent.ulp_over_smallest_edge, only.normals.best_axis), (None, None));
}

/// A triangle of whole numbers, and the components of its normal.
fn whole(pcg: &mut Pcg) -> (Triangle, [i64; 3]) {
    let mut point = || [(); 3].map(|()| pcg.below(7) as i64 - 3);
    let [a, b, c] = [point(), point(), point()];
    let e = |i: usize| (b[i] - a[i], c[i] - a[i]);
    let normal = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| e(i).0 * e(j).1 - e(j).0 * e(i).1);
    let corner = |p: [i64; 3]| Vec3::from(p.map(|x| x as f32));
    (Triangle { a: corner(a), b: corner(b), c: corner(c) }, normal)
}

#[test]
fn components_are_decided_exactly() {
    let mut pcg = Pcg::new(4);
    let (mut zeros, mut degenerate) = (0, 0);
    for _ in 0..2000 {
        let (triangle, normal) = whole(&mut pcg);
        // At a place where f32 still holds whole numbers, and times a power of two.
        let moved = |p: Vec3| (p + Vec3::splat(1048576.0)) * 0.125;
        let (a, b, c) = (moved(triangle.a), moved(triangle.b), moved(triangle.c));
        for triangle in [triangle, Triangle { a, b, c }] {
            let direction = direction::Direction::of(&triangle);
            assert_eq!(direction.certain, [true; 3]);
            for (component, expected) in direction.components.iter().zip(normal) {
                assert_eq!(component.partial_cmp(&0.0), expected.partial_cmp(&0));
            }
            zeros += normal.iter().filter(|x| **x == 0).count();
            degenerate += usize::from(direction.is_degenerate());
        }
    }
    assert!(zeros > 200 && degenerate > 20, "{zeros} {degenerate}");
}

#[test]
fn zeros_that_f64_cannot_tell_are_told() {
    // So near to 0 that every difference is rounded to what it would be without it.
    let tiny = f32::from_bits((127 - 60) << 23);
    let z = |a: [f32; 2]| {
        let a = Vec3::new(a[0], a[1], 5.0);
        let (b, c) = (Vec3::new(1.0, 1.0, 0.0), Vec3::new(2.0, 2.0, 0.0));
        let direction = direction::Direction::of(&Triangle { a, b, c });
        (direction.components[2] != 0.0, direction.certain[2])
    };
    assert_eq!([z([0.0, 0.0]), z([tiny, tiny])], [(false, true); 2]);
    assert_eq!([z([tiny, 0.0]), z([0.0, tiny])], [(true, false); 2]);
    let corners = [[tiny, 0.0, 5.0], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0]];
    let normals = Looks::of(&mesh(&corners, &[[0, 1, 2]])).normals;
    assert!(normals.can_project[2] && !normals.one_sided[2]);
    assert!(normals.smallest_share[2] > Some(0.0));
}

#[test]
fn one_triangle_on_edge_forbids_the_projection() {
    let corners = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.25],
        [1.0, 1.0, 1.0],
        [0.0, 0.5, 3.0],
        [1e-7, 0.5, 3.0],
    ];
    let flat = Looks::of(&mesh(&corners, &[[0, 1, 2], [1, 3, 2]])).normals;
    assert_eq!((flat.can_project, flat.best_axis), ([false, true, true], Some(2)));
    assert!(flat.one_sided[2]);
    let upright = Looks::of(&mesh(&corners, &[[0, 1, 2], [1, 3, 2], [0, 2, 4]])).normals;
    assert_eq!((upright.can_project[2], upright.edge_on[2]), (false, 1));
    assert_eq!(upright.smallest_share[2], Some(0.0));
    // However near to upright, it is not.
    let steep = Looks::of(&mesh(&corners, &[[0, 1, 2], [1, 3, 2], [0, 2, 5]])).normals;
    assert_eq!(steep.edge_on[2], 0);
    assert!(steep.smallest_share[2] > Some(0.0) && steep.smallest_share[2] < Some(1e-6));
}

fn ray(origin: [f32; 3], direction: [f32; 3]) -> Ray {
    let (origin, direction) = (Vec3::from(origin), Vec3::from(direction));
    Ray { origin, direction, end: origin + direction, t_min: 0.0, t_max: f32::MAX }
}

#[test]
fn backs_are_hidden_only_where_that_is_certain() {
    let outside = ray([1.0, 1.0, -1.0], [0.0, 0.0, 1.0]);
    let hides =
        |mesh: &Mesh, ray: Ray| Looks::of(mesh).with_rays(mesh, &[ray], |_| None).hides_backs();
    let closed = tetrahedron();
    assert!(hides(&closed, outside));
    assert!(!Looks::of(&closed).hides_backs(), "nothing is known of rays");
    assert!(!hides(&closed, ray([1.0, 1.0, 1.0], [0.0, 0.0, 1.0])), "it starts inside the box");
    assert!(!hides(&closed, Ray { t_min: 1.5, ..outside }), "it starts behind a front");
    assert!(!hides(&closed, Ray { t_min: -9.0, ..outside }), "it is a line");
    for spoil in [0, 1, 2] {
        let mut mesh = tetrahedron();
        match spoil {
            0 => drop(mesh.triangles.pop()),
            1 => mesh.triangles[3].swap(0, 1),
            _ => mesh.triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1)),
        }
        assert!(!hides(&mesh, outside), "{spoil}");
    }
    // A second shell beside it, turned inside out.
    let mut two = tetrahedron();
    two.vertices.extend(CORNERS.map(|corner| Vec3::from(corner) + Vec3::splat(9.0)));
    two.triangles.extend(SIDES.map(|[a, b, c]| [b + 4, a + 4, c + 4]));
    assert!(!hides(&two, outside));
    two.triangles[4..].iter_mut().for_each(|triangle| triangle.swap(0, 1));
    assert!(hides(&two, outside));
}

fn seen(rays: &[Ray]) -> (RayLooks, Samples) {
    let mesh = tetrahedron();
    let list = mesh.list();
    let first = |ray: &Ray| nearest(ray, &list).map(|(index, _)| index as u32);
    let looks = Looks::of(&mesh).with_rays(&mesh, rays, first);
    (looks.rays.expect("rays"), looks.samples.expect("samples"))
}

#[test]
fn rays_of_a_camera_and_parallel_rays_are_told_apart() {
    let camera = [ray([1.0, 1.0, -8.0], [0.0, 0.0, 1.0]), ray([1.0, 1.0, -8.0], [0.6, 0.0, 0.8])];
    let (looks, _) = seen(&camera);
    assert!(looks.common_origin && !looks.parallel && looks.normalised && looks.open_range);
    assert!(looks.all_outside);
    assert_eq!((looks.other_directions, looks.box_share), (1, 0.5));
    let parallel = [ray([1.0, 1.0, 1.0], [0.0, 0.0, 2.0]), ray([9.0, 1.0, 1.0], [0.0, 0.0, 2.0])];
    let (looks, _) = seen(&parallel);
    assert!(looks.parallel && !looks.common_origin && !looks.normalised && !looks.all_outside);
    assert_eq!((looks.length_error, looks.origins_outside), (f64::from(1 << 24), 1));
    let short = Ray { t_min: 0.5, t_max: 7.0, ..camera[0] };
    let (looks, _) = seen(&[short]);
    assert_eq!((looks.finite_ends, looks.moved_starts, looks.open_range), (1, 1, false));
    // It ends before the box.
    assert_eq!(looks.box_share, 0.0);
    let (none, samples) = seen(&[]);
    assert_eq!((none.rays, none.box_share, samples.hits), (0, 0.0, 0));
}

#[test]
fn hits_of_edges_and_backs_are_counted() {
    let down = [0.0, 0.0, 1.0];
    let rays = [
        // Inside the side across z, which is met from below, its front.
        ray([1.0, 1.0, -1.0], down),
        // At the edge that it shares with the side across y, exactly, and a rounding beside it.
        ray([1.0, 0.0, -1.0], down),
        ray([1.0, -1.0, -1.0], [0.0, 1.0 + f32::EPSILON, 1.0]),
        // From inside: a back.
        ray([1.0, 1.0, 1.0], down),
        // Past it.
        ray([5.0, 5.0, -1.0], down),
    ];
    let (_, samples) = seen(&rays);
    assert_eq!((samples.rays, samples.hits), (5, 4));
    assert_eq!((samples.edge_share, samples.near_edge_share), (0.25, 0.5));
    assert_eq!(samples.back_share, 0.25);
    assert_eq!(samples.largest_t, Some(1.0));
    // The slanted side has the normal (1, 1, 1).
    let cosine = samples.smallest_cosine.expect("hits");
    assert!((cosine - 1.0 / 3f64.sqrt()).abs() <= 4.0 * f64::EPSILON, "{cosine}");
}

#[test]
fn quantiles_are_values_of_nearest_rank() {
    let of = |count: u32| Quantiles::of((1..=count).rev().map(f64::from).collect());
    let hundred = of(100);
    assert_eq!((hundred.smallest, hundred.p01, hundred.median), (Some(1.0), Some(1.0), Some(50.0)));
    assert_eq!((hundred.p99, hundred.largest), (Some(99.0), Some(100.0)));
    assert_eq!(of(1).p99, Some(1.0));
    assert_eq!(of(0), Quantiles::default());
}

#[test]
fn looks_are_written_without_what_json_lacks() {
    let json = serde_json::to_string(&Looks::of(&tetrahedron())).expect("it can be written");
    assert!(json.contains("\"closed\":true") && json.contains("\"rays\":null"), "{json}");
}
