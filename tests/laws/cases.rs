//! Cases that meet every class plentifully, with numbers that f64 holds exactly.

use std::collections::BTreeMap;

use ray_test::kernels::Corners;
use ray_test::number::Vec3;
use ray_test::oracle::{Class, Query, classify};
use ray_test::policy::Ray;
use ray_test::workload::Pcg;

use super::exact::{Exact, reset};
use super::reference::meeting;

/// One ray and one triangle.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Where t = 0.
    pub origin: [f64; 3],
    /// Direction; of any length, zero included.
    pub direction: [f64; 3],
    /// The segment's end is at this t, exactly.
    pub stretch: f64,
    /// Smallest t that counts.
    pub t_min: f64,
    /// Largest t that counts.
    pub t_max: f64,
    /// Vertices.
    pub corners: [[f64; 3]; 3],
}

impl Case {
    /// As kernels take it; with `from_zero`, t_min is one that a kernel must not look at.
    pub fn ray(&self, from_zero: bool) -> Ray<Exact> {
        let (origin, direction) = (vector(self.origin), vector(self.direction));
        Ray {
            origin,
            direction,
            end: origin + direction.scaled(Exact::of(self.stretch)),
            t_min: if from_zero { Exact::UNDEFINED } else { Exact::of(self.t_min) },
            t_max: Exact::of(self.t_max),
        }
    }

    /// The smallest t that counts.
    pub fn lower(&self, from_zero: bool) -> f64 {
        if from_zero { 0.0 } else { self.t_min }
    }

    /// As kernels take it.
    pub fn triangle(&self) -> Corners<Exact> {
        let [a, b, c] = self.corners.map(vector);
        Corners { a, b, c }
    }

    /// As the oracle takes it.
    pub fn query(&self, from_zero: bool) -> Query {
        Query {
            origin: self.origin,
            direction: self.direction,
            end: None,
            triangle: self.corners,
            t_min: self.lower(from_zero),
            t_max: self.t_max,
        }
    }
}

fn vector(v: [f64; 3]) -> Vec3<Exact> {
    Vec3(v.map(Exact::of))
}

fn pick<T: Copy>(draw: &mut Pcg, from: &[T]) -> T {
    from[draw.below(from.len() as u64) as usize]
}

/// Small integers, so that edges, vertices, parallel rays and triangles without area come by
/// themselves. Every second ray is aimed at a quarter-integer combination of the corners.
pub fn lattice(count: usize, seed: u64) -> Vec<Case> {
    let mut draw = Pcg::new(seed);
    let mut integers = |low: i32, count: u64| -> [f64; 3] {
        std::array::from_fn(|_| f64::from(low + draw.below(count) as i32))
    };
    let mut cases = Vec::new();
    for i in 0..count {
        let corners = [integers(0, 3), integers(0, 3), integers(0, 3)];
        let (origin, free) = (integers(-1, 5), integers(-2, 5));
        let aimed = i % 2 == 1;
        let [m, n, _] = integers(-1, 6);
        let [x, y, z] = integers(0, 4).map(|x| x as usize);
        let length = [0.5, 1.0, 1.0, 2.0][(x + y + z) % 4];
        let direction = if aimed {
            at(&corners, m / 4.0, n / 4.0, |j, p| (p - origin[j]) * length)
        } else {
            free
        };
        cases.push(Case {
            origin,
            direction,
            stretch: [0.5, 1.0, 2.0, 4.0][x],
            t_min: [0.0, 0.5, 1.0, -1.0][y],
            t_max: [1.0, 2.0, 4.0, f64::MAX][z],
            corners,
        });
    }
    cases
}

/// Multiples of 2^-24 in the unit cube. Every second ray is aimed at a quarter-integer combination
/// of the corners: a multiple of 2^-26, so all numbers stay exact in f64.
pub fn random(count: usize, seed: u64) -> Vec<Case> {
    let mut draw = Pcg::new(seed);
    let mut cases = Vec::new();
    for i in 0..count {
        let mut point = || -> [f64; 3] {
            std::array::from_fn(|_| draw.below(1 << 24) as f64 / f64::from(1u32 << 24))
        };
        let corners = [point(), point(), point()];
        let (origin, free) = (point(), point());
        let direction = if i % 2 == 1 {
            let u = draw.below(5) as f64;
            let v = draw.below(6 - u as u64) as f64;
            at(&corners, u / 4.0, v / 4.0, |j, p| p - origin[j])
        } else {
            std::array::from_fn(|j| free[j] - origin[j])
        };
        cases.push(Case {
            origin,
            direction,
            stretch: pick(&mut draw, &[0.5, 1.0, 2.0]),
            t_min: pick(&mut draw, &[-1.0, 0.0, 0.25, 1.0]),
            t_max: pick(&mut draw, &[1.0, 2.0, f64::MAX]),
            corners,
        });
    }
    cases
}

/// `apply` of every component of a + u (b - a) + v (c - a).
fn at([a, b, c]: &[[f64; 3]; 3], u: f64, v: f64, apply: impl Fn(usize, f64) -> f64) -> [f64; 3] {
    std::array::from_fn(|j| apply(j, a[j] + u * (b[j] - a[j]) + v * (c[j] - a[j])))
}

/// What the tests of kernels run on.
pub fn all() -> Vec<Case> {
    let mut cases = lattice(3000, 1);
    cases.extend(random(160, 2));
    cases
}

/// How many cases fall into each class, with elimination and oracle in agreement about every one.
fn yields(cases: &[Case]) -> BTreeMap<&'static str, usize> {
    let mut yields = BTreeMap::new();
    for case in cases {
        for from_zero in [true, false] {
            let meeting = meeting(&case.ray(from_zero), &case.triangle());
            let class = meeting.class(Exact::of(case.lower(from_zero)), Exact::of(case.t_max));
            assert_eq!(class, classify(&case.query(from_zero)), "{case:?}");
            if !from_zero {
                *yields.entry(class.name()).or_default() += 1;
                let point = meeting.in_triangle();
                let bound = [Exact::of(case.t_min), Exact::of(case.t_max)];
                let on_bound = point.is_some_and(|p| bound.iter().any(|&b| p.t.same(b)));
                *yields.entry("t at a bound").or_default() += usize::from(on_bound);
                let still = case.direction == [0.0; 3];
                *yields.entry("zero direction").or_default() += usize::from(still);
            }
            reset();
        }
    }
    yields
}

#[test]
fn cases_meet_every_class_and_elimination_agrees_with_the_oracle() {
    let found = yields(&lattice(3000, 1));
    println!("lattice: {found:?}");
    for class in Class::ALL {
        assert!(found[class.name()] >= 50, "{class:?}: {found:?}");
    }
    assert!(found["t at a bound"] >= 100 && found["zero direction"] >= 5, "{found:?}");

    let found = yields(&random(160, 2));
    println!("random: {found:?}");
    for class in [Class::Interior, Class::Edge, Class::Vertex, Class::Outside, Class::Behind] {
        assert!(found[class.name()] >= 3, "{class:?}: {found:?}");
    }
    assert!(found["t at a bound"] >= 10, "{found:?}");
}
