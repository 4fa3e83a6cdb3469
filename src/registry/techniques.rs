//! Techniques that are compared with their absence: estimated reciprocals, and one branch instead of
//! one behind each test. A few kernels stand for all.

use crate::level::{Level, On};
use crate::policy::{
    Between, Compare, Divide, Division, Early, Estimated, Exit, First, Form, Full, Fused, Inside,
    Last, Leading, Nearer, Once, Plain, Reciprocal, Rounding, SignBitsSafe, Tuv, TwoSided,
};

use super::forms::variant;
use super::{EVERY_FORM, KernelVisitor, Offers, Variant, registers, visit_kernels};

/// Every kernel that stands for the others.
pub fn all(v: &mut Vec<Variant>) {
    visit_kernels(&mut Techniques(v));
}

struct Techniques<'a>(&'a mut Vec<Variant>);

impl KernelVisitor for Techniques<'_> {
    fn kernel<K: Offers>(&mut self) {
        if K::TECHNIQUES {
            kernel::<K>(self.0);
        }
    }
    fn variation<K: Offers>(&mut self) {}
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn kernel<K: Offers>(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512, Sse2};
    use registers::{Eight, Sixteen};

    estimates::<K, Sixteen, Avx512>(v);
    once::<K, f32, Sse2, Plain>(v);
    form::<K, f32, Avx2, Once, First, Fused, Divide>(v);
    if K::INSIDE_FIRST {
        signs::<K, Avx2, First, Inside>(v);
        signs::<K, Avx2, Last, Inside>(v);
    } else {
        signs::<K, Avx2, First, K::Native>(v);
    }
    once::<K, Sixteen, Avx512, Fused>(v);
    if EVERY_FORM {
        estimates::<K, Eight, Avx2>(v);
        once::<K, Eight, Avx2, Fused>(v);
    }
}

#[cfg(target_arch = "aarch64")]
fn kernel<K: Offers>(v: &mut Vec<Variant>) {
    estimates::<K, registers::Four, crate::level::Neon>(v);
    once::<K, f32, crate::level::Neon, Plain>(v);
    once::<K, registers::Four, crate::level::Neon, Fused>(v);
}

/// The estimate and one step: where a miss saves the division, and where all divide, last and first.
/// Two steps where all divide, for levels whose estimate is coarse.
fn estimates<K: Offers, R: On<L>, L: Level>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    reciprocals::<K, R, L, Estimated<0>>(v);
    reciprocals::<K, R, L, Estimated<1>>(v);
    form::<K, R, L, Full, Last, Fused, Estimated<2>>(v);
}

fn reciprocals<K: Offers, R: On<L>, L: Level, V: Reciprocal>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    form::<K, R, L, Early, Last, Fused, V>(v);
    form::<K, R, L, Full, Last, Fused, V>(v);
    form::<K, R, L, Full, First, Fused, V>(v);
}

/// All tests asked once.
fn once<K: Offers, R: On<L>, L: Level, A: Rounding>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    form::<K, R, L, Once, First, A, Divide>(v);
    form::<K, R, L, Once, Last, A, Divide>(v);
}

/// A single ray whose weights are asked for in one question about their signs, before anything else
/// where the kernel can: what misses the triangle leaves by one branch, always the same.
fn signs<K: Offers, L: Level, D: Division, Q: Leading>(v: &mut Vec<Variant>)
where
    f32: On<L>,
{
    type Of<D, Q, S> = Form<Early, D, Fused, Tuv, TwoSided, SignBitsSafe, Q, S, Divide>;
    variant::<K, Of<D, Q, Between>, Of<D, Q, Nearer>, f32, L, 0>(v);
}

/// A form with t, u and v.
fn form<K, R, L, E, D, A, V>(v: &mut Vec<Variant>)
where
    K: Offers,
    R: On<L>,
    R::Element: On<L>,
    L: Level,
    E: Exit,
    D: Division,
    A: Rounding,
    V: Reciprocal,
{
    type Of<K, E, D, A, S, V> = Form<E, D, A, Tuv, TwoSided, Compare, <K as Offers>::Native, S, V>;
    variant::<K, Of<K, E, D, A, Between, V>, Of<K, E, D, A, Nearer, V>, R, L, 0>(v);
}
