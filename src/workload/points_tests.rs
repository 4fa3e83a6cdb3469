use super::*;

/// Weights of b and c of the projection along the normal, by Cramer's rule on the Gram matrix in
/// f64: a way of its own, without the numbers that were drawn.
fn weights(point: Vec3, triangle: &Triangle) -> [f64; 3] {
    let wide = |p: Vec3| p.to_array().map(f64::from);
    let (a, b, c) = (wide(triangle.a), wide(triangle.b), wide(triangle.c));
    let minus = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let (ab, ac, ap) = (minus(b, a), minus(c, a), minus(wide(point), a));
    let gram = dot(ab, ab) * dot(ac, ac) - dot(ab, ac) * dot(ab, ac);
    let u = (dot(ap, ab) * dot(ac, ac) - dot(ap, ac) * dot(ab, ac)) / gram;
    let v = (dot(ap, ac) * dot(ab, ab) - dot(ap, ab) * dot(ab, ac)) / gram;
    [1.0 - u - v, u, v]
}

fn all_weights(set: &PointSet) -> Vec<[f64; 3]> {
    set.rays.iter().zip(&set.triangles).map(|(ray, t)| weights(ray.end, t)).collect()
}

fn inside(weights: &[f64; 3]) -> bool {
    weights.iter().all(|weight| *weight > 0.0)
}

fn set(count: usize, density: f64, seed: u64) -> PointSet {
    PointSet::draw(PointSpec { count, density, seed }).unwrap()
}

#[test]
fn the_share_inside_is_exact() {
    for (density, hits) in [(0.0, 0), (0.25, 250), (0.3335, 334), (1.0, 1001)] {
        let points = set(1001, density, 3);
        assert_eq!((points.rays.len(), points.triangles.len()), (1001, 1001));
        let counted = all_weights(&points).iter().filter(|weights| inside(weights)).count();
        assert_eq!((points.hits, counted), (hits, hits), "{density}");
        assert_eq!(points.density(), hits as f64 / 1001.0);
    }
}

#[test]
fn every_window_holds_the_share_within_one_point() {
    let found: Vec<bool> = all_weights(&set(500, 0.3, 9)).iter().map(inside).collect();
    for length in [1, 7, 50, 333] {
        for window in found.windows(length) {
            let hits = window.iter().filter(|hit| **hit).count() as f64;
            assert!((hits - 0.3 * length as f64).abs() < 1.0, "{hits} of {length}");
        }
    }
}

#[test]
fn rounding_moves_no_weight_by_more_than_was_derived() {
    for weights in all_weights(&set(4000, 0.5, 6)) {
        for weight in weights {
            assert!(weight.abs() >= MARGIN - 0.0004, "{weights:?}");
        }
    }
}

#[test]
fn points_lie_beside_the_plane_by_one_rounding() {
    let points = set(4000, 0.5, 7);
    let bound = 3f64.sqrt() / f64::from(1 << 23);
    let mut beside = 0;
    for (ray, triangle) in points.rays.iter().zip(&points.triangles) {
        let distance = off_plane(ray.end, triangle);
        assert!(distance <= bound * 1.000_001, "{distance}");
        beside += usize::from(distance > 1e-9);
    }
    // A few are in the plane as far as f64 can tell; for the others the answer needs its definition.
    assert!(beside > 3500, "{beside}");
}

#[test]
fn triangles_and_origins_are_as_the_derivation_needs_them() {
    let points = set(4000, 0.5, 8);
    let mut slim = 0;
    for (ray, triangle) in points.rays.iter().zip(&points.triangles) {
        assert!(aspect(triangle) <= 50.0 && longest_squared(triangle) >= 1.0 / 256.0);
        slim += usize::from(aspect(triangle) > 10.0);
        assert!(off_plane(ray.origin, triangle) >= 1.0 / 64.0);
        let towards = (ray.end - ray.origin).normalize().dot(ray.direction);
        assert!((towards - 1.0).abs() < 1e-6);
        let largest = ray.end.to_array().map(f32::abs).into_iter().fold(0.0, f32::max);
        assert!(largest <= 4.0);
    }
    assert!((100..1500).contains(&slim), "{slim}");
}

#[test]
fn points_outside_are_beyond_one_edge_and_beyond_two() {
    let beyond = |weights: &[f64; 3]| weights.iter().filter(|weight| **weight < 0.0).count();
    let mut counts = [0usize; 4];
    for weights in all_weights(&set(4000, 0.0, 5)) {
        counts[beyond(&weights)] += 1;
    }
    // Of the square's area of 9, 0.5 is inside and 2 are beyond two edges; 5 standard errors of
    // 4 000 draws at 2 / 8.5 are 134, and the margins take a few points more.
    assert!(counts[0] == 0 && counts[3] == 0 && counts[2].abs_diff(941) < 160, "{counts:?}");
}

#[test]
fn sets_are_golden() {
    let hashes = [set(1000, 0.25, 1).hash, set(1000, 0.25, 2).hash, set(1000, 1.0, 1).hash];
    // Computed a second time from the definitions alone, in another language.
    let golden = [0x78e1_bdea_5a3f_a35c, 0x6db7_5e66_8392_9090, 0x2c0d_58b8_4923_50d6];
    assert_eq!(hashes, golden, "{hashes:#x?}");
}

#[test]
fn bad_specifications_are_refused_with_what_is_allowed() {
    let message = |count, density| {
        PointSet::draw(PointSpec { count, density, seed: 1 }).unwrap_err().to_string()
    };
    assert_eq!(message(10, 1.5), "density is 1.5; allowed is a number from 0 to 1");
    assert_eq!(message(0, 0.5), "number of points is 0; allowed is 1 to 16777216");
}
