//! Packets whose rays have their origin or their direction in common.

use crate::batch::{Aosoa, Sharing};
use crate::bound::{Work, shared_work};
use crate::kernels::Fallback;
use crate::kernels::{
    Common, CommonOrigin, EmbreePlucker, HalfSpaces, KenslerShirley, MollerTrumbore, Parallel,
    PerpendicularPlanes, Precomputed, Shares, Vertices, WithEdges, WoopAffine, WoopWatertight,
};
use crate::level::{Level, On};
use crate::number::{Real, Twice};
use crate::policy::{
    Compare, Distance, Early, Exit, First, Full, Fused, Last, Policy, Tuv, TwoSided,
};

use super::drives::{Of, driven};
use super::forms::divisions_with;
use super::{EVERY_FORM, Offers, Variant, registers};

/// Every kernel that shares something.
pub fn all(v: &mut Vec<Variant>) {
    lengths::<MollerTrumbore, CommonOrigin>(v);
    lengths::<KenslerShirley<Vertices>, CommonOrigin>(v);
    lengths::<KenslerShirley<Precomputed>, CommonOrigin>(v);
    lengths::<ByEdges, CommonOrigin>(v);
    if EVERY_FORM {
        by_edges(v);
    }
    lengths::<PerpendicularPlanes, CommonOrigin>(v);
    lengths::<HalfSpaces, CommonOrigin>(v);
    lengths::<EmbreePlucker, CommonOrigin>(v);
    lengths::<WoopWatertight<Fallback>, CommonOrigin>(v);
    lengths::<WoopAffine, CommonOrigin>(v);
    lengths::<MollerTrumbore, Parallel>(v);
    lengths::<KenslerShirley<Vertices>, Parallel>(v);
    lengths::<KenslerShirley<Precomputed>, Parallel>(v);
    lengths::<PerpendicularPlanes, Parallel>(v);
    lengths::<WoopAffine, Parallel>(v);
}

/// Kensler-Shirley, whose weights are made of cross products that rays with one origin share.
type ByEdges = KenslerShirley<Vertices, WithEdges>;

/// Single rays of it that compute everything, and packets with nothing in common, which lose by it what
/// others gain.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn by_edges(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512};
    use registers::{Eight, Sixteen};

    general::<f32, Avx2>(v);
    general::<Eight, Avx2>(v);
    general::<Twice<Eight>, Avx2>(v);
    general::<Sixteen, Avx512>(v);
    general::<Twice<Sixteen>, Avx512>(v);
}

/// Single rays of it that compute everything, and packets with nothing in common, which lose by it what
/// others gain.
#[cfg(target_arch = "aarch64")]
fn by_edges(v: &mut Vec<Variant>) {
    use crate::level::Neon;

    general::<f32, Neon>(v);
    general::<registers::Four, Neon>(v);
    general::<Twice<registers::Four>, Neon>(v);
}

fn general<R: On<L>, L: Level>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    divisions_with::<ByEdges, R, L, Full, Fused, Tuv, TwoSided, Compare, Distance>(v);
}

/// Packets of one register and of two; early packets of one.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn lengths<K: Offers + Shares<C>, C: Common>(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512};
    use registers::{Eight, Sixteen};

    form::<K, C, Full, Sixteen, Sixteen, Avx512, 16>(v);
    if EVERY_FORM {
        form::<K, C, Full, Eight, Eight, Avx2, 8>(v);
        form::<K, C, Full, Twice<Eight>, Eight, Avx2, 8>(v);
        form::<K, C, Full, Twice<Sixteen>, Sixteen, Avx512, 16>(v);
        form::<K, C, Early, Eight, Eight, Avx2, 8>(v);
        form::<K, C, Early, Sixteen, Sixteen, Avx512, 16>(v);
    }
}

/// Packets of one register and of two; early packets of one.
#[cfg(target_arch = "aarch64")]
fn lengths<K: Offers + Shares<C>, C: Common>(v: &mut Vec<Variant>) {
    use crate::level::Neon;
    use registers::Four;

    form::<K, C, Full, Four, Four, Neon, 4>(v);
    form::<K, C, Full, Twice<Four>, Four, Neon, 4>(v);
    form::<K, C, Early, Four, Four, Neon, 4>(v);
}

/// Packets `R`, triangles prepared `WIDTH` at a time, the number of lanes of `G`: divided last and,
/// where everything is computed, which is done sooner divided first, first as well.
fn form<K, C, E, R, G, L, const WIDTH: usize>(v: &mut Vec<Variant>)
where
    K: Offers + Shares<C>,
    C: Common,
    E: Exit,
    R: Real + On<L>,
    G: Real<Element = R::Element, Token = R::Token>,
    L: Level,
{
    if K::LAST && (EVERY_FORM || !K::FIRST) {
        one::<K, Of<K, E, Last, Fused>, C, R, G, L, WIDTH>(v);
    }
    if K::FIRST && (E::DEFERS_RANGE || !K::LAST) {
        one::<K, Of<K, E, First, Fused>, C, R, G, L, WIDTH>(v);
    }
}

/// One variant.
fn one<K, P, C, R, G, L, const WIDTH: usize>(v: &mut Vec<Variant>)
where
    K: Offers + Shares<C>,
    P: Policy,
    C: Common,
    R: Real + On<L>,
    G: Real<Element = R::Element, Token = R::Token>,
    L: Level,
{
    let drive = format!("packet{}-{}", R::LANES, C::NAME);
    let run = L::enter::<Sharing<K, P, R, G, C>, 0>;
    let variant = driven::<K, P, R::Element, L, Aosoa<WIDTH>>(drive, [R::LANES; 3], run);
    let work: Option<fn() -> Work> =
        if P::Exit::DEFERS_RANGE { Some(shared_work::<K, P, C>) } else { None };
    v.push(Variant { work, ..variant });
}
