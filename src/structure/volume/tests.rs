//! Volumes against the exact oracle, on what is hard for them.

use super::{Both, Bounds, Slabs, Sphere, Volume};
use crate::oracle::{Query, solve};
use crate::structure::Beam;
use crate::workload::{Pcg, Ray, Triangle};
use glam::Vec3;

/// Corners where rounding has something to do: sizes, places far away, flat and long triangles, and
/// coordinates that are shared.
fn triangle(pcg: &mut Pcg, family: usize) -> Triangle {
    let mut number = || (pcg.unit_f64() * 2.0 - 1.0) as f32;
    let mut point = || Vec3::new(number(), number(), number());
    let [a, b, c] = [point(), point(), point()];
    let stretched = |factors: Vec3| [a * factors, b * factors, c * factors];
    let [a, b, c] = match family {
        0 => [a, b, c],
        1 => stretched(Vec3::splat(1e-30)),
        2 => stretched(Vec3::splat(1e30)),
        3 => [a + 1e6, b + 1e6, c + 1e6],
        4 => stretched(Vec3::new(1.0, 0.0, 1.0)),
        5 => stretched(Vec3::new(1.0, 1e-6, 1e-3)),
        6 => [a, b, a + (b - a) * 0.999 + Vec3::splat(1e-7)],
        // In one of the planes that slabs are made of, which goes through 0.
        7 => [a, b, c].map(|v| (v * 64.0).round()).map(|v| Vec3::new(v.x, v.y, -v.x - v.y)),
        _ => [a, b, c].map(|v| (v * 3.0).round()),
    };
    Triangle { a, b, c }
}

/// A ray at a point of the triangle, from one of several kinds of places.
fn ray(pcg: &mut Pcg, one: &Triangle, kind: usize) -> Ray {
    let (mut u, mut v) = (pcg.unit_f64() as f32, pcg.unit_f64() as f32);
    if u + v > 1.0 {
        (u, v) = (1.0 - u, 1.0 - v);
    }
    let target = match pcg.below(4) {
        0 => one.a,
        1 => one.a + (one.b - one.a) * u,
        _ => one.a + (one.b - one.a) * u + (one.c - one.a) * v,
    };
    let size = (one.b - one.a).abs().max_element().max((one.c - one.a).abs().max_element());
    let mut number = || (pcg.unit_f64() * 2.0 - 1.0) as f32 * size;
    let away = Vec3::new(number(), number(), number());
    let along = [Vec3::X, -Vec3::Y, Vec3::Z, Vec3::new(1.0, -1.0, 0.0)][pcg.below(4) as usize];
    let origin = match kind {
        0 => target + away,
        1 => target + along * size,
        2 => target + away * 1e5,
        3 => target + away * 1e-4,
        5 => target + along * size * 1e12,
        _ => target,
    };
    let direction = match kind {
        // Zeros of both signs.
        1 | 5 => -along * 3.0,
        4 => away,
        _ => target - origin,
    };
    let scale = [1.0, 1e-20, 1e10, 0.3][pcg.below(4) as usize];
    Ray { origin, direction: direction * scale, end: target, t_min: 0.0, t_max: f32::MAX }
}

/// Every ray that exactly hits must hit the volume, at an interval that holds the exact t.
fn misses_nothing<V: Volume>() {
    let mut pcg = Pcg::new(11);
    let mut hits = [0; 9];
    for round in 0..16_000 {
        let family = round % 9;
        let one = triangle(&mut pcg, family);
        let ray = ray(&mut pcg, &one, round / 9 % 6);
        let exact = solve(&Query::of(&ray, &one));
        let Some(beam) = Beam::of_ray(&ray) else { continue };
        if !exact.class.is_hit() {
            continue;
        }
        hits[family] += 1;
        let volume = V::around(&[one.a, one.b, one.c].map(|corner| corner.to_array()));
        let crossing = volume.crossing(&beam, &V::aim(&beam));
        let crossing = crossing.unwrap_or_else(|| {
            panic!("{ray:?} misses {volume_name} of {one:?}", volume_name = V::NAME)
        });
        assert!(crossing.near <= exact.t && exact.t <= crossing.far, "{crossing:?} {exact:?}");
        let bound = exact.t;
        assert_eq!(volume.hit(&beam, &V::aim(&beam), bound), Some(crossing.near));
    }
    assert!(hits.iter().all(|hits| *hits > 100), "{hits:?}");
}

#[test]
fn boxes_miss_nothing() {
    misses_nothing::<Bounds>();
}

#[test]
fn spheres_miss_nothing() {
    misses_nothing::<Sphere>();
}

#[test]
fn slabs_miss_nothing() {
    misses_nothing::<Slabs>();
}

