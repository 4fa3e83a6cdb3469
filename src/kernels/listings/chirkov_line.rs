//! Chirkov as thesis B prints it (4.5.3): N. Chirkov, "Fast 3D Line Segment-Triangle Intersection
//! Test", Journal of Graphics Tools 10(3), 2005, without the test that rejects segments that end
//! before the plane: a *line* test; [`Chirkov`](crate::kernels::Chirkov) is the paper's.
//!
//! Stored: 16 words (64 bytes in f32). Operations of a hit, t only: 29 x, 11 +, 19 -, 1 unary
//! minus, 1 /, 2 conditions.
//! With u and v (thesis B, 4.6): v = adelxbase / (dd n), u = the second edge's product over the
//! same, with n the normal's component along the dropped axis, times its length.
//! Known weakness: products of degree 6 leave the range of f32 first; `>=` on one edge and `<` on
//! another make the boundary belong to some sides only.

use super::{Listing, Planar, Returned, Script};
use crate::kernels::{About, Corners};
use crate::number::Element;
use crate::policy::Ray;

/// See the module's text.
pub struct ChirkovLine;

impl Listing for ChirkovLine {
    const ABOUT: About = About {
        id: "chirkov-line",
        name: "Chirkov, line",
        year: 2005,
        source: "Chirkov, Journal of Graphics Tools 10(3), 2005; thesis B, 4.5.3",
        setup: "unit normal, plane and axes",
        stored: "precomputed",
        watertight: false,
        codes: &["outside an edge"],
    };
    type Record<E: Element> = Planar<E>;

    fn prepare<E: Element>(corners: &Corners<E>) -> Planar<E> {
        Planar::of(corners)
    }

    #[inline(always)]
    fn run<E: Element, S: Script, const UV: bool>(ray: &Ray<E>, tri: &Planar<E>) -> Returned<E> {
        let sign_src = S::dot(tri.normal, ray.origin) + tri.d;
        let sign_dst = S::dot(tri.normal, ray.end) + tri.d;
        let dd = sign_src - sign_dst;

        let (i1, i2) = tri.axes();
        let (ay, az) = (tri.v1.0[i1] - tri.v0.0[i1], tri.v1.0[i2] - tri.v0.0[i2]);
        let (by, bz) = (tri.v2.0[i1] - tri.v0.0[i1], tri.v2.0[i2] - tri.v0.0[i2]);
        let (dely, delz) = (ray.end.0[i1] - ray.origin.0[i1], ray.end.0[i2] - ray.origin.0[i2]);
        let (basey, basez) = (ray.origin.0[i1] - tri.v0.0[i1], ray.origin.0[i2] - tri.v0.0[i2]);

        let adelxbase = sign_src * (ay * delz - az * dely) + dd * (ay * basez - az * basey);
        let second = sign_src * (dely * bz - delz * by) + dd * (basey * bz - basez * by);
        if S::condition::<E>((adelxbase * second).ge(E::ZERO)) {
            let (cy, cz) = (tri.v2.0[i1] - tri.v1.0[i1], tri.v2.0[i2] - tri.v1.0[i2]);
            let (basey, basez) = (ray.origin.0[i1] - tri.v1.0[i1], ray.origin.0[i2] - tri.v1.0[i2]);
            let third = sign_src * (dely * cz - delz * cy) + dd * (basey * cz - basez * cy);
            if S::condition::<E>((adelxbase * third).lt(E::ZERO)) {
                let t = S::divide(-sign_src, S::dot(ray.direction, tri.normal));
                if UV {
                    let inverse = S::divide(E::ONE, dd * (ay * bz - az * by));
                    return (0, t, second * inverse, adelxbase * inverse);
                }
                return (0, t, E::ZERO, E::ZERO);
            }
        }
        (1, E::ZERO, E::ZERO, E::ZERO)
    }
}
