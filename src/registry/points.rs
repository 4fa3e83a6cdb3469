//! The forms of the query `point`: is this point of the triangle's plane inside?

use crate::batch::{PairsLoop, Points};
use crate::kernels::{
    AngleSum, BadouelCramer, HalfSpaces, Keidy, PointTest, SignedAreas, Vertices,
};
use crate::level::{self, Level, On};
use crate::number::Element;
use crate::policy::{
    Between, Compare, Distance, Early, Exit, Form, Full, Last, Plain, Ray, SignBits, Tests, Tuv,
    TwoSided,
};

use super::{Axes, Variant, bind_pairs};

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
type Base = level::Sse2;
#[cfg(target_arch = "aarch64")]
type Base = level::Neon;

/// Every point test: single, at the baseline level, in both precisions.
pub fn all(v: &mut Vec<Variant>) {
    precisions::<Keidy<Vertices>, Compare>(v, true);
    precisions::<Keidy<Vertices>, SignBits>(v, true);
    precisions::<BadouelCramer, Compare>(v, true);
    precisions::<HalfSpaces, Compare>(v, true);
    precisions::<SignedAreas, Compare>(v, true);
    precisions::<AngleSum, Compare>(v, false);
}

fn precisions<K: PointTest, C: Tests>(v: &mut Vec<Variant>, uv: bool) {
    form::<K, f32, Early, C>(v, uv);
    form::<K, f32, Full, C>(v, uv);
    form::<K, f64, Early, C>(v, uv);
    form::<K, f64, Full, C>(v, uv);
}

/// One variant; u and v are divided last. Without `uv` only the hit is reported.
fn form<K: PointTest, E: Element + On<Base>, X: Exit, C: Tests>(v: &mut Vec<Variant>, uv: bool) {
    type Of<X, C> = Form<X, Last, Plain, Tuv, TwoSided, C, Distance, Between>;
    fn exit_code<K: PointTest, C: Tests, E: Element>(ray: &Ray<E>, tri: &K::Record<E>) -> u8 {
        let met = K::meet::<Of<Early, C>, E>((), tri);
        K::contains::<Of<Early, C>, E>(&ray.end, &met).map_or_else(|miss| miss.0, |_| 0)
    }
    let run: PairsLoop<E, K::Record<E>> = Base::enter::<Points<K, Of<X, C>, E>, 0>;
    let axes = Axes {
        exit: X::NAME,
        output: if uv { "tuv" } else { "hit" },
        query: "point",
        stored: K::ABOUT.stored,
        tests: C::NAME,
        ..Axes::usual(K::ABOUT.id, E::NAME, <Base as level::Level>::NAME)
    };
    v.push(Variant {
        axes,
        about: &K::ABOUT,
        bytes_per_triangle: size_of::<K::Record<E>>(),
        available: level::available::<Base>,
        pairs: Some(bind_pairs(K::prepare::<E>, run, exit_code::<K, C, E>)),
        nearest: None,
        tiles: None,
        preparing: None,
        rays: 1,
        lanes: 1,
        work: None,
    });
}
