//! Comparisons that are asked for where a mask holds.
//!
//! AVX-512 compares under a mask in one instruction, which is what `mask & (a < b)` should become.
//! Its comparison reaches the optimiser as an intrinsic, though, which it does not look into: the
//! `and` is left as an instruction of its own, in a unit that additions and products want as well.
//! A test has four of them, an eighth of what its vector units do.

use fearless_simd::{Simd, SimdFloat};

/// A level's comparisons of `V` under a mask. Other levels than AVX-512 have none, and unite.
pub trait Masked<V: SimdFloat<Self>>: Simd {
    /// `mask` where also `a < b`.
    #[inline(always)]
    fn lt_where(mask: V::Mask, a: V, b: V) -> V::Mask {
        mask & a.simd_lt(b)
    }
    /// `mask` where also `a <= b`.
    #[inline(always)]
    fn le_where(mask: V::Mask, a: V, b: V) -> V::Mask {
        mask & a.simd_le(b)
    }
    /// `mask` where also `a != b`, which holds where either is NaN.
    #[inline(always)]
    fn ne_where(mask: V::Mask, a: V, b: V) -> V::Mask {
        mask & !a.simd_eq(b)
    }
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod x86 {
    #[cfg(target_arch = "x86")]
    use std::arch::x86::{
        __m512, __m512d, __mmask8, __mmask16, _CMP_LE_OQ, _CMP_LT_OQ, _CMP_NEQ_UQ,
        _mm512_mask_cmp_pd_mask, _mm512_mask_cmp_ps_mask,
    };
    #[cfg(target_arch = "x86_64")]
    use std::arch::x86_64::{
        __m512, __m512d, __mmask8, __mmask16, _CMP_LE_OQ, _CMP_LT_OQ, _CMP_NEQ_UQ,
        _mm512_mask_cmp_pd_mask, _mm512_mask_cmp_ps_mask,
    };

    use fearless_simd::{
        Avx2, Avx512, ExtractToken, SimdMask, Sse2, Sse4_2, f32x16, f64x8, kernel, mask32x16,
        mask64x8,
    };

    use super::{Masked, SimdFloat};

    impl<V: SimdFloat<Sse2>> Masked<V> for Sse2 {}
    impl<V: SimdFloat<Sse4_2>> Masked<V> for Sse4_2 {}
    impl<V: SimdFloat<Avx2>> Masked<V> for Avx2 {}

    /// The three comparisons of one register.
    macro_rules! masked {
        ($vector:ident $lanes:ident $register:ident $mask:ident $compare:ident $lt:ident $le:ident $ne:ident) => {
            masked!(@kernel $lt $register $mask $compare _CMP_LT_OQ);
            masked!(@kernel $le $register $mask $compare _CMP_LE_OQ);
            masked!(@kernel $ne $register $mask $compare _CMP_NEQ_UQ);

            impl Masked<$vector<Avx512>> for Avx512 {
                masked!(@method lt_where $lt $vector $lanes $mask);
                masked!(@method le_where $le $vector $lanes $mask);
                masked!(@method ne_where $ne $vector $lanes $mask);
            }
        };
        (@kernel $name:ident $register:ident $mask:ident $compare:ident $relation:ident) => {
            kernel!(
                #[inline(always)]
                fn $name(level: Avx512, mask: $mask, a: $register, b: $register) -> $mask {
                    $compare::<$relation>(mask, a, b)
                }
            );
        };
        (@method $name:ident $kernel:ident $vector:ident $lanes:ident $mask:ident) => {
            #[inline(always)]
            fn $name(
                mask: $lanes<Avx512>,
                a: $vector<Avx512>,
                b: $vector<Avx512>,
            ) -> $lanes<Avx512> {
                let bits = mask.to_bitmask() as $mask;
                let level = a.token();
                SimdMask::from_bitmask(level, $kernel(level, bits, a.into(), b.into()).into())
            }
        };
    }

    masked!(f32x16 mask32x16 __m512 __mmask16 _mm512_mask_cmp_ps_mask lt_f32 le_f32 ne_f32);
    masked!(f64x8 mask64x8 __m512d __mmask8 _mm512_mask_cmp_pd_mask lt_f64 le_f64 ne_f64);
}

#[cfg(target_arch = "aarch64")]
impl<V: SimdFloat<fearless_simd::Neon>> Masked<V> for fearless_simd::Neon {}

#[cfg(test)]
mod tests {
    use crate::level::{Batch, Level, On, available};
    use crate::number::{Element, Mask, Real};

