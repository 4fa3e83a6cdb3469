//! Packets longer than a register: two and four registers of rays meet a triangle at once. All kernels have
//! two registers of f32; a few stand for the others in f64 and in packets of four.

use crate::level::{Level, On};
use crate::number::{Real, Twice};
use crate::policy::{Compare, Full, Fused, Tuv, TwoSided};

use super::forms::divisions_with;
use super::{EVERY_FORM, KernelVisitor, Offers, Variant, registers, visit_kernels};

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
    fn variation<K: Offers>(&mut self) {}
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn kernel<K: Offers>(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512};
    use registers::{Eight, EightDoubles, Sixteen};

    full::<K, Twice<Sixteen>, Avx512>(v);
    if EVERY_FORM {
        full::<K, Twice<Eight>, Avx2>(v);
    }
    if K::GROUPS && EVERY_FORM {
        full::<K, Twice<EightDoubles>, Avx512>(v);
    }
    if K::LAYOUTS && EVERY_FORM {
        full::<K, Twice<Twice<Eight>>, Avx2>(v);
        full::<K, Twice<Twice<Sixteen>>, Avx512>(v);
    }
}

#[cfg(target_arch = "aarch64")]
fn kernel<K: Offers>(v: &mut Vec<Variant>) {
    use crate::level::Neon;
    use registers::{Four, TwoDoubles};

    full::<K, Twice<Four>, Neon>(v);
    if K::GROUPS {
        full::<K, Twice<TwoDoubles>, Neon>(v);
    }
    if K::LAYOUTS {
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
