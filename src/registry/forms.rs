//! The product of the axes, readable from top to bottom: one small generic function per axis.

use crate::batch::{Aos, Nearest, NearestLoop, Pairs, PairsLoop, Shape, Storing};
use crate::bound::{Work, work};
use crate::kernels::{Kernel, MollerTrumbore};
use crate::level::{self, Level, On};
use crate::number::{Element, Real};
use crate::policy::{
    Between, Compare, Cull, Division, Early, Exit, Facing, First, Form, Full, Fused, Hit, Inside,
    Last, Leading, Nearer, Output, Plain, Policy, Products, Rounding, SignBits, SignBitsSafe,
    Surface, T, Tests, Tuv, TwoSided,
};

use super::exit_code::exit_code;
use super::{
    Axes, EVERY_FORM, KernelVisitor, Offers, Other, Variant, bind_nearest, bind_pairs, bind_tiles,
    preparing, variations, visit_kernels,
};

/// Every kernel in every form.
pub fn all(v: &mut Vec<Variant>) {
    visit_kernels(&mut Timed(v));
}

struct Timed<'a>(&'a mut Vec<Variant>);

impl KernelVisitor for Timed<'_> {
    fn kernel<K: Offers>(&mut self) {
        kernel::<K>(self.0);
    }
    fn variation<K: Offers>(&mut self) {
        variations::all::<K>(self.0);
    }
}

/// The levels and the numbers that each of them has natively.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn kernel<K: Offers>(v: &mut Vec<Variant>) {
    use fearless_simd::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

    use crate::level::{Avx2, Avx512, Sse2, Sse42};
    use crate::number::Lanes;

    type On<L, V> = Lanes<<L as Level>::Token, V>;
    type S2 = <Sse2 as Level>::Token;
    type S4 = <Sse42 as Level>::Token;
    type A2 = <Avx2 as Level>::Token;
    type A5 = <Avx512 as Level>::Token;

    outputs::<K, f32, Sse2, Plain>(v);
    exits::<K, f32, Avx2, Fused>(v);
    if K::F64 {
        exits::<K, f64, Sse2, Plain>(v);
    }
    if K::PACKETS {
        exits::<K, On<Sse2, f32x4<S2>>, Sse2, Plain>(v);
    }
    if EVERY_FORM {
        exits::<K, f32, Sse42, Plain>(v);
        exits::<K, f32, Avx2, Plain>(v);
        exits::<K, f32, Avx512, Plain>(v);
    }
    if K::F64 && EVERY_FORM {
        exits::<K, f64, Avx2, Plain>(v);
    }
    if K::PACKETS && EVERY_FORM {
        exits::<K, On<Sse42, f32x4<S4>>, Sse42, Plain>(v);
        exits::<K, On<Avx2, f32x8<A2>>, Avx2, Plain>(v);
        exits::<K, On<Avx2, f32x8<A2>>, Avx2, Fused>(v);
        outputs::<K, On<Avx512, f32x16<A5>>, Avx512, Plain>(v);
        exits::<K, On<Avx512, f32x16<A5>>, Avx512, Fused>(v);
        exits::<K, On<Sse2, f64x2<S2>>, Sse2, Plain>(v);
        exits::<K, On<Avx2, f64x4<A2>>, Avx2, Plain>(v);
        exits::<K, On<Avx2, f64x4<A2>>, Avx2, Fused>(v);
        exits::<K, On<Avx512, f64x8<A5>>, Avx512, Plain>(v);
        exits::<K, On<Avx512, f64x8<A5>>, Avx512, Fused>(v);
    }
}

/// The levels and the numbers that each of them has natively.
#[cfg(target_arch = "aarch64")]
fn kernel<K: Offers>(v: &mut Vec<Variant>) {
    use fearless_simd::{f32x4, f64x2};

    use crate::level::Neon;
    use crate::number::Lanes;

    type N = <Neon as Level>::Token;

    outputs::<K, f32, Neon, Plain>(v);
    exits::<K, f32, Neon, Fused>(v);
    if K::F64 {
        exits::<K, f64, Neon, Plain>(v);
    }
    if K::PACKETS {
        outputs::<K, Lanes<N, f32x4<N>>, Neon, Plain>(v);
        exits::<K, Lanes<N, f32x4<N>>, Neon, Fused>(v);
        exits::<K, Lanes<N, f64x2<N>>, Neon, Plain>(v);
        exits::<K, Lanes<N, f64x2<N>>, Neon, Fused>(v);
    }
}