#[test]
fn intersections_miss_nothing() {
    misses_nothing::<Both<Sphere, Bounds>>();
    misses_nothing::<Both<Sphere, Slabs>>();
}

fn beam(origin: [f32; 3], direction: [f32; 3]) -> Beam {
    let (origin, direction) = (Vec3::from(origin), Vec3::from(direction));
    Beam::of_ray(&Ray { origin, direction, end: origin, t_min: 0.0, t_max: f32::MAX }).unwrap()
}

const UNIT: Bounds = Bounds { low: [0.0; 3], high: [1.0; 3] };

#[test]
fn a_ray_in_the_plane_of_a_face_meets_the_box() {
    for zero in [0.0, -0.0] {
        for face in [0.0, 1.0] {
            for way in [1.0, -1.0] {
                let origin = [0.5 - 2.0 * way, face, 0.5];
                let met = UNIT.crossing(&beam(origin, [way, zero, zero]), &());
                assert!(met.is_some_and(|met| met.near <= 1.5 && met.far >= 2.5));
                // Along an edge, and from a corner.
                assert!(
                    UNIT.crossing(&beam([origin[0], face, face], [way, zero, zero]), &()).is_some()
                );
                assert!(UNIT.crossing(&beam([face; 3], [way, zero, zero]), &()).is_some());
            }
        }
    }
}

#[test]
fn a_ray_beside_the_box_misses_it() {
    for zero in [0.0, -0.0] {
        for beside in [-0.001, 1.001] {
            for way in [1.0, -1.0] {
                let miss = beam([0.5 - 2.0 * way, beside, 0.5], [way, zero, zero]);
                assert!(UNIT.crossing(&miss, &()).is_none());
            }
        }
        assert!(UNIT.crossing(&beam([2.0, 0.5, 0.5], [1.0, zero, zero]), &()).is_none());
    }
    assert!(
        Sphere { centre: [0.0; 3], radius: 1.0 }
            .crossing(
                &beam([0.0, 1.001, -5.0], [0.0, 0.0, 1.0]),
                &Sphere::aim(&beam([0.0, 1.001, -5.0], [0.0, 0.0, 1.0]))
            )
            .is_none()
    );
    let corner = beam([2.0, 2.0, 0.0], [-1.0, -1.0, 0.0]);
    let cut =
        Slabs::around(&[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]]);
    assert!(cut.crossing(&corner, &Slabs::aim(&corner)).is_some());
    let beside = beam([0.9, 0.9, -3.0], [0.0, 0.0, 1.0]);
    assert!(cut.bounds.crossing(&beside, &()).is_some());
    assert!(cut.crossing(&beside, &Slabs::aim(&beside)).is_none());
}

#[test]
fn what_is_behind_or_beyond_the_range_is_missed() {
    let ray = |t_min: f32, t_max: f32| {
        let (origin, direction) = (Vec3::new(-1.0, 0.5, 0.5), Vec3::X);
        Beam::of_ray(&Ray { origin, direction, end: origin, t_min, t_max }).unwrap()
    };
    for (t_min, t_max, is_hit) in [
        (0.0, 0.5, false),
        (0.0, 1.0, true),
        (2.0, 9.0, true),
        (2.5, 9.0, false),
        (-9.0, 9.0, true),
    ] {
        let beam = ray(t_min, t_max);
        assert_eq!(UNIT.crossing(&beam, &()).is_some(), is_hit, "{t_min} {t_max}");
        let sphere = Sphere { centre: [0.5; 3], radius: 0.5 };
        assert_eq!(
            sphere.crossing(&beam, &Sphere::aim(&beam)).is_some(),
            is_hit,
            "{t_min} {t_max}"
        );
    }
    assert_eq!(UNIT.hit(&ray(0.0, 9.0), &(), 0.5), None);
}

#[test]
fn what_hits_nothing_by_rule_is_no_beam() {
    let ray = Ray { origin: Vec3::ZERO, direction: Vec3::X, end: Vec3::X, t_min: 0.0, t_max: 1.0 };
    assert!(Beam::of_ray(&ray).is_some() && Beam::of_segment(&ray).is_some());
    assert!(Beam::of_ray(&Ray { direction: -Vec3::ZERO, ..ray }).is_none());
    assert!(Beam::of_ray(&Ray { direction: Vec3::NAN, ..ray }).is_none());
    assert!(Beam::of_ray(&Ray { origin: Vec3::INFINITY, ..ray }).is_none());
    assert!(Beam::of_ray(&Ray { t_max: f32::NAN, ..ray }).is_none());
    assert!(Beam::of_ray(&Ray { t_max: -1.0, ..ray }).is_none());
    assert!(Beam::of_segment(&Ray { end: Vec3::ZERO, ..ray }).is_none());
    assert!(Beam::of_ray(&Ray { t_max: f32::INFINITY, ..ray }).is_some());
}
