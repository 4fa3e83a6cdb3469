//! What rays are like, by the exact answer.

use super::*;
use crate::oracle::{Query, classify, nearest};
use crate::scene::built_in::named;
use crate::scene::look::{Looks, RayLooks};
use crate::scene::mesh::Dropped;

const PLAN: Plan = Plan { width: 24, height: 16, per_point: 3, seed: 5 };

fn scene(text: &str) -> Mesh {
    named(text).expect("it is a scene").expect("of an allowed size")
}

fn exact(mesh: &Mesh) -> impl FnMut(&Ray) -> Option<u32> {
    let list = mesh.list();
    move |ray| nearest(ray, &list).map(|(index, _)| index as u32)
}

fn rays(word: &str, mesh: &Mesh) -> Rays {
    Rays::of(&Asked::of(word), mesh, PLAN, exact(mesh)).expect("they are drawn")
}

fn looks(rays: &Rays, mesh: &Mesh) -> RayLooks {
    let looks = Looks::of(mesh).with_rays(mesh, &rays.rays, |_| None);
    looks.rays.expect("rays")
}

#[test]
fn a_camera_sees_the_whole_mesh() {
    for text in ["icosphere:1", "needle-sphere:4", "soup:40"] {
        let mesh = scene(text);
        let view = view(&mesh);
        for (width, height) in [(24, 16), (16, 24), (9, 9)] {
            let camera = Camera::new(&view, width, height);
            for vertex in &mesh.vertices {
                assert!(camera.sees(*vertex), "{text} {width}x{height} {vertex}");
            }
            // And not much more: a ball of twice the radius does not fit.
            let bounds = mesh.bounds();
            let ends = mesh.vertices.iter().map(|v| v.as_dvec3() * 2.0 - bounds.centre());
            assert!(!ends.map(|end| end.as_vec3()).all(|end| camera.sees(end)), "{text}");
        }
    }
}

#[test]
fn scenes_that_choose_their_view_are_in_it() {
    for text in ["cornell-box:1", "terrain:16"] {
        let mesh = scene(text);
        let camera = Camera::new(&view(&mesh), 9, 9);
        assert!(mesh.vertices.iter().all(|vertex| camera.sees(*vertex)), "{text}");
    }
}

#[test]
fn primary_rays_start_at_one_point_and_run_row_by_row() {
    let mesh = scene("icosphere:2");
    let primary = rays("primary", &mesh);
    assert_eq!(primary.rays.len(), 24 * 16);
    let looks = looks(&primary, &mesh);
    assert!(looks.common_origin && looks.normalised && looks.open_range && looks.all_outside);
    // A ball that touches the shorter sides covers this part of the picture.
    let covered = std::f64::consts::PI / 4.0 * 16.0 / 24.0;
    let mut first = exact(&mesh);
    let hits = primary.rays.iter().filter(|ray| first(ray).is_some()).count() as f64;
    let share = hits / primary.rays.len() as f64;
    // The ball around the box is 1.7 times as wide as the sphere in it.
    assert!(share > covered / 4.0 && share < covered, "{share} {covered}");
    let (left, right) = (primary.rays[0].direction, primary.rays[23].direction);
    let bottom = primary.rays[24 * 15].direction;
    assert!(left.y > bottom.y && left.dot(right) < 0.99);
    // The camera looks towards -z from the front: right is +x, more or less.
    assert!(right.x > left.x);
}

#[test]
fn built_in_views_are_inside_or_before_the_room() {
    let mesh = scene("room-far");
    let primary = rays("primary", &mesh);
    assert_eq!(looks(&primary, &mesh).origins_outside, 0);
    let mut first = exact(&mesh);
    assert!(primary.rays.iter().all(|ray| first(ray).is_some()));
    let mesh = scene("cornell-box:1");
    assert!(looks(&rays("primary", &mesh), &mesh).all_outside);
}

