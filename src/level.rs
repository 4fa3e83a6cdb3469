//! Instruction-set levels, and the one shell through which code of a level is entered.

use std::hint::black_box;

use fearless_simd::{Level as Detected, Simd};

use crate::number::{Lanes, Real, Twice, Xyz};

/// An instruction-set level.
pub trait Level: Copy + 'static {
    /// The column `level`.
    const NAME: &'static str;
    /// Proof that the processor has it.
    type Token: Simd;
    /// The proof, on a processor that has it.
    fn token() -> Option<Self::Token>;

    /// Runs a batch inside the level. `COPY` tells placebos apart: the same source with another
    /// constant, so that the copies are not merged into one function. A method, not a function: the
    /// compiler puts methods of a type where the type is, and so the levels into pieces that it
    /// compiles side by side.
    ///
    /// # Panics
    /// If the processor does not have the level; callers ask [`available`] first.
    fn enter<B: Batch<Self>, const COPY: usize>(data: B::Data<'_>) -> B::Yield {
        let Some(token) = Self::token() else { panic!("this processor has no {}", Self::NAME) };
        token.vectorize(
            #[inline(always)]
            || {
                if COPY > 0 {
                    black_box(COPY);
                }
                B::run(token, data)
            },
        )
    }
}

macro_rules! level {
    ($($(#[$cfg:meta])* $module:ident $type:ident $name:literal $token:ident $detect:ident $doc:literal;)*) => {
        $(
            $(#[$cfg])*
            mod $module {
                use super::{Detected, Level};

                #[doc = $doc]
                #[derive(Clone, Copy)]
                pub struct $type;

                impl Level for $type {
                    const NAME: &'static str = $name;
                    type Token = fearless_simd::$token;
                    fn token() -> Option<Self::Token> {
                        Detected::new().$detect()
                    }
                }
            }

            $(#[$cfg])*
            pub use $module::$type;
        )*

        /// Every level of this processor's architecture, lowest first, and whether it has it.
        pub fn levels() -> Vec<(&'static str, bool)> {
            vec![$(
                $(#[$cfg])*
                ($type::NAME, $type::token().is_some()),
            )*]
        }
    };
}

level! {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    sse2 Sse2 "sse2" Sse2 as_sse2 "The baseline of x86-64 and of Rust on x86: four f32 or two f64 to a register.";
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    sse42 Sse42 "sse4.2" Sse4_2 as_sse4_2 "SSE4.2: the same registers, more instructions.";
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    avx2 Avx2 "avx2" Avx2 as_avx2 "AVX2 with FMA: eight f32 or four f64 to a register.";
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    avx512 Avx512 "avx512" Avx512 as_avx512 "AVX-512 as of Ice Lake: sixteen f32 or eight f64 to a register.";
    #[cfg(target_arch = "aarch64")]
    neon Neon "neon" Neon as_neon "The baseline of AArch64: four f32 or two f64 to a register.";
}

/// Whether this processor has the level.
pub fn available<L: Level>() -> bool {
    L::token().is_some()
}

/// A number that code of level `L` computes with.
pub trait On<L: Level>: Real {
    /// Its token, from the level's.
    fn token_on(level: L::Token) -> Self::Token;
}

impl<L: Level> On<L> for f32 {
    #[inline(always)]
    fn token_on(_: L::Token) {}
}

impl<L: Level> On<L> for f64 {
    #[inline(always)]
    fn token_on(_: L::Token) {}
}

impl<L: Level, V> On<L> for Lanes<L::Token, V>
where
    Lanes<L::Token, V>: Real<Token = L::Token>,
{
    #[inline(always)]
    fn token_on(level: L::Token) -> L::Token {
        level
    }
}

impl<L: Level, D> On<L> for Xyz<L::Token, D>
where
    Xyz<L::Token, D>: Real<Token = L::Token>,
{
    #[inline(always)]
    fn token_on(level: L::Token) -> L::Token {
        level
    }
}

impl<L: Level, R: On<L>> On<L> for Twice<R> {
    #[inline(always)]
    fn token_on(level: L::Token) -> R::Token {
        R::token_on(level)
    }
}

/// A batch loop: what is compiled once per form and level, and called through one pointer.
pub trait Batch<L: Level> {
    /// What the loop reads.
    type Data<'a>;
    /// What it found.
    type Yield;
    /// The loop. Everything in it is inlined, or it would not be compiled for the level.
    fn run(token: L::Token, data: Self::Data<'_>) -> Self::Yield;
}
