//! Shevtsov-Soupikov-Kapustin: "Ray-Triangle Intersection Algorithm for Modern CPU
//! Architectures", GraphiCon 2007; the seed note of Len3d (2010); thesis H, 3.3.3.
//!
//! Formula, along the axis w of n's largest component, (u, v) the next two in the cycle, all of n
//! divided by n_w: det = -(d_u n_u + d_v n_v + d_w), t' = o_u n_u + o_v n_v + o_w - n . a,
//! D_k = d_k t' - (a_k - o_k) det for k = u, v, u' = e2_v D_u - e2_u D_v, v' = e1_u D_v - e1_v D_u.
//! The note's (16) and (17) are misprinted; its code is cyclic and has no (-1)^w, as here.
//! Stored: the note's TriAccel, 12 words (48 bytes in f32). Operations of a hit, divided first: 10 x,
//! 12 +-, 1 unary minus, 1 /; divided last 16 x.
//! Known weakness: the plane's constant cancels far from the origin; slivers lose u and v twice.
//! The note's det = 0 gives a NaN t that passes its range test; here det is tested.

use super::stored::{plain_cross, plain_dot};
use super::{About, Corners, Kernel};
use crate::number::{Axis, Element, Real, Vec3, dominant};
use crate::policy::{BothFaces, Facing, Found, Miss, Policy, Ray};

/// See the module's text.
pub struct Shevtsov;

/// The note's TriAccel.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct TriAccel<E> {
    /// Axis of projection; the two behind it in the cycle are u and v.
    pub w: u32,
    /// Index of the triangle (the note stores it; a batch counts for itself).
    pub triangle: u32,
    /// Carries the sign of n_w, for culling.
    pub nw: E,
    /// n . a / n_w
    pub np: E,
    /// n_u / n_w and n_v / n_w
    pub n: [E; 2],
    /// a_u and a_v
    pub a: [E; 2],
    /// (b - a) / n_w along u and v
    pub e1: [E; 2],
    /// (c - a) / n_w along u and v
    pub e2: [E; 2],
}

/// The record in lanes.
#[derive(Clone, Copy)]
pub struct Met<R: Real> {
    w: Axis<R::Mask>,
    nw: R,
    normal: Vec3<R>,
    np: R,
    n: [R; 2],
    a: [R; 2],
    e1: [R; 2],
    e2: [R; 2],
}

impl Kernel for Shevtsov {
    const ABOUT: About = About {
        id: "shevtsov",
        name: "Shevtsov-Soupikov-Kapustin",
        year: 2007,
        source: "Shevtsov, Soupikov and Kapustin, GraphiCon 2007",
        setup: "projected plane, vertex and edges (TriAccel)",
        stored: "precomputed",
        watertight: false,
        codes: &["det is 0, or a back face when culled", "t outside", "u, v or u + v outside"],
    };
    type Record<E: Element> = TriAccel<E>;
    type Met<R: Real> = Met<R>;
    type Aim<R: Real> = ();

    fn prepare<E: Element>(corners: &Corners<E>) -> TriAccel<E> {
        let (e1, e2) = corners.edges();
        let n = plain_cross(e1, e2);
        let w = dominant(n);
        let [iw, iu, iv] = cycle(w);
        let inverse = E::ONE / n.0[iw];
        let scaled = n.scaled(inverse);
        let plane = Vec3([scaled.0[iu], scaled.0[iv], E::ONE]);
        let a = Vec3([corners.a.0[iu], corners.a.0[iv], corners.a.0[iw]]);
        TriAccel {
            w,
            triangle: 0,
            nw: E::ONE.signed_by(n.0[iw]),
            np: plain_dot(plane, a),
            n: [scaled.0[iu], scaled.0[iv]],
            a: [corners.a.0[iu], corners.a.0[iv]],
            e1: [e1.0[iu] * inverse, e1.0[iv] * inverse],
            e2: [e2.0[iu] * inverse, e2.0[iv] * inverse],
        }
    }

    #[inline(always)]
    fn meet<P: Policy, R: Real>(token: R::Token, record: &TriAccel<R::Element>) -> Met<R> {
        let plane = [record.n[0], record.n[1], R::Element::ONE];
        let normal = unprojected(Axis::stored(record.w), plane, record.nw);
        Met {
            w: Axis::stored(record.w),
            nw: R::splat(token, record.nw),
            normal: Vec3::splat(token, normal),
            np: R::splat(token, record.np),
            n: pair::<R>(token, record.n),
            a: pair::<R>(token, record.a),
            e1: pair::<R>(token, record.e1),
            e2: pair::<R>(token, record.e2),
        }
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    #[inline(always)]
    fn test<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Met<R>) -> Result<Found<R>, Miss> {
        let (u, v) = (tri.w.next(), tri.w.next().next());
        let (o, d) = (&ray.origin, &ray.direction);
        let det = -height::<P, R>(d, tri);
        let mut divisible = BothFaces::<P>::divisible(det);
        if P::Facing::CULLS {
            divisible = divisible & det.signed_by(tri.nw).gt(det.zero());
        }
        let hit = P::keep(divisible, 1)?;
        let (t, scale) = BothFaces::<P>::quotient(height::<P, R>(o, tri) - tri.np, det);
        let hit = P::keep_range(hit, ray, t, scale, 2)?;
        let du = P::multiply_add(u.pick(d), t, P::scaled(u.pick(o) - tri.a[0], scale));
        let dv = P::multiply_add(v.pick(d), t, P::scaled(v.pick(o) - tri.a[1], scale));
        let beta = P::difference(tri.e2[1], du, tri.e2[0], dv);
        let gamma = P::difference(tri.e1[0], dv, tri.e1[1], du);
        let hit = P::keep(hit & P::inside(beta, gamma, scale), 3)?;
        P::finish(hit, ray, [t, beta, gamma], scale)
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.normal
    }
}

/// Two numbers, each in every lane.
#[inline(always)]
pub fn pair<R: Real>(token: R::Token, [first, second]: [R::Element; 2]) -> [R; 2] {
    [R::splat(token, first), R::splat(token, second)]
}

/// p_u n_u + p_v n_v + p_w
#[inline(always)]
fn height<P: Policy, R: Real>(p: &Vec3<R>, tri: &Met<R>) -> R {
    let (u, v) = (tri.w.next(), tri.w.next().next());
    P::multiply_add(v.pick(p), tri.n[1], P::multiply_add(u.pick(p), tri.n[0], tri.w.pick(p)))
}

/// The axis `w` and the two behind it in the cycle.
pub fn cycle(w: u32) -> [usize; 3] {
    let w = w as usize;
    [w, (w + 1) % 3, (w + 2) % 3]
}

/// The vector with components (u, v, w) along the axes of a projection, its sign that of `sign`.
/// Of scalars, before they are broadcast: picking from what is computed goes through memory.
#[inline(always)]
pub fn unprojected<E: Element>(w: Axis<bool>, [pu, pv, pw]: [E; 3], sign: E) -> Vec3<E> {
    // Read backwards along the cycle: with w = x, (u, v) = (y, z), so x = pw, y = pu, z = pv.
    let x = w.pick(&Vec3([pw, pv, pu]));
    let y = w.pick(&Vec3([pu, pw, pv]));
    let z = w.pick(&Vec3([pv, pu, pw]));
    Vec3([x.signed_by(sign), y.signed_by(sign), z.signed_by(sign)])
}
