//! Sum of angles: folklore; thesis H, 3.4.4.1, which warns of its inaccuracy.
//!
//! Formula: P = o + t d; the angles under which P sees the three edges, by arccos of the cosine of
//! each, add up to 2 pi inside and to less outside.
//! Tolerance: the rounding e of a cosine near -1 or 1 is an error of sqrt(2 e) of its angle; with
//! e = 4 roundings and three angles the sum is taken for 2 pi within 3 sqrt(8 unit roundoff).
//! Stored: the vertices. Operations of a hit: 45 x, 50 +-, 4 /, 6 square roots, 3 arccos; and 2 x with
//! 8 unary minuses on constants.
//! Known weakness: everything; wrong decisions near edges are its nature (status `inexact`), and it
//! yields no u and v. Single rays only, because arccos comes from `libm`.

use super::begun::in_one_piece;
use super::perpendicular_planes::point_on;
use super::{About, Corners, Kernel, PointTest, Source};
use crate::kernels::stored::plain_dot;
use crate::number::{Element, Real, Vec3, spread};
use crate::policy::{Found, Miss, Policy, Ray, Scale};

/// See the module's text. Its lanes are computed one by one.
pub struct AngleSum;

/// Corners and normal.
#[derive(Clone, Copy)]
pub struct Met<R> {
    corners: Corners<R>,
    n: Vec3<R>,
}

spread!(Met { corners, n });

impl Kernel for AngleSum {
    const ABOUT: About = About {
        id: "angle-sum",
        name: "Sum of angles",
        year: 2008,
        source: "folklore; thesis H, 3.4.4.1",
        setup: "none: three vertices",
        stored: "vertices",
        watertight: false,
        codes: &["det is 0", "t outside", "the angles do not add up"],
    };
    type Record<E: Element> = [E; 9];
    type Met<R: Real> = Met<R>;
    type Aim<R: Real> = ();

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 9] {
        corners.numbers()
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Met<T> {
        let corners = Corners::read(stored, 0);
        let (e1, e2) = corners.edges();
        Met { corners, n: P::cross(e1, e2) }
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    in_one_piece!();

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Met<R>,
        (): &(),
    ) -> Result<Found<R>, Miss> {
        let det = P::dot(ray.direction, tri.n);
        let hit = P::keep(P::divisible(det), 1)?;
        let (t, scale) = P::quotient(P::dot(tri.n, tri.corners.a - ray.origin), det);
        let hit = P::keep_range(hit, ray, t, scale, 2)?;
        let point = point_on::<P, R>(ray, t, scale);
        let hit = P::keep(hit & surrounded(&point, &tri.corners), 3)?;
        let one = Scale { factor: det.one(), one: det.one() };
        P::finish_apart(hit, ray, (t, scale), ([det.zero(), det.zero()], one))
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.n
    }
}

impl PointTest for AngleSum {
    #[inline(always)]
    fn contains<P: Policy, R: Real>(
        point: &Vec3<R>,
        tri: &Met<R>,
    ) -> Result<(R::Mask, R, R), Miss> {
        let hit = P::keep(surrounded(point, &tri.corners), 3)?;
        Ok((hit, point.x().zero(), point.x().zero()))
    }
}

/// Where the angles at `point` add up to a full turn, lane by lane.
#[inline(always)]
fn surrounded<R: Real>(point: &Vec3<R>, corners: &Corners<R>) -> R::Mask {
    let zero = R::Element::ZERO;
    let mut lanes = [[zero; WIDEST]; 12];
    let vectors = [*point, corners.a, corners.b, corners.c];
    for (vector, places) in vectors.iter().zip(lanes.chunks_exact_mut(3)) {
        for (component, place) in vector.0.into_iter().zip(places) {
            component.store(place);
        }
    }
    let mut within = [zero; WIDEST];
    for (lane, truth) in within.iter_mut().enumerate().take(R::LANES) {
        let at = |row: usize| Vec3([lanes[row][lane], lanes[row + 1][lane], lanes[row + 2][lane]]);
        let p = at(0);
        if turns_fully([at(3) - p, at(6) - p, at(9) - p]) {
            *truth = R::Element::ONE;
        }
    }
    R::load(point.x().token(), &within).ne(point.x().zero())
}

/// The widest packet that there is.
const WIDEST: usize = 16;

/// Whether the angles between three vectors add up to 2 pi, within the module's tolerance.
fn turns_fully<E: Element>([a, b, c]: [Vec3<E>; 3]) -> bool {
    let sum = angle(b, c) + angle(c, a) + angle(a, b);
    let full = (-E::ONE).acos() + (-E::ONE).acos();
    let short = full - sum;
    let tolerance = E::from_f32(3.0) * (E::from_f32(8.0) * E::UNIT_ROUNDOFF).sqrt();
    short.signed_by(short).le(tolerance)
}

fn angle<E: Element>(a: Vec3<E>, b: Vec3<E>) -> E {
    let cosine = plain_dot(a, b) / (plain_dot(a, a).sqrt() * plain_dot(b, b).sqrt());
    // Rounding can leave [-1, 1], where there is no angle.
    let cosine = E::select(cosine.gt(E::ONE), E::ONE, cosine);
    E::select(cosine.lt(-E::ONE), -E::ONE, cosine).acos()
}
