//! Packets whose rays have their origin or their direction in common.

use crate::batch::{Aosoa, Sharing};
use crate::bound::{Work, shared_work};
use crate::kernels::Fallback;
use crate::kernels::{
    Common, CommonOrigin, EmbreePlucker, HalfSpaces, KenslerShirley, MollerTrumbore, Parallel,
    PerpendicularPlanes, Precomputed, Shares, Vertices, WoopAffine, WoopWatertight,
};
use crate::level::{Level, On, enter};
use crate::number::{Real, Twice};
use crate::policy::{Early, Exit, First, Full, Fused, Last, Policy};

use super::drives::{Of, driven};
use super::{Offers, Variant, registers};

/// Every kernel that shares something.
pub fn all(v: &mut Vec<Variant>) {
    lengths::<MollerTrumbore, CommonOrigin>(v);
    lengths::<KenslerShirley<Vertices>, CommonOrigin>(v);
    lengths::<KenslerShirley<Precomputed>, CommonOrigin>(v);
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

/// Packets of one register and of two; early packets of one.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn lengths<K: Offers + Shares<C>, C: Common>(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512};
    use registers::{Eight, Sixteen};

    form::<K, C, Full, Sixteen, Sixteen, Avx512, 16>(v);
    if cfg!(not(any(test, fuzzing))) {
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

/// One variant: packets `R`, triangles prepared `WIDTH` at a time, the number of lanes of `G`. Divided
/// last where the kernel can be: then a division can be shared.
fn form<K, C, E, R, G, L, const WIDTH: usize>(v: &mut Vec<Variant>)
where
    K: Offers + Shares<C>,
    C: Common,
    E: Exit,
    R: Real + On<L>,
    G: Real<Element = R::Element, Token = R::Token>,
    L: Level,
{
    if K::LAST {
        one::<K, Of<K, E, Last, Fused>, C, R, G, L, WIDTH>(v);
    } else {
        one::<K, Of<K, E, First, Fused>, C, R, G, L, WIDTH>(v);
    }
}

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
    let run = enter::<L, Sharing<K, P, R, G, C>, 0>;
    let variant = driven::<K, P, R::Element, L, Aosoa<WIDTH>>(drive, [R::LANES; 3], run);
    let work: Option<fn() -> Work> =
        if P::Exit::DEFERS_RANGE { Some(shared_work::<K, P, C>) } else { None };
    v.push(Variant { work, ..variant });
}
