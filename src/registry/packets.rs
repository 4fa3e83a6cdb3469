//! Packets longer than a register: two and four registers of rays meet a triangle at once.

use crate::level::{Level, On};
use crate::number::{Real, Twice};
use crate::policy::{Compare, Early, Full, Fused, Tuv, TwoSided};

use super::forms::divisions_with;
use super::{KernelVisitor, Offers, Variant, registers, visit_kernels};

/// Every kernel that runs in packets.
pub fn all(v: &mut Vec<Variant>) {
    visit_kernels(&mut Longer(v));
}

struct Longer<'a>(&'a mut Vec<Variant>);

impl KernelVisitor for Longer<'_> {
    fn kernel<K: Offers>(&mut self) {
        if K::PACKETS {
            kernel::<K>(self.0);
        }
    }
    fn other_edges<K: Offers>(&mut self) {}
}

#[cfg(target_arch = "x86_64")]
fn kernel<K: Offers>(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512};
    use registers::{Eight, EightDoubles, Sixteen};

    full::<K, Twice<Sixteen>, Avx512>(v);
    if cfg!(not(test)) {
        full::<K, Twice<Eight>, Avx2>(v);
        full::<K, Twice<EightDoubles>, Avx512>(v);
    }
    if K::GROUPS && cfg!(not(test)) {
        early::<K, Twice<Eight>, Avx2>(v);
        early::<K, Twice<Sixteen>, Avx512>(v);
        full::<K, Twice<Twice<Eight>>, Avx2>(v);
        full::<K, Twice<Twice<Sixteen>>, Avx512>(v);
    }
}

#[cfg(target_arch = "aarch64")]
fn kernel<K: Offers>(v: &mut Vec<Variant>) {
    use crate::level::Neon;
    use registers::{Four, TwoDoubles};

    full::<K, Twice<Four>, Neon>(v);
    full::<K, Twice<TwoDoubles>, Neon>(v);
    if K::GROUPS {
        early::<K, Twice<Four>, Neon>(v);
        full::<K, Twice<Twice<Four>>, Neon>(v);
    }
}

/// Everything computed: where length gains, for no ray waits for another.
fn full<K: Offers, R: Real + On<L>, L: Level>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    divisions_with::<K, R, L, Full, Fused, Tuv, TwoSided, Compare, K::Native>(v);
}

/// Left when no ray of all registers can hit.
fn early<K: Offers, R: Real + On<L>, L: Level>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    divisions_with::<K, R, L, Early, Fused, Tuv, TwoSided, Compare, K::Native>(v);
}
