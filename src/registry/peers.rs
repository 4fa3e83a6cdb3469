//! The tests of other crates: single rays of f32 at the baseline, on pairs.

use std::marker::PhantomData;
use std::sync::LazyLock;

use glam::Vec3;

use crate::batch::{Foreign, ForeignPairs, LoopOver, PairsJob};
use crate::job::Answer;
use crate::level::{self, Level};
use crate::oracle::Query;
use crate::peers::{Bvh, Glam, Obvhs, ObvhsCompressed, ObvhsPrepared, Parry, Peer, Rayx};
use crate::workload::{Ray, Triangle};

use super::asked::{Asked, answer};
use super::{Axes, Binder, Variant};

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
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

/// Every peer with t, u and v, to be asked without a clock.
pub fn asked() -> &'static [Asked] {
    static ASKED: LazyLock<Vec<Asked>> = LazyLock::new(|| {
        vec![
            form::<Parry>(),
            form::<Bvh>(),
            form::<Obvhs>(),
            form::<ObvhsPrepared>(),
            form::<ObvhsCompressed>(),
            form::<Glam>(),
            form::<Rayx>(),
        ]
    });
    &ASKED
}

fn form<P: Peer>() -> Asked {
    Asked { axes: axes::<P, true>(), about: &P::ABOUT, is_segment: false, ask: ask::<P> }
}

/// The answer to a query whose numbers are rounded to f32.
fn ask<P: Peer>(query: &Query) -> Answer {
    let vector = |v: [f64; 3]| Vec3::from_array(v.map(|x| x as f32));
    let bound = |t: f64| t.clamp(-f64::from(f32::MAX), f64::from(f32::MAX)) as f32;
    let (origin, direction) = (vector(query.origin), vector(query.direction));
    let ray = Ray {
        origin,
        direction,
        end: query.end.map_or(origin + direction, vector),
        t_min: bound(query.t_min),
        t_max: bound(query.t_max),
    };
    let [a, b, c] = query.triangle.map(vector);
    match P::test::<true>(&P::ray(&ray), &P::triangle(&Triangle { a, b, c })) {
        Some(outputs) => answer(true, outputs, 0),
        None => answer(false, [0.0f32; 3], u8::MAX),
    }
}

fn axes<P: Peer, const UV: bool>() -> Axes {
    Axes {
        division: P::DIVISION,
        output: if UV { "tuv" } else { "t" },
        cull: P::CULL,
        leading: P::LEADING,
        stored: P::ABOUT.stored,
        stored_is_native: P::STORED_IS_NATIVE,
        tests: P::TESTS,
        ..Axes::usual(P::ABOUT.id, "f32", Base::NAME)
    }
}

fn variant<P: Peer, const UV: bool>() -> Variant {
    Variant {
        axes: axes::<P, UV>(),
        about: &P::ABOUT,
        bytes_per_triangle: size_of::<P::Triangle>(),
        available: level::available::<Base>,
        pairs: Some(bind::<P, UV>()),
        nearest: None,
        rays: 1,
        lanes: 1,
        work: None,
        tiles: None,
        preparing: None,
    }
}

/// The test of a peer.
struct OfPeer<P>(PhantomData<P>);

impl<P: Peer> Foreign for OfPeer<P> {
    type Number = f32;
    type Ray = P::Ray;
    type Triangle = P::Triangle;

    #[inline(always)]
    fn test<const UV: bool>(ray: &P::Ray, triangle: &P::Triangle) -> Option<[f32; 3]> {
        P::test::<UV>(ray, triangle)
    }
}

fn bind<P: Peer, const UV: bool>() -> Binder {
    fn exit_code<P: Peer, const UV: bool>(ray: &P::Ray, triangle: &P::Triangle) -> u8 {
        if P::test::<UV>(ray, triangle).is_some() { 0 } else { u8::MAX }
    }
    Box::new(|rays, triangles| {
        let pairs = rays.iter().zip(triangles);
        let pairs = pairs.map(|(ray, triangle)| (P::ray(ray), P::triangle(triangle))).collect();
        let run: LoopOver<(P::Ray, P::Triangle)> = Base::enter::<ForeignPairs<OfPeer<P>, UV>, 0>;
        Box::new(PairsJob::<f32, _, _>::new(pairs, run, exit_code::<P, UV>))
    })
}
