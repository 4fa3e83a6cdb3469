//! The forms of a kernel that keeps the signs of its edge functions, or multiplies its triple products,
//! in another way than by default.

use crate::level::{Level, On};
use crate::policy::{Compare, Early, Fused, Plain, Rounding, Tuv, TwoSided};

use super::forms::divisions_with;
use super::{Offers, Variant};

/// Early only, at the baseline and where products can be fused.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
pub fn all<K: Offers>(v: &mut Vec<Variant>) {
    use fearless_simd::{f32x8, f32x16};

    use crate::level::{Avx2, Avx512, Sse2};
    use crate::number::Lanes;

    type A2 = <Avx2 as Level>::Token;
    type A5 = <Avx512 as Level>::Token;

    early::<K, f32, Sse2, Plain>(v);
    early::<K, f32, Avx2, Fused>(v);
    early::<K, f64, Sse2, Plain>(v);
    early::<K, Lanes<A2, f32x8<A2>>, Avx2, Plain>(v);
    early::<K, Lanes<A2, f32x8<A2>>, Avx2, Fused>(v);
    early::<K, Lanes<A5, f32x16<A5>>, Avx512, Plain>(v);
    early::<K, Lanes<A5, f32x16<A5>>, Avx512, Fused>(v);
}

/// Early only, at the baseline and where products can be fused.
#[cfg(target_arch = "aarch64")]
pub fn all<K: Offers>(v: &mut Vec<Variant>) {
    use crate::level::Neon;

    early::<K, f32, Neon, Plain>(v);
    early::<K, f32, Neon, Fused>(v);
    early::<K, f64, Neon, Plain>(v);
}

/// Early, with t, u and v.
fn early<K: Offers, R: On<L>, L: Level, A: Rounding>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    divisions_with::<K, R, L, Early, A, Tuv, TwoSided, Compare, K::Native>(v);
}
