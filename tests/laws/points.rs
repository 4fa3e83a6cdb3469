//! Law 2 for the point tests: is a point of the triangle's plane in the triangle?

use std::collections::BTreeMap;

use ray_test::kernels::{
    BadouelCramer, Corners, HalfSpaces, Keidy, PointTest, SignedAreas, Vertices, WithNormal,
};
use ray_test::number::{Element, Real, Vec3};
use ray_test::policy::{
    Between, Compare, Distance, Early, First, Form, Full, Fused, Last, Plain, Policy, SignBits,
    Tuv, TwoSided,
};

use super::cases;
use super::exact::{Exact, reset};
use super::forms::{Answer, same};
use super::reference::{Meeting, meeting};

type Run = fn(&Vec3<Exact>, &Corners<Exact>) -> Answer;

/// A point test in one form; `open` if points with u + v = 1 are outside.
struct Held {
    id: &'static str,
    open: bool,
    run: Run,
}

fn run<K: PointTest, P: Policy>(point: &Vec3<Exact>, corners: &Corners<Exact>) -> Answer {
    let met = K::meet::<P, Exact>((), &K::prepare(corners));
    match K::contains::<P, Exact>(point, &met) {
        Ok((true, u, v)) => Some([Exact::ZERO, u, v]),
        _ => None,
    }
}

fn closed<K: PointTest>(held: &mut Vec<Held>) {
    type Of<E, D, A> = Form<E, D, A, Tuv, TwoSided, Compare, Distance, Between>;
    let runs: [Run; 8] = [
        run::<K, Of<Early, First, Plain>>,
        run::<K, Of<Early, First, Fused>>,
        run::<K, Of<Early, Last, Plain>>,
        run::<K, Of<Early, Last, Fused>>,
        run::<K, Of<Full, First, Plain>>,
        run::<K, Of<Full, First, Fused>>,
        run::<K, Of<Full, Last, Plain>>,
        run::<K, Of<Full, Last, Fused>>,
    ];
    held.extend(runs.map(|run| Held { id: K::ABOUT.id, open: false, run }));
}

/// The sum of angles is absent, as it is from the kernels: it needs arc cosines.
fn all() -> Vec<Held> {
    type Published<E> = Form<E, Last, Plain, Tuv, TwoSided, SignBits, Distance, Between>;
    let mut held = Vec::new();
    closed::<Keidy<Vertices>>(&mut held);
    closed::<Keidy<WithNormal>>(&mut held);
    closed::<BadouelCramer>(&mut held);
    closed::<HalfSpaces>(&mut held);
    closed::<SignedAreas>(&mut held);
    // Text 1 is strict in u + v < 1.
    let keidy = "keidy by sign bits";
    held.push(Held { id: keidy, open: true, run: run::<Keidy<Vertices>, Published<Early>> });
    held.push(Held { id: keidy, open: true, run: run::<Keidy<Vertices>, Published<Full>> });
    held
}

/// The point's weights by elimination along any direction that is not in the plane.
fn weights(point: Vec3<Exact>, corners: &Corners<Exact>) -> Option<[Exact; 3]> {
    let (zero, one) = (Exact::ZERO, Exact::ONE);
    for axis in 0..3 {
        let direction = Vec3(std::array::from_fn(|i| if i == axis { one } else { zero }));
        let ray = ray_test::policy::Ray {
            origin: point,
            direction,
            end: point,
            t_min: zero,
            t_max: zero,
        };
        if let Meeting::Point(found) = meeting(&ray, corners) {
            assert!(found.t.is_zero(), "the point is in the plane");
            return Some(found.weights);
        }
    }
    None
}

#[test]
fn point_tests_agree_with_exact_weights() {
    let held = all();
    let mut yields: BTreeMap<&str, usize> = BTreeMap::new();
    for (i, case) in cases::lattice(1500, 4).iter().enumerate() {
        let corners = case.triangle();
        let (e1, e2) = corners.edges();
        let quarter = |n: usize| Exact::of((n % 6) as f64 / 4.0 - 0.25);
        let point = corners.a + e1.scaled(quarter(i)) + e2.scaled(quarter(i / 6));
        let weights = weights(point, &corners);
        let inside = weights.filter(|weights| weights.iter().all(|w| w.ge(Exact::ZERO)));
        let class = match (weights, inside) {
            (None, _) => "degenerate",
            (_, None) => "outside",
            (_, Some(w)) => {
                ["interior", "edge", "vertex"][w.iter().filter(|w| w.is_zero()).count()]
            }
        };
        *yields.entry(class).or_default() += 1;
        for Held { id, open, run } in &held {
            let wanted =
                inside.filter(|w| !(*open && w[0].is_zero())).map(|[_, u, v]| [Exact::ZERO, u, v]);
            let found = run(&point, &corners);
            assert!(
                same(&found, &wanted),
                "{id} {class}: {found:?}, expected {wanted:?}, {case:?}"
            );
        }
        reset();
    }
    println!("{yields:?}, {} forms", held.len());
    for class in ["degenerate", "outside", "interior", "edge", "vertex"] {
        assert!(yields[class] >= 50, "{yields:?}");
    }
}
