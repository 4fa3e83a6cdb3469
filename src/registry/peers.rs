//! The tests of other crates: single rays of f32 at the baseline, on pairs.

use crate::batch::{LoopOver, PairsJob, PeerPairs};
use crate::level::{self, Level, enter};
use crate::peers::{Bvh, Glam, Obvhs, ObvhsCompressed, ObvhsPrepared, Parry, Peer, Rayx};

use super::{Axes, Binder, Variant};

#[cfg(target_arch = "x86_64")]
type Base = level::Sse2;
#[cfg(target_arch = "aarch64")]
type Base = level::Neon;

/// Every peer with t, u and v; obvhs, which computes u and v by a call of its own, with t alone too.
pub fn all(v: &mut Vec<Variant>) {
    v.extend([
        variant::<Parry, true>(),
        variant::<Bvh, true>(),
        variant::<Obvhs, false>(),
        variant::<Obvhs, true>(),
        variant::<ObvhsPrepared, false>(),
        variant::<ObvhsPrepared, true>(),
        variant::<ObvhsCompressed, false>(),
        variant::<ObvhsCompressed, true>(),
        variant::<Glam, true>(),
        variant::<Rayx, true>(),
    ]);
}

fn variant<P: Peer, const UV: bool>() -> Variant {
    let axes = Axes {
        division: P::DIVISION,
        output: if UV { "tuv" } else { "t" },
        cull: P::CULL,
        leading: P::LEADING,
        stored: P::ABOUT.stored,
        stored_is_native: P::STORED_IS_NATIVE,
        tests: P::TESTS,
        ..Axes::usual(P::ABOUT.id, "f32", Base::NAME)
    };
    Variant {
        axes,
        about: &P::ABOUT,
        bytes_per_triangle: size_of::<P::Triangle>(),
        available: level::available::<Base>,
        pairs: Some(bind::<P, UV>()),
        nearest: None,
        rays: 1,
        lanes: 1,
    }
}

fn bind<P: Peer, const UV: bool>() -> Binder {
    fn exit_code<P: Peer, const UV: bool>(ray: &P::Ray, triangle: &P::Triangle) -> u8 {
        if P::test::<UV>(ray, triangle).is_some() { 0 } else { u8::MAX }
    }
    Box::new(|rays, triangles| {
        let pairs = rays.iter().zip(triangles);
        let pairs = pairs.map(|(ray, triangle)| (P::ray(ray), P::triangle(triangle))).collect();
        let run: LoopOver<(P::Ray, P::Triangle)> = enter::<Base, PeerPairs<P, UV>, 0>;
        Box::new(PairsJob::<f32, _, _>::new(pairs, run, exit_code::<P, UV>))
    })
}