#[test]
fn shadow_rays_leave_their_triangle_and_end_before_the_light() {
    for text in ["cornell-box:2", "room-far:2", "icosphere:3", "needle-sphere:8", "terrain:9"] {
        let mesh = scene(text);
        let primary = rays("primary", &mesh);
        let shadow = rays("shadow", &mesh);
        let light = shadow.light.expect("a light");
        let mut first = exact(&mesh);
        let met: Vec<u32> = primary.rays.iter().filter_map(&mut first).collect();
        assert_eq!(shadow.rays.len() as u64 + shadow.dark, met.len() as u64, "{text}");
        assert_eq!(shadow.unseen, (primary.rays.len() - met.len()) as u64);
        assert!(shadow.rays.len() > 30, "{text} {}", shadow.rays.len());
        for ray in &shadow.rays {
            let end = ray.origin.as_dvec3() + ray.direction.as_dvec3() * f64::from(ray.t_max);
            let gap = end.distance(light.as_dvec3());
            let margin = spot::offset([light, ray.origin]);
            // By the margin, give or take what rounding t_max (one unit roundoff of the distance)
            // and the direction (sqrt(3) of them) move the end: 2.8 u times at most sqrt(12) times the
            // largest coordinate, where the margin is 64 u times that. A half is room enough.
            assert!(gap > margin * 0.5 && gap < margin * 1.5, "{text} {gap} {margin}");
            assert_eq!((ray.t_min, ray.end), (0.0, light));
        }
        let looks = looks(&shadow, &mesh);
        assert!(looks.normalised && looks.finite_ends == looks.rays, "{text}");
    }
}

#[test]
fn no_next_ray_meets_the_triangle_that_it_leaves() {
    for text in ["cornell-box:2", "room-far:2", "icosphere:3", "soup:300", "needle-sphere:8"] {
        let mesh = scene(text);
        let mut first = exact(&mesh);
        let mut spots = 0;
        for ray in rays("primary", &mesh).rays {
            let Some(index) = first(&ray) else { continue };
            let triangle = mesh.triangle(index as usize);
            let spot = Spot::of(&ray, &triangle).expect("a point");
            let height = (spot.start.as_dvec3() - triangle.a.as_dvec3()).dot(spot.normal);
            assert!(height > spot.offset / 2.0, "{text} {height} {}", spot.offset);
            assert!(spot.normal.dot(ray.direction.as_dvec3()) < 0.0);
            let away = Ray { origin: spot.start, direction: spot.normal.as_vec3(), ..ray };
            assert!(!classify(&Query::of(&away, &triangle)).is_hit());
            let back = Ray { direction: -away.direction, ..away };
            assert!(first(&back).is_some(), "{text}: the surface is under the start");
            spots += 1;
        }
        assert!(spots > 20, "{text} {spots}");
    }
}

#[test]
fn ambient_rays_are_over_the_surface() {
    let mesh = scene("icosphere:2");
    let ambient = rays("ambient", &mesh);
    let mut first = exact(&mesh);
    let met = rays("primary", &mesh).rays.iter().filter(|ray| first(ray).is_some()).count();
    assert_eq!((ambient.rays.len(), ambient.unseen as usize), (3 * met, 24 * 16 - met));
    // Nothing is over a convex surface.
    assert!(ambient.rays.iter().all(|ray| first(ray).is_none()));
    assert!(looks(&ambient, &mesh).normalised);
    let again = rays("ambient", &mesh);
    assert_eq!(ambient.rays, again.rays);
}

#[test]
fn random_rays_are_chords_of_the_ball() {
    for text in ["icosphere:1", "room-far:1"] {
        let mesh = scene(text);
        let bounds = mesh.bounds();
        let random = rays("random", &mesh);
        assert_eq!(random.rays.len(), 24 * 16);
        let looks = looks(&random, &mesh);
        assert!(looks.normalised && looks.other_origins > 0 && looks.other_directions > 0);
        for ray in &random.rays {
            let off = ray.origin.as_dvec3().distance(bounds.centre()) / bounds.radius() - 1.0;
            // Points of the unit sphere are rounded, then their place is, to half a step of f32.
            let step = f64::from(f32::EPSILON);
            let rounding = step * (2.0 + bounds.largest_coordinate() / bounds.radius());
            assert!(off.abs() <= rounding, "{text} {off} {rounding}");
            let inwards = (bounds.centre() - ray.origin.as_dvec3()).dot(ray.direction.as_dvec3());
            assert!(inwards > 0.0, "{text}");
            // The segment ends behind the ball.
            let end = ray.end.as_dvec3().distance(bounds.centre());
            assert!(end > bounds.radius(), "{text}");
        }
    }
}