    /// Rows of pairs, and per relation and mask the lanes in which the two ways differ.
    struct Differing<R>(std::marker::PhantomData<R>);

    impl<L: Level, R: Real + On<L>> Batch<L> for Differing<R> {
        type Data<'a> = (&'a [R::Element], &'a [R::Element]);
        type Yield = usize;

        #[inline(always)]
        fn run(token: L::Token, (a, b): Self::Data<'_>) -> usize {
            let token = R::token_on(token);
            let (a, b) = (R::load(token, a), R::load(token, b));
            let (all, none) = (R::mask(token, true), R::mask(token, false));
            let mut differing = 0;
            for mask in [all, none, a.lt(a.zero()), b.ge(b.one())] {
                let ways = [
                    (a.lt_where(b, mask), mask & a.lt(b)),
                    (a.le_where(b, mask), mask & a.le(b)),
                    (a.ge_where(b, mask), mask & a.ge(b)),
                    (a.ne_where(b, mask), mask & a.ne(b)),
                ];
                let differs = |lane| ways.iter().filter(move |(x, y)| x.lane(lane) != y.lane(lane));
                differing += (0..R::LANES).flat_map(differs).count();
            }
            differing
        }
    }

    /// Every pair of numbers that comparisons treat in a way of their own.
    fn compare<L: Level, R: Real + On<L>>() {
        if !available::<L>() {
            println!("skipped: no {}", L::NAME);
            return;
        }
        let of = R::Element::from_f64;
        let least = R::Element::from_bits(1);
        let (inf, nan) = (of(1.0) / of(0.0), of(0.0) / of(0.0));
        let numbers = [of(0.0), of(-0.0), of(1.0), of(-1.0), least, -least, inf, -inf, nan, -nan];
        let pairs = numbers.iter().flat_map(|a| numbers.iter().map(move |b| (*a, *b)));
        let (mut a, mut b): (Vec<_>, Vec<_>) = pairs.unzip();
        let whole = a.len().next_multiple_of(R::LANES);
        a.resize(whole, of(0.0));
        b.resize(whole, of(0.0));
        for (a, b) in a.chunks(R::LANES).zip(b.chunks(R::LANES)) {
            let numbers = |of: &[R::Element]| of.iter().map(|x| x.to_f64()).collect::<Vec<_>>();
            let differing = L::enter::<Differing<R>, 0>((a, b));
            assert_eq!(differing, 0, "{}: {:?} {:?}", L::NAME, numbers(a), numbers(b));
        }
    }

    #[test]
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn a_comparison_under_a_mask_is_the_comparison_and_the_mask() {
        use crate::level::{Avx2, Avx512, Sse2};
        use crate::number::{Lanes, Twice};
        use fearless_simd::{f32x4, f32x8, f32x16, f64x4, f64x8};
        type Token<L> = <L as Level>::Token;

        compare::<Sse2, Lanes<Token<Sse2>, f32x4<Token<Sse2>>>>();
        compare::<Avx2, Lanes<Token<Avx2>, f32x8<Token<Avx2>>>>();
        compare::<Avx2, Twice<Lanes<Token<Avx2>, f64x4<Token<Avx2>>>>>();
        compare::<Avx512, Lanes<Token<Avx512>, f32x16<Token<Avx512>>>>();
        compare::<Avx512, Lanes<Token<Avx512>, f64x8<Token<Avx512>>>>();
        compare::<Avx512, Twice<Lanes<Token<Avx512>, f32x16<Token<Avx512>>>>>();
        compare::<Sse2, f32>();
    }
}