/// The forms with every output, and the axes that are compared at two places only.
fn outputs<K: Offers, R: On<L>, L: Level, A: Rounding>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    exits::<K, R, L, A>(v);
    asked_otherwise::<K, R, L, Early, A>(v);
    if EVERY_FORM {
        asked_otherwise::<K, R, L, Full, A>(v);
    }
    if K::SIGN_BITS {
        form::<K, R, L, Early, Last, A, Tuv, TwoSided, SignBits, K::Native, 0>(v);
        form::<K, R, L, Full, Last, A, Tuv, TwoSided, SignBits, K::Native, 0>(v);
        form::<K, R, L, Early, Last, A, Tuv, TwoSided, SignBitsSafe, K::Native, 0>(v);
        form::<K, R, L, Full, Last, A, Tuv, TwoSided, SignBitsSafe, K::Native, 0>(v);
    }
    if K::PRODUCTS {
        form::<K, R, L, Early, Last, A, Tuv, TwoSided, Products, K::Native, 0>(v);
        form::<K, R, L, Full, Last, A, Tuv, TwoSided, Products, K::Native, 0>(v);
    }
    if K::BOTH_ORDERS {
        divisions_with::<K, R, L, Early, A, Tuv, TwoSided, Compare, <K::Native as Other>::Other>(v);
        divisions_with::<K, R, L, Full, A, Tuv, TwoSided, Compare, <K::Native as Other>::Other>(v);
    }
}

/// What reports or accepts less than usual, or more.
fn asked_otherwise<K: Offers, R: On<L>, L: Level, E: Exit, A: Rounding>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    divisions_with::<K, R, L, E, A, Hit, TwoSided, Compare, K::Native>(v);
    if K::UV {
        divisions_with::<K, R, L, E, A, T, TwoSided, Compare, K::Native>(v);
        divisions_with::<K, R, L, E, A, Surface, TwoSided, Compare, K::Native>(v);
    }
    if K::CULLS {
        divisions_with::<K, R, L, E, A, Tuv, Cull, Compare, K::Native>(v);
    }
}

/// Early and full.
fn exits<K: Offers, R: On<L>, L: Level, A: Rounding>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    if K::UV {
        divisions_with::<K, R, L, Early, A, Tuv, TwoSided, Compare, K::Native>(v);
        divisions_with::<K, R, L, Full, A, Tuv, TwoSided, Compare, K::Native>(v);
    } else {
        divisions_with::<K, R, L, Early, A, T, TwoSided, Compare, K::Native>(v);
        divisions_with::<K, R, L, Full, A, T, TwoSided, Compare, K::Native>(v);
    }
}

/// First and last, where the kernel has them.
pub fn divisions_with<K, R, L, E, A, O, F, C, Q>(v: &mut Vec<Variant>)
where
    K: Offers,
    R: On<L>,
    R::Element: On<L>,
    L: Level,
    E: Exit,
    A: Rounding,
    O: Output,
    F: Facing,
    C: Tests,
    Q: Leading,
{
    if K::FIRST {
        form::<K, R, L, E, First, A, O, F, C, Q, 0>(v);
    }
    if K::LAST {
        form::<K, R, L, E, Last, A, O, F, C, Q, 0>(v);
    }
}

/// The loop over pairs, of the forms that have one.
type OptionalPairs<K, E> = Option<PairsLoop<E, <K as Kernel>::Record<E>>>;

