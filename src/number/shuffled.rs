//! Shuffles and dot products inside a register of four numbers, by the levels that have them.

use fearless_simd::f32x4;

use super::masked::Masked;

/// A level that moves lanes.
pub trait Shuffled: Masked<f32x4<Self>> {
    /// y, z, x.
    fn turned(v: f32x4<Self>) -> f32x4<Self>;
    /// y in every lane.
    fn second(v: f32x4<Self>) -> f32x4<Self>;
    /// z in every lane.
    fn third(v: f32x4<Self>) -> f32x4<Self>;
    /// The last three lanes as the first three.
    fn behind_first(v: f32x4<Self>) -> f32x4<Self>;
}

/// A level with an instruction for dot products.
pub trait Dotted: Shuffled {
    /// x x' + y y' + z z' in every lane.
    fn dot(a: f32x4<Self>, b: f32x4<Self>) -> f32x4<Self>;
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod x86 {
    #[cfg(target_arch = "x86")]
    use std::arch::x86::{__m128, _mm_dp_ps, _mm_shuffle_ps};
    #[cfg(target_arch = "x86_64")]
    use std::arch::x86_64::{__m128, _mm_dp_ps, _mm_shuffle_ps};

    use fearless_simd::{Avx2, ExtractToken, SimdFrom, Sse2, Sse4_2, f32x4, kernel};

    use super::{Dotted, Shuffled};

    /// Lanes 1, 2, 0 and 3; lane 1; lane 2; lanes 1, 2 and 3.
    const TURNED: i32 = 0b11_00_10_01;
    const SECOND: i32 = 0b01_01_01_01;
    const THIRD: i32 = 0b10_10_10_10;
    const BEHIND_FIRST: i32 = 0b11_11_10_01;
    /// Three products, their sum in all lanes.
    const THREE_TO_ALL: i32 = 0b0111_1111;

    macro_rules! shuffled {
        ($level:ident $($name:ident $lanes:ident)*) => {
            $(kernel!(
                #[inline(always)]
                fn $name(level: $level, v: __m128) -> __m128 {
                    _mm_shuffle_ps::<$lanes>(v, v)
                }
            );)*
        };
    }

    macro_rules! level {
        ($level:ident $($method:ident $name:ident $lanes:ident)*) => {
            shuffled!($level $($name $lanes)*);

            impl Shuffled for $level {
                $(
                    #[inline(always)]
                    fn $method(v: f32x4<Self>) -> f32x4<Self> {
                        SimdFrom::simd_from(v.token(), $name(v.token(), v.into()))
                    }
                )*
            }
        };
    }

    macro_rules! dotted {
        ($level:ident $dot:ident) => {
            kernel!(
                #[inline(always)]
                fn $dot(level: $level, a: __m128, b: __m128) -> __m128 {
                    _mm_dp_ps::<THREE_TO_ALL>(a, b)
                }
            );

            impl Dotted for $level {
                #[inline(always)]
                fn dot(a: f32x4<Self>, b: f32x4<Self>) -> f32x4<Self> {
                    SimdFrom::simd_from(a.token(), $dot(a.token(), a.into(), b.into()))
                }
            }
        };
    }

    level!(Sse2 turned turned_sse2 TURNED second second_sse2 SECOND third third_sse2 THIRD
        behind_first behind_sse2 BEHIND_FIRST);
    level!(Sse4_2 turned turned_sse42 TURNED second second_sse42 SECOND third third_sse42 THIRD
        behind_first behind_sse42 BEHIND_FIRST);
    level!(Avx2 turned turned_avx2 TURNED second second_avx2 SECOND third third_avx2 THIRD
        behind_first behind_avx2 BEHIND_FIRST);
    dotted!(Sse4_2 dot_sse42);
    dotted!(Avx2 dot_avx2);
}
