//! The registers of the levels, as numbers.

use crate::level::Level;
use crate::number::Lanes;

type Token<L> = <L as Level>::Token;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod here {
    use fearless_simd::{f32x4, f32x8, f32x16, f64x8};

    use super::{Lanes, Token};
    use crate::level::{Avx2, Avx512, Sse2};

    /// Four f32 of SSE2.
    pub type Four = Lanes<Token<Sse2>, f32x4<Token<Sse2>>>;
    /// Eight f32 of AVX2.
    pub type Eight = Lanes<Token<Avx2>, f32x8<Token<Avx2>>>;
    /// Sixteen f32 of AVX-512.
    pub type Sixteen = Lanes<Token<Avx512>, f32x16<Token<Avx512>>>;
    /// Eight f64 of AVX-512.
    pub type EightDoubles = Lanes<Token<Avx512>, f64x8<Token<Avx512>>>;
}

#[cfg(target_arch = "aarch64")]
mod here {
    use fearless_simd::{f32x4, f64x2};

    use super::{Lanes, Token};
    use crate::level::Neon;

    /// Four f32 of NEON.
    pub type Four = Lanes<Token<Neon>, f32x4<Token<Neon>>>;
    /// Two f64 of NEON.
    pub type TwoDoubles = Lanes<Token<Neon>, f64x2<Token<Neon>>>;
}

pub use here::*;
