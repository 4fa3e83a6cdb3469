//! Law 2: kernels agree with geometry, boundaries included.

use std::collections::BTreeMap;

use ray_test::kernels::Corners;
use ray_test::number::{Element, Real, dominant};
use ray_test::policy::Ray;

use super::cases::{self, Case};
use super::exact::{Exact, reset};
use super::forms::{Answer, Group, groups, same};
use super::reference::{Meeting, Point, determinant, facing, meeting, normal};

/// What a sign-bit form reports where everything is zero: a hit, and no values.
const NOTHING: Answer = Some([Exact::UNDEFINED; 3]);

/// What a case is to a group.
struct Asked<'a> {
    group: &'a Group,
    case: &'a Case,
    ray: Ray<Exact>,
    corners: Corners<Exact>,
}

impl Asked<'_> {
    /// The answer by the group's convention.
    fn expected(&self) -> Answer {
        match (self.group.tests, self.group.kernel) {
            ("compare" | "sign-bits-safe", _) => self.closed(),
            ("products", "chirkov") => self.products(),
            ("sign-bits", "keidy") => self.keidy(),
            ("sign-bits", _) => self.sign_bits(),
            other => panic!("no expectation for {other:?}"),
        }
    }

    /// The law: the closed triangle and the closed range; with culling, of front faces only.
    fn closed(&self) -> Answer {
        let point = meeting(&self.ray, &self.corners).in_triangle()?;
        let seen = !self.group.culls || facing(&self.ray, &self.corners).lt(Exact::ZERO);
        answer(&point, seen && self.in_range(point.t, false) && self.on_segment(point.t))
    }

    /// Chirkov's `>=` on AC and `<` on BC: closed where u = 0, open where v = 0 or w = 0.
    fn products(&self) -> Answer {
        let point = meeting(&self.ray, &self.corners).in_triangle()?;
        let [w, _, v] = point.weights;
        let inside = !w.is_zero() && !v.is_zero();
        answer(&point, inside && self.in_range(point.t, false) && self.on_segment(point.t))
    }

    /// Text 1: u >= 0, v >= 0, u + v < 1. The range is compared by sign bits, the determinant being
    /// direction . (AB x CA), which is positive for front faces. A zero determinant makes u + v - 1
    /// zero, too, which is not negative: a miss.
    fn keidy(&self) -> Answer {
        let point = meeting(&self.ray, &self.corners).in_triangle()?;
        let back = facing(&self.ray, &self.corners).gt(Exact::ZERO);
        answer(&point, !point.weights[0].is_zero() && self.in_range(point.t, back))
    }

    /// Sign bits are compared without a flip, and that of 0 says "not negative": with a positive
    /// scale all bounds are closed, with a negative one they are open. Where the scale is 0, a hit
    /// is reported if every numerator is 0.
    fn sign_bits(&self) -> Answer {
        let point = match meeting(&self.ray, &self.corners) {
            Meeting::Degenerate => return self.degenerate(),
            Meeting::Coplanar => return NOTHING,
            meeting => meeting.in_triangle()?,
        };
        let [range_negative, inside_negative] = self.negative_scales();
        let open = inside_negative && point.weights.iter().any(|w| w.is_zero());
        answer(&point, !open && self.in_range(point.t, range_negative))
    }

    /// Without a plane every scale is 0. Moeller-Trumbore and Kensler-Shirley have the numerators
    /// of u and v left, Badouel-Cramer none; the others have prepared a division by 0.
    fn degenerate(&self) -> Answer {
        let (e1, e2) = self.corners.edges();
        let s = self.ray.origin - self.corners.a;
        let nothing_left = match self.group.kernel {
            "moller-trumbore" | "kensler-shirley" => {
                [e1, e2].into_iter().all(|edge| determinant(self.ray.direction, s, edge).is_zero())
            }
            "badouel-cramer" => true,
            _ => false,
        };
        if nothing_left { NOTHING } else { None }
    }

    /// Whether the scales of t and of u and v are negative, by each kernel's own determinant.
    fn negative_scales(&self) -> [bool; 2] {
        let towards = facing(&self.ray, &self.corners);
        let n = normal(&self.corners);
        let along_axis = towards * n.0[dominant(n) as usize];
        let scales = match self.group.kernel {
            "moller-trumbore" | "kensler-shirley" => [-towards, -towards],
            "perpendicular-planes" => [towards, towards],
            "wald" => [along_axis, along_axis],
            "shevtsov" => [-along_axis, -along_axis],
            "badouel-cramer" => [towards, along_axis],
            other => panic!("no determinant for {other}"),
        };
        scales.map(|scale| scale.lt(Exact::ZERO))
    }

    /// The closed range of t. `negative`: by sign bits under a negative scale, where 0 counts with
    /// the other side: open, except that an empty inside (t at both bounds) passes.
    fn in_range(&self, t: Exact, negative: bool) -> bool {
        let (lower, upper) = (Exact::of(self.case.lower(self.group.from_zero)), self.ray.t_max);
        if negative {
            (t.gt(lower) && t.lt(upper)) || (t.le(lower) && t.ge(upper))
        } else {
            t.ge(lower) && t.le(upper)
        }
    }

    /// Chirkov judges the segment as well.
    fn on_segment(&self, t: Exact) -> bool {
        self.group.kernel != "chirkov" || (t.ge(Exact::ZERO) && t.le(Exact::of(self.case.stretch)))
    }
}

fn answer(point: &Point, hit: bool) -> Answer {
    hit.then_some([point.t, point.weights[1], point.weights[2]])
}

/// The first form of every group against its expectation; the others follow by law 1.
#[test]
fn kernels_agree_in_exact_arithmetic() {
    let groups = groups();
    // Per convention: answers equal to the law's, and answers that differ from it.
    let mut tally: BTreeMap<String, [usize; 3]> = BTreeMap::new();
    for case in cases::all() {
        for group in &groups {
            let (ray, corners) = (case.ray(group.from_zero), case.triangle());
            let asked = Asked { group, case: &case, ray, corners };
            let (found, expected) = (group.forms[0].1(&ray, &corners), asked.expected());
            assert!(
                same(&found, &expected),
                "{} {} {} cull {} from zero {}: {found:?}, expected {expected:?}, {case:?}",
                group.kernel,
                group.stored,
                group.tests,
                group.culls,
                group.from_zero,
            );
            let row = tally.entry(format!("{} {}", group.kernel, group.tests)).or_default();
            row[0] += usize::from(found.is_some());
            row[1] += usize::from(found.is_none());
            row[2] += usize::from(!same(&found, &asked.closed()));
            reset();
        }
    }
    for (convention, [hits, misses, differ]) in &tally {
        println!("{convention}: {hits} hits, {misses} misses, {differ} against the law");
        assert!(*hits >= 200 && *misses >= 200, "{convention}");
        // A convention of its own must show, or the cases do not test it.
        let is_law = ["compare", "sign-bits-safe"].iter().any(|tests| convention.ends_with(tests));
        assert_eq!(*differ > 0, !is_law, "{convention}");
    }
}
