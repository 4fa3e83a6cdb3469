//! Badouel as thesis B prints it (4.5.2): D. Badouel, "An Efficient Ray-Polygon Intersection",
//! Graphics Gems, 1990, p. 390.
//!
//! Plane first, then substitution in the projected system, with a branch for u1 = 0.
//! alpha is the weight of vertex b and beta that of c, so u and v cost nothing more.
//! Stored: 16 words (64 bytes in f32). Operations of the longest path: 13 x, 8 +, 9 -, 2 unary
//! minuses, 3 /, 4 conditions.
//! Known weakness: three dependent divisions; division by an edge component that may be tiny.

use super::{Listing, Planar, Returned, Script, epsilon};
use crate::kernels::{About, Corners};
use crate::number::Element;
use crate::policy::Ray;

/// See the module's text.
pub struct Badouel;

impl Listing for Badouel {
    const ABOUT: About = About {
        id: "badouel",
        name: "Badouel",
        year: 1990,
        source: "Badouel, Graphics Gems, 1990; thesis B, 4.5.2",
        setup: "unit normal, plane and axes",
        stored: "precomputed",
        watertight: false,
        codes: &[
            "|N.D| < eps",
            "u1 == 0 and beta outside [0, 1]",
            "u1 != 0 and beta outside [0, 1]",
            "alpha < 0 or alpha + beta > 1",
        ],
    };
    type Record<E: Element> = Planar<E>;

    fn prepare<E: Element>(corners: &Corners<E>) -> Planar<E> {
        Planar::of(corners)
    }

    #[inline(always)]
    fn run<E: Element, S: Script, const UV: bool>(ray: &Ray<E>, tri: &Planar<E>) -> Returned<E> {
        let missed = |code| (code, E::ZERO, E::ZERO, E::ZERO);
        let dot = S::dot(ray.direction, tri.normal);
        if S::condition::<E>(dot.gt(-epsilon::<E>()) && dot.lt(epsilon())) {
            return missed(1);
        }
        let dot2 = S::dot(ray.origin, tri.normal);
        let t = S::divide(-(tri.d + dot2), dot);

        let (i1, i2) = tri.axes();
        let pointa = ray.origin.0[i1] + ray.direction.0[i1] * t;
        let pointb = ray.origin.0[i2] + ray.direction.0[i2] * t;
        let (uu0, vv0) = (pointa - tri.v0.0[i1], pointb - tri.v0.0[i2]);
        let (uu1, vv1) = (tri.v1.0[i1] - tri.v0.0[i1], tri.v1.0[i2] - tri.v0.0[i2]);
        let (uu2, vv2) = (tri.v2.0[i1] - tri.v0.0[i1], tri.v2.0[i2] - tri.v0.0[i2]);

        let (alpha, beta);
        if S::condition::<E>(!uu1.ne(E::ZERO)) {
            beta = S::divide(uu0, uu2);
            if S::condition::<E>(beta.lt(E::ZERO) || beta.gt(E::ONE)) {
                return missed(2);
            }
            alpha = S::divide(vv0 - beta * vv2, vv1);
        } else {
            beta = S::divide(vv0 * uu1 - uu0 * vv1, vv2 * uu1 - uu2 * vv1);
            if S::condition::<E>(beta.lt(E::ZERO) || beta.gt(E::ONE)) {
                return missed(3);
            }
            alpha = S::divide(uu0 - beta * uu2, uu1);
        }
        if S::condition::<E>(alpha.lt(E::ZERO) || (alpha + beta).gt(E::ONE)) {
            return missed(4);
        }
        (0, t, alpha, beta)
    }
}