#[test]
fn a_point_has_a_camera_too() {
    let mesh = Mesh {
        name: "point".into(),
        vertices: vec![Vec3::ONE; 3],
        triangles: vec![[0, 1, 2]],
        dropped: Dropped::default(),
        view: None,
    };
    let primary = rays("primary", &mesh);
    assert!(primary.rays.iter().all(|ray| ray.direction.is_finite() && ray.end.is_finite()));
    assert_eq!(rays("shadow", &mesh).rays, []);
}

fn read(text: &str) -> Result<Vec<Ray>, String> {
    let bounds = Bounds { lowest: Vec3::splat(-1.0), highest: Vec3::ONE };
    file::read(text.as_bytes(), "rays", &bounds).map_err(|error| error.to_string())
}

#[test]
fn rays_are_read_from_a_file() {
    let rays = read("ox,oy,oz,dx,dy,dz\n1,2,3,0,0,0.1\n\n4,5,6,0,0,0\n").expect("rays");
    assert_eq!(rays.len(), 2);
    assert_eq!((rays[0].origin, rays[0].direction), (Vec3::new(1.0, 2.0, 3.0), Vec3::Z * 0.1));
    assert_eq!((rays[0].t_min, rays[0].t_max), (0.0, f32::MAX));
    assert!(rays[0].end.z > 5.0 && rays[1].end.is_finite());
    let turned = "tmax,tmin,dz,dy,dx,oz,oy,ox\n2,-1,1,0,0,3,2,1\ninf,,1,0,0,3,2,1\n";
    let rays = read(turned).expect("rays");
    assert_eq!((rays[0].t_min, rays[0].t_max, rays[0].end.z), (-1.0, 2.0, 5.0));
    assert_eq!((rays[1].t_min, rays[1].t_max), (0.0, f32::MAX));
    let json = r#"{"ox":1,"oy":2,"oz":3,"dx":0,"dy":0,"dz":1,"tmax":2}"#;
    assert_eq!(read(json).expect("a ray")[0].end, Vec3::new(1.0, 2.0, 5.0));
}

#[test]
fn wrong_rays_are_named_by_line_and_column() {
    let refusal = |text: &str| read(text).expect_err("it must be refused");
    let header = "ox,oy,oz,dx,dy,dz,tmin,tmax\n";
    let of = |row: &str| refusal(&format!("{header}0,0,0,0,0,1,,\n{row}\n"));
    let number = "allowed: a number that f32 holds, neither nan nor infinite";
    for word in ["x", "nan", "-inf", "1e39", ""] {
        let expected = format!("rays, line 3, column 5 (dy): '{word}' is not allowed; {number}");
        assert_eq!(of(&format!("0,0,0,0,{word},1,,")), expected);
    }
    let text = of("0,0,0,0,0,1,2,1");
    assert_eq!(
        text,
        "rays, line 3, column 8 (tmax): '1' is not allowed; allowed: at least tmin, which is 2"
    );
    assert!(of("0,0,0,0,0,1,nan,").starts_with("rays, line 3, column 7 (tmin): 'nan'"));
    assert!(of("0,0").starts_with("rays, line 3, column 3: 2 values"));
    assert!(refusal(header).starts_with("rays: no ray; allowed"));
    assert!(refusal("ox,oy\n").contains("missing columns: oz"));
    let missing = Rays::of(&Asked::of("no such file"), &scene("soup:1"), PLAN, |_| None);
    assert!(missing.is_err_and(|error| error.to_string().starts_with("no such file: ")));
}
