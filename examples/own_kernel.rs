//! Kernels of one's own beside ours: checked against the exact answer, then timed.
//!
//! `cargo run --release --example own_kernel` (with `--no-default-features` it builds sooner: nothing
//! of the command line is needed). Three versions of one test, as people write them by hand: a right
//! one, one that forgets that both weights together must stay below 1, and one that takes a small
//! determinant for that of a parallel ray, which no random pair gives away.

use ray_test::measure::{Order, Protocol};
use ray_test::number::Precision;
use ray_test::own::{
    Entrant, Hit, OwnError, OwnKernel, Ray, Triangle, contest_here, examinations, examine, outcome,
};

/// What is stored of a triangle: a vertex and two edges.
#[derive(Clone, Copy)]
struct Edges {
    a: [f32; 3],
    ab: [f32; 3],
    ac: [f32; 3],
}

#[inline]
fn minus(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn edges(triangle: &Triangle<f32>) -> Edges {
    let Triangle { a, b, c } = *triangle;
    Edges { a, ab: minus(b, a), ac: minus(c, a) }
}

/// Moeller and Trumbore's test. `PARALLEL` is a billionth of the determinant up to which a ray counts
/// as parallel; `SUM` is whether the weights of b and c may not be more than 1 together.
#[inline]
fn by_hand<const PARALLEL: u32, const SUM: bool>(
    ray: &Ray<f32>,
    edges: &Edges,
) -> Option<Hit<f32>> {
    let p = cross(ray.direction, edges.ac);
    let determinant = dot(edges.ab, p);
    if determinant.abs() <= PARALLEL as f32 * 1e-9 {
        return None;
    }
    let inverse = 1.0 / determinant;
    let s = minus(ray.origin, edges.a);
    let u = dot(s, p) * inverse;
    if !(0.0..=1.0).contains(&u) {
        return None;
    }
    let q = cross(s, edges.ab);
    let v = dot(ray.direction, q) * inverse;
    if !(0.0..=1.0).contains(&v) || (SUM && u + v > 1.0) {
        return None;
    }
    let t = dot(edges.ac, q) * inverse;
    (t >= ray.t_min && t <= ray.t_max).then_some(Hit { t, u, v })
}

/// As it should be.
struct ByHand;

impl OwnKernel for ByHand {
    const NAME: &'static str = "by-hand";
    type Number = f32;
    type Record = Edges;

    fn prepare(triangle: &Triangle<f32>) -> Edges {
        edges(triangle)
    }

    #[inline]
    fn test(ray: &Ray<f32>, record: &Edges) -> Option<Hit<f32>> {
        by_hand::<0, true>(ray, record)
    }
}

/// Finds hits in a parallelogram.
struct NoSum;

impl OwnKernel for NoSum {
    const NAME: &'static str = "no-sum";
    type Number = f32;
    type Record = Edges;

    fn prepare(triangle: &Triangle<f32>) -> Edges {
        edges(triangle)
    }

    #[inline]
    fn test(ray: &Ray<f32>, record: &Edges) -> Option<Hit<f32>> {
        by_hand::<0, false>(ray, record)
    }
}

/// Has the constant of many listings, 1e-6, whatever the size of the triangle.
struct Epsilon;

impl OwnKernel for Epsilon {
    const NAME: &'static str = "epsilon";
    type Number = f32;
    type Record = Edges;

    fn prepare(triangle: &Triangle<f32>) -> Edges {
        edges(triangle)
    }

    #[inline]
    fn test(ray: &Ray<f32>, record: &Edges) -> Option<Hit<f32>> {
        by_hand::<1000, true>(ray, record)
    }
}

fn main() -> Result<(), OwnError> {
    let entrants = [
        Entrant::own::<ByHand>(),
        Entrant::own::<Epsilon>(),
        Entrant::own::<NoSum>(),
        Entrant::ours("moller-trumbore", Precision::F32)?,
        Entrant::ours("wald", Precision::F32)?,
        Entrant::ours("woop-watertight", Precision::F32)?,
    ];
    println!("Against the exact answer ('fails at': the setting of a family's knob)\n");
    print!("{}", examinations(&examine(&entrants, 100, 1)?));
    println!("\nBeside our kernels\n");
    for order in [Order::Fixed, Order::Reshuffled] {
        println!("{}", outcome(&contest_here(&entrants, &Protocol::new(order, 1))?));
    }
    Ok(())
}
