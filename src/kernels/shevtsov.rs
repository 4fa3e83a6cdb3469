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
use super::{About, Begun, Corners, Kernel, Source};
use crate::number::{Axis, Element, Real, Vec3, dominant, spread};
use crate::policy::{BothFaces, Facing, Found, Miss, Policy, Ray};

/// See the module's text.
pub struct Shevtsov;

/// The note's TriAccel. In the record: the axis w (the two behind it in the cycle are u and v), an
/// unused word (the note's index of the triangle; a batch counts for itself), the sign of n_w, for
/// culling, and n . a / n_w; then, each along u and v, n / n_w, a, (b - a) / n_w and (c - a) / n_w.
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

spread!(Met { w, nw, normal, np, n, a, e1, e2 });

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
    type Record<E: Element> = [E; 12];
    type Met<R: Real> = Met<R>;
    type Aim<R: Real> = ();
    type Begun<R: Real> = Begun<R>;

    fn prepare<E: Element>(corners: &Corners<E>) -> [E; 12] {
        let (e1, e2) = corners.edges();
        let n = plain_cross(e1, e2);
        let w = dominant(n);
        let [iw, iu, iv] = cycle(w);
        let inverse = E::ONE / n.0[iw];
        let scaled = n.scaled(inverse);
        let plane = Vec3([scaled.0[iu], scaled.0[iv], E::ONE]);
        let a = Vec3([corners.a.0[iu], corners.a.0[iv], corners.a.0[iw]]);
        let (e1, e2) = (e1.scaled(inverse), e2.scaled(inverse));
        let [n_u, n_v] = [scaled.0[iu], scaled.0[iv]];
        let [e1_u, e1_v, e2_u, e2_v] = [e1.0[iu], e1.0[iv], e2.0[iu], e2.0[iv]];
        let (index, sign, height) =
            (E::from_index(w), E::ONE.signed_by(n.0[iw]), plain_dot(plane, a));
        [index, E::ZERO, sign, height, n_u, n_v, a.x(), a.y(), e1_u, e1_v, e2_u, e2_v]
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Met<T> {
        let (w, nw, n) = (stored.axis(0), stored.number(2), stored.pair(4));
        Met {
            w,
            nw,
            normal: unprojected(w, [n[0], n[1], nw.one()], nw),
            np: stored.number(3),
            n,
            a: stored.pair(6),
            e1: stored.pair(8),
            e2: stored.pair(10),
        }
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    #[inline(always)]
    fn begin<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Met<R>) -> Result<Begun<R>, Miss> {
        let det = -height::<P, R>(&ray.direction, tri);
        let mut divisible = BothFaces::<P>::divisible(det);
        if P::Facing::CULLS {
            divisible = divisible & det.signed_by(tri.nw).gt(det.zero());
        }
        let hit = P::keep(divisible, 1)?;
        let height = height::<P, R>(&ray.origin, tri);
        let (t, scale) = BothFaces::<P>::quotient(height - tri.np, det);
        let hit = P::keep_range(hit, ray, t, scale, 2)?;
        Ok(Begun::new::<P>(hit, t, scale))
    }

    #[inline(always)]
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        (): &(),
        tri: &Met<R>,
        begun: &Begun<R>,
    ) -> Result<Found<R>, Miss> {
        let Begun { hit, t, scale, .. } = *begun;
        let (u, v) = (tri.w.next(), tri.w.next().next());
        let (o, d) = (&ray.origin, &ray.direction);
        let du = P::multiply_add(u.pick(d), t, P::scaled(u.pick(o) - tri.a[0], scale));
        let dv = P::multiply_add(v.pick(d), t, P::scaled(v.pick(o) - tri.a[1], scale));
        let beta = P::difference(tri.e2[1], du, tri.e2[0], dv);
        let gamma = P::difference(tri.e1[0], dv, tri.e1[1], du);
        let hit = P::keep(P::inside(hit, beta, gamma, scale), 3)?;
        begun.finish::<P>(hit, ray, [t, beta, gamma])
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.normal
    }
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
pub fn unprojected<R: Real>(w: Axis<R::Mask>, [pu, pv, pw]: [R; 3], sign: R) -> Vec3<R> {
    // Read backwards along the cycle: with w = x, (u, v) = (y, z), so x = pw, y = pu, z = pv.
    let x = w.pick(&Vec3([pw, pv, pu]));
    let y = w.pick(&Vec3([pu, pw, pv]));
    let z = w.pick(&Vec3([pv, pu, pw]));
    Vec3([x.signed_by(sign), y.signed_by(sign), z.signed_by(sign)])
}
