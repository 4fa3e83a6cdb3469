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

    /// Lanes 1, 2, 0 and 3; lane 1; lane 2.
    const TURNED: i32 = 0b11_00_10_01;
    const SECOND: i32 = 0b01_01_01_01;
    const THIRD: i32 = 0b10_10_10_10;
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
        ($level:ident $turned:ident $second:ident $third:ident) => {
            shuffled!($level $turned TURNED $second SECOND $third THIRD);

            impl Shuffled for $level {
                #[inline(always)]
                fn turned(v: f32x4<Self>) -> f32x4<Self> {
                    SimdFrom::simd_from(v.token(), $turned(v.token(), v.into()))
                }
                #[inline(always)]
                fn second(v: f32x4<Self>) -> f32x4<Self> {
                    SimdFrom::simd_from(v.token(), $second(v.token(), v.into()))
                }
                #[inline(always)]
                fn third(v: f32x4<Self>) -> f32x4<Self> {
                    SimdFrom::simd_from(v.token(), $third(v.token(), v.into()))
                }
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

    level!(Sse2 turned_sse2 second_sse2 third_sse2);
    level!(Sse4_2 turned_sse42 second_sse42 third_sse42);
    level!(Avx2 turned_avx2 second_avx2 third_avx2);
    dotted!(Sse4_2 dot_sse42);
    dotted!(Avx2 dot_avx2);
}
