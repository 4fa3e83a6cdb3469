//! Wald: I. Wald, "Realtime Ray Tracing and Interactive Global Illumination", PhD thesis,
//! Saarland University, 2004; thesis H, 3.4.2 and 4.3.4.
//!
//! Formula, along the axis w of n's largest component, (u, v) the next two in the cycle, all of n
//! divided by n_w: t = (n . a - o_w - n_u o_u - n_v o_v) / (d_w + n_u d_u + n_v d_v), P = o + t d,
//! beta = P_u b_u + P_v b_v + b_d, gamma = P_u c_u + P_v c_v + c_d.
//! Stored: 10 words, 12 with padding (48 bytes in f32). Operations of a hit, divided first:
//! 10 x, 12 +-, 1 /; divided last 18 x (15 before the last test).
//! Known weakness: the plane's constant cancels far from the origin; slivers lose u and v twice.

use std::marker::PhantomData;

use super::perpendicular_planes::planes;
use super::projection::{OneIndex, Projection};
use super::shevtsov::{cycle, unprojected};
use super::stored::{plain_cross, plain_dot};
use super::{About, Begun, Corners, Kernel, Source};
use crate::number::{Axis, Element, Real, Vec3, spread};
use crate::policy::{Found, Miss, Policy, Ray, Scale};

/// See the module's text. `X` says how the axis of the projection is known.
pub struct Wald<X = OneIndex>(PhantomData<X>);

/// TriAccel: three times three constants and a word of padding each. In the record: n_u / n_w,
/// n_v / n_w, n . a / n_w and the axis w; b_u, b_v, b_d and the sign of n_w (the original leaves that
/// word unused); c_u, c_v, c_d and an unused word.
#[derive(Clone, Copy)]
pub struct Met<R: Real> {
    w: Axis<R::Mask>,
    u: Axis<R::Mask>,
    v: Axis<R::Mask>,
    n: Vec3<R>,
    b: Vec3<R>,
    c: Vec3<R>,
    normal: Vec3<R>,
}

spread!(Met { w, u, v, n, b, c, normal });

impl<X: Projection> Kernel for Wald<X> {
    const ABOUT: About = About {
        id: "wald",
        name: "Wald",
        year: 2004,
        source: "Wald, PhD thesis, Saarland University, 2004",
        setup: "projected plane and two lines (TriAccel)",
        stored: "precomputed",
        watertight: false,
        codes: &["det is 0", "t outside", "u, v or u + v outside"],
    };
    type Record<E: Element> = X::Record<E>;
    type Met<R: Real> = Met<R>;
    type Aim<R: Real> = ();
    type Begun<R: Real> = Begun<R>;

    fn prepare<E: Element>(corners: &Corners<E>) -> X::Record<E> {
        let (ab, ac) = corners.edges();
        let n = plain_cross(ab, ac);
        let w = X::axis(n);
        let [iw, iu, iv] = cycle(w);
        // |AB_u AC_u; AB_v AC_v| is n_w itself.
        let inverse = E::ONE / n.0[iw];
        let plane = Vec3([n.0[iu] * inverse, n.0[iv] * inverse, E::ONE]);
        let a = Vec3([corners.a.0[iu], corners.a.0[iv], corners.a.0[iw]]);
        let (au, av) = (a.x(), a.y());
        let b = Vec3([ac.0[iv], -ac.0[iu], av * ac.0[iu] - au * ac.0[iv]]).scaled(inverse);
        let c = Vec3([-ab.0[iv], ab.0[iu], au * ab.0[iv] - av * ab.0[iu]]).scaled(inverse);
        let plane = Vec3([plane.x(), plane.y(), plain_dot(plane, a)]);
        let sign = E::ONE.signed_by(n.0[iw]);
        X::record(planes([(plane, E::from_index(w)), (b, sign), (c, E::ZERO)]))
    }

    #[inline(always)]
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Met<T> {
        let ([w, u, v], n, nw) = (X::axes(stored), stored.vector(0), stored.number(7));
        let normal = unprojected(w, [n.x(), n.y(), nw.one()], nw);
        Met { w, u, v, n, b: stored.vector(4), c: stored.vector(8), normal }
    }

    #[inline(always)]
    fn aim<P: Policy, R: Real>(_: &Ray<R>) {}

    #[inline(always)]
    fn begin<P: Policy, R: Real>(ray: &Ray<R>, (): &(), tri: &Met<R>) -> Result<Begun<R>, Miss> {
        let det = tri.along::<P>(&ray.direction);
        let hit = P::keep(P::divisible(det), 1)?;
        let (t, scale) = P::quotient(tri.n.z() - tri.along::<P>(&ray.origin), det);
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
        let (u, v) = (tri.u, tri.v);
        let (o, d) = (&ray.origin, &ray.direction);
        let pu = P::along(u.pick(o), u.pick(d), t, scale);
        let pv = P::along(v.pick(o), v.pick(d), t, scale);
        let beta = share::<P, R>(pu, pv, tri.b, scale);
        let gamma = share::<P, R>(pu, pv, tri.c, scale);
        let hit = P::keep(P::inside(hit, beta, gamma, scale), 3)?;
        begun.finish::<P>(hit, ray, [t, beta, gamma])
    }

    #[inline(always)]
    fn normal<P: Policy, R: Real>(tri: &Met<R>) -> Vec3<R> {
        tri.normal
    }
}

impl<R: Real> Met<R> {
    /// p_u n_u + p_v n_v + p_w, all over n_w.
    #[inline(always)]
    fn along<P: Policy>(&self, p: &Vec3<R>) -> R {
        let (u, v) = (self.u.pick(p), self.v.pick(p));
        P::multiply_add(v, self.n.y(), P::multiply_add(u, self.n.x(), self.w.pick(p)))
    }
}

#[inline(always)]
fn share<P: Policy, R: Real>(pu: R, pv: R, line: Vec3<R>, scale: Scale<R>) -> R {
    P::multiply_add(pu, line.x(), P::multiply_add(pv, line.y(), P::scaled(line.z(), scale)))
}
