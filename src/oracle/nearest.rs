//! The nearest of many triangles, exactly.

use super::class::Class;
use super::exact::{Exact, classify_in_integers, numerators, solve};
use super::filter::Filtered;
use super::query::Query;
use crate::workload::{Ray, Triangle};
use std::cmp::Ordering;

/// A triangle that is hit, and where, as far as f64 knows.
struct Candidate {
    index: usize,
    query: Query,
    t: f64,
    /// The exact t lies within this of `t`.
    error: f64,
}

/// Index and answer of the nearest triangle that the ray hits, `None` where it hits none. Equal
/// distances go to the lowest index. Distances are compared exactly: in f64 with its error bound,
/// and by cross-multiplied integers where that does not decide.
pub fn nearest(ray: &Ray, triangles: &[Triangle]) -> Option<(usize, Exact)> {
    let mut best: Option<Candidate> = None;
    for (index, triangle) in triangles.iter().enumerate() {
        let Some(found) = candidate(index, Query::of(ray, triangle)) else { continue };
        let closer = match &best {
            None => true,
            Some(best) => compare(&found, best) == Ordering::Less,
        };
        if closer {
            best = Some(found);
        }
    }
    best.map(|best| (best.index, solve(&best.query)))
}

fn candidate(index: usize, query: Query) -> Option<Candidate> {
    let filtered = Filtered::of(&query);
    let class: Option<Class> = filtered.and_then(|f| f.class(query.t_min, query.t_max));
    if !class.unwrap_or_else(|| classify_in_integers(&query)).is_hit() {
        return None;
    }
    // Without a certain det nothing is known of t, and the comparison will be in integers.
    let (t, error) = filtered.map_or((0.0, f64::INFINITY), |f| f.distance());
    Some(Candidate { index, query, t, error })
}

fn compare(a: &Candidate, b: &Candidate) -> Ordering {
    let gap = a.t - b.t;
    // NaN and infinity fail this comparison and go on to the integers.
    if gap.abs() > 2.0 * (a.error + b.error) {
        return if gap < 0.0 { Ordering::Less } else { Ordering::Greater };
    }
    numerators(&a.query).compare_t_with(&numerators(&b.query))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::reference::{Quotient, reference};
    use crate::workload::Pcg;
    use glam::Vec3;

    fn point(pcg: &mut Pcg) -> Vec3 {
        let mut next = || pcg.below(5) as f32 - 2.0;
        Vec3::new(next(), next(), next())
    }

    fn scene(pcg: &mut Pcg) -> (Ray, Vec<Triangle>) {
        let (origin, direction) = (point(pcg), point(pcg));
        let end = origin + direction;
        let mut triangle = || Triangle { a: point(pcg), b: point(pcg), c: point(pcg) };
        let triangles = (0..12).map(|_| triangle()).collect();
        (Ray { origin, direction, end, t_min: 0.0, t_max: f32::MAX }, triangles)
    }

    fn compare_quotients(a: &Quotient, b: &Quotient) -> Ordering {
        (&a.numerator * &b.denominator).cmp(&(&b.numerator * &a.denominator))
    }

    /// By the reference: the first of the smallest quotients, and how many share it.
    fn expected(ray: &Ray, triangles: &[Triangle]) -> Option<(usize, usize)> {
        let hits: Vec<(usize, Quotient)> = (triangles.iter().enumerate())
            .map(|(index, triangle)| (index, reference(&Query::of(ray, triangle))))
            .filter(|(_, answer)| answer.class.is_hit())
            .filter_map(|(index, answer)| answer.values.map(|[t, ..]| (index, t)))
            .collect();
        let (index, least) = hits.iter().min_by(|a, b| compare_quotients(&a.1, &b.1))?;
        let ties = hits.iter().filter(|hit| compare_quotients(&hit.1, least) == Ordering::Equal);
        Some((*index, ties.count()))
    }

    #[test]
    fn the_nearest_is_the_references_and_ties_go_to_the_lowest() {
        let mut pcg = Pcg::new(1);
        let (mut single, mut tied, mut none) = (0, 0, 0);
        for _ in 0..2000 {
            let (ray, triangles) = scene(&mut pcg);
            let found = nearest(&ray, &triangles);
            let expected = expected(&ray, &triangles);
            assert_eq!(found.map(|(index, _)| index), expected.map(|(index, _)| index));
            if let Some((index, exact)) = found {
                assert!(exact.class.is_hit());
                assert_eq!(exact.t, solve(&Query::of(&ray, &triangles[index])).t);
            }
            match expected {
                None => none += 1,
                Some((_, 1)) => single += 1,
                Some(_) => tied += 1,
            }
        }
        assert!(single > 500 && tied > 80 && none > 500, "{single} {tied} {none}");
    }

    #[test]
    fn exact_ties_that_f64_rounds_apart_go_to_the_lowest() {
        let mut pcg = Pcg::new(2);
        let mut rounded_apart = 0;
        for _ in 0..300 {
            // Whole numbers of 20 bits: determinants of 60 bits, but every sum here is exact.
            let mut step = || (pcg.below(1 << 20) as f32) - (1 << 19) as f32;
            let mut vector = || Vec3::new(step(), step(), step());
            let (origin, direction) = (vector(), vector());
            let point = origin + direction * 2.0;
            let triangles: Vec<Triangle> = (0..4)
                .map(|_| {
                    // The point is a quarter of the way to b and half of it to c.
                    let (x, y) = (vector(), vector());
                    let a = point - x - y;
                    Triangle { a, b: a + x * 4.0, c: a + y * 2.0 }
                })
                .collect();
            let ray = Ray { origin, direction, end: point, t_min: 0.0, t_max: f32::MAX };
            let (index, exact) = nearest(&ray, &triangles).unwrap();
            assert_eq!((index, exact.t, exact.u, exact.v), (0, 2.0, 0.25, 0.5));
            let rounded = |triangle| Filtered::of(&Query::of(&ray, triangle)).unwrap().distance().0;
            let first = rounded(&triangles[0]);
            rounded_apart += usize::from(triangles.iter().any(|t| rounded(t) < first));
        }
        assert!(rounded_apart > 30, "{rounded_apart}");
    }

    #[test]
    fn distances_that_f64_cannot_tell_apart_are_told_apart() {
        // Two planes across the ray, the smallest subnormal apart, seen from 2^30.
        let far = (1u32 << 30) as f32;
        let ray = Ray {
            origin: Vec3::new(-far, 0.25, 0.25),
            direction: Vec3::X,
            end: Vec3::ZERO,
            t_min: 0.0,
            t_max: f32::MAX,
        };
        let at = |x: f32| Triangle {
            a: Vec3::new(x, 0.0, 0.0),
            b: Vec3::new(x, 1.0, 0.0),
            c: Vec3::new(x, 0.0, 1.0),
        };
        let (near, farther) = (at(0.0), at(f32::from_bits(1)));
        for (triangles, index) in [([near, farther], 0), ([farther, near], 1)] {
            let (found, exact) = nearest(&ray, &triangles).unwrap();
            assert_eq!((found, exact.t), (index, f64::from(far)));
        }
        assert_eq!(solve(&Query::of(&ray, &farther)).t, f64::from(far));
    }
}