/// One variant.
fn form<K, R, L, E, D, A, O, F, C, Q, const COPY: usize>(v: &mut Vec<Variant>)
where
    K: Offers,
    R: On<L>,
    R::Element: On<L>,
    L: Level,
    E: Exit,
    D: Division,
    A: Rounding,
    O: Output,
    F: Facing,
    C: Tests,
    Q: Leading,
{
    variant::<K, Form<E, D, A, O, F, C, Q, Between>, Form<E, D, A, O, F, C, Q, Nearer>, R, L, COPY>(
        v,
    );
}

/// One variant, of its policies over pairs and over all triangles, which differ in the span alone.
pub fn variant<K, P, N, R, L, const COPY: usize>(v: &mut Vec<Variant>)
where
    K: Offers,
    P: Policy,
    N: Policy,
    R: On<L>,
    R::Element: On<L>,
    L: Level,
{
    let mut pairs: OptionalPairs<K, R::Element> = None;
    if R::LANES == 1 {
        pairs = Some(L::enter::<Pairs<K, P, R::Element>, COPY>);
    }
    let nearest = L::enter::<Nearest<K, N, R>, COPY>;
    let axes =
        Axes { drive: drive::<R>(), copy: COPY, ..Axes::of::<K, P>(R::Element::NAME, L::NAME) };
    let shape = Shape { lanes: R::LANES, rays: R::LANES, outputs: numbers::<P::Output>() };
    let loops = Loops { pairs, nearest };
    add::<K, R::Element>(v, axes, level::available::<L>, shape, loops, counted::<K, N, R>());
}

/// The loops of a form over pairs and over all triangles.
struct Loops<K: Kernel, E: Element> {
    pairs: OptionalPairs<K, E>,
    nearest: NearestLoop<E>,
}

/// Counts the work of a form that does all of it always, and reports t, u and v: of others nobody asks. The
/// conditions are constants, so that what they rule out is not even compiled.
fn counted<K: Offers, P: Policy, R: Real>() -> Option<fn() -> Work> {
    if const { !P::Exit::DEFERS_RANGE || !P::Output::UV || P::Output::SURFACE } {
        None
    } else if const { R::LANES == 1 } {
        Some(work::<K, P, 1>)
    } else {
        Some(work::<K, P, 2>)
    }
}

/// How a loop over single rays or packets is driven.
#[inline(never)]
pub fn drive<R: Real>() -> String {
    if R::LANES == 1 { "single".into() } else { format!("packet{}", R::LANES) }
}

/// How many numbers of an answer are reported.
pub fn numbers<O: Output>() -> usize {
    usize::from(O::T) + 2 * usize::from(O::UV) + 6 * usize::from(O::SURFACE)
}

/// What is the same for all forms of a kernel over an element type: built once for all of them.
#[inline(never)]
fn add<K: Offers, E: Element>(
    v: &mut Vec<Variant>,
    axes: Axes,
    available: fn() -> bool,
    shape: Shape,
    loops: Loops<K, E>,
    work: Option<fn() -> Work>,
) {
    let Loops { pairs, nearest } = loops;
    v.push(Variant {
        axes,
        about: &K::ABOUT,
        bytes_per_triangle: size_of::<K::Record<E>>(),
        available,
        pairs: pairs.map(|run| bind_pairs(K::prepare::<E>, run, exit_code::<K, E>)),
        nearest: Some(bind_nearest(shape, K::prepare::<E>, Storing::of::<Aos>(), nearest)),
        tiles: Some(bind_tiles(shape, K::prepare::<E>, Storing::of::<Aos>(), nearest)),
        preparing: Some(preparing::<K, E>),
        rays: shape.rays,
        lanes: shape.rays,
        work,
    });
}

/// Three copies of the reference kernel.
pub fn placebos(v: &mut Vec<Variant>) {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    type Base = crate::level::Sse2;
    #[cfg(target_arch = "aarch64")]
    type Base = crate::level::Neon;
    form::<MollerTrumbore, f32, Base, Early, Last, Plain, Tuv, TwoSided, Compare, Inside, 1>(v);
    form::<MollerTrumbore, f32, Base, Early, Last, Plain, Tuv, TwoSided, Compare, Inside, 2>(v);
    form::<MollerTrumbore, f32, Base, Early, Last, Plain, Tuv, TwoSided, Compare, Inside, 3>(v);
}
