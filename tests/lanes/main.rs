//! Law 3: lane i of a packet is the scalar kernel of the same policy, bit for bit.
//!
//! Any NaN equals any NaN: neither its payload nor its sign is specified. The sign-bit forms look at
//! that sign, as printed, so where what they report is not finite their hit may differ, too; such
//! lanes are counted, and none may be of the random family, whose triangles have an area and whose
//! products do not overflow.
//!
//! Forms with estimated reciprocals are not held to the law: a scalar has no estimate, and those of two
//! levels differ. What they are held to stands in `tests/techniques.rs`.

mod packets;
mod probe;

use std::any::type_name;
use std::collections::BTreeMap;

use ray_test::kernels::Kernel;
use ray_test::level::{self, Level, On};
use ray_test::number::{Element, Lanes, Real};
use ray_test::policy::{
    Between, Compare, Cull, Division, Early, Exit, Facing, First, Form, FromZero, Full, Fused,
    Last, Leading, Once, Plain, Policy, Products, Rounding, SignBits, SignBitsSafe, Span, Tests,
    Tuv, TwoSided,
};
use ray_test::registry::{KernelVisitor, Offers, Other, visit_kernels};

use packets::{FAMILIES, Packet, packets};
use probe::{Lane, Probe, judge, scalars};

/// The packets of both precisions, and what has been compared.
struct Law {
    singles: Vec<Packet<f32>>,
    doubles: Vec<Packet<f64>>,
    /// Per level: forms compared, or None where this processor has not got it.
    levels: BTreeMap<&'static str, Option<usize>>,
    /// Per family: the sums of [`judge`].
    families: BTreeMap<&'static str, [usize; 4]>,
}

impl KernelVisitor for Law {
    fn kernel<K: Offers>(&mut self) {
        if K::PACKETS {
            kernel::<K>(self);
        }
    }
}

/// Which packets an element type has.
trait Precision: Element {
    fn packets(law: &Law) -> &[Packet<Self>];
}
impl Precision for f32 {
    fn packets(law: &Law) -> &[Packet<f32>] {
        &law.singles
    }
}
impl Precision for f64 {
    fn packets(law: &Law) -> &[Packet<f64>] {
        &law.doubles
    }
}

/// One form at one level, and its scalar.
struct Held<E> {
    name: String,
    level: &'static str,
    /// Whether the processor has the level.
    available: bool,
    sign_bits: bool,
    lanes: fn(&Packet<E>) -> Vec<Lane<E>>,
    scalars: fn(&Packet<E>) -> Vec<Lane<E>>,
}

/// One form at one level against its scalar.
fn hold<K: Kernel, P: Policy, L: Level, R: Real<Element: Precision> + On<L>>(law: &mut Law) {
    law.compare(&Held {
        name: format!("{} {} {} x{}", K::ABOUT.id, type_name::<P>(), L::NAME, R::LANES),
        level: L::NAME,
        available: level::available::<L>(),
        sign_bits: P::Tests::SIGN_BITS,
        lanes: |packet| {
            let record = K::prepare(&packet.corners);
            L::enter::<Probe<K, P, R>, 0>((&packet.rays, &record))
        },
        scalars: scalars::<K, P, R::Element>,
    });
}

impl Law {
    // Not inlined, and told of a form by pointers: one copy a precision instead of one a form keeps
    // the test quick to build.
    #[inline(never)]
    fn compare<E: Precision>(&mut self, form: &Held<E>) {
        let count = self.levels.entry(form.level).or_insert(form.available.then_some(0));
        let Some(count) = count else { return };
        *count += 1;
        let judged = |packet: &Packet<E>| {
            let (lanes, scalars) = ((form.lanes)(packet), (form.scalars)(packet));
            (packet.family, judge(&form.name, form.sign_bits, packet.family, &lanes, &scalars))
        };
        for (family, counts) in E::packets(self).iter().map(judged).collect::<Vec<_>>() {
            let sums = self.families.entry(family).or_default();
            sums.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
        }
    }
}

/// Early and full, first and last: what every width is built in.
fn exits<K: Offers, L: Level, R, A: Rounding, F: Facing, Q: Leading, S: Span>(law: &mut Law)
where
    R: Real<Element: Precision> + On<L>,
{
    divisions::<K, L, R, Early, A, F, Q, S>(law);
    divisions::<K, L, R, Full, A, F, Q, S>(law);
}

fn divisions<K, L, R, E, A, F, Q, S>(law: &mut Law)
where
    K: Offers,
    L: Level,
    R: Real<Element: Precision> + On<L>,
    E: Exit,
    A: Rounding,
    F: Facing,
    Q: Leading,
    S: Span,
{
    if K::FIRST {
        form::<K, L, R, E, First, A, F, Compare, Q, S>(law);
    }
    if K::LAST {
        form::<K, L, R, E, Last, A, F, Compare, Q, S>(law);
    }
}

#[allow(clippy::extra_unused_type_parameters, reason = "one parameter per axis")]
fn form<K, L, R, E, D, A, F, C, Q, S>(law: &mut Law)
where
    K: Offers,
    L: Level,
    R: Real<Element: Precision> + On<L>,
    E: Exit,
    D: Division,
    A: Rounding,
    F: Facing,
    C: Tests,
    Q: Leading,
    S: Span,
{
    hold::<K, Form<E, D, A, Tuv, F, C, Q, S>, L, R>(law);
}

/// The axes that only some kernels have.
fn others<K: Offers, L: Level, R: Real<Element: Precision> + On<L>>(law: &mut Law) {
    exits::<K, L, R, Plain, TwoSided, K::Native, Between>(law);
    if K::CULLS {
        exits::<K, L, R, Plain, Cull, K::Native, FromZero>(law);
    }
    if K::BOTH_ORDERS {
        exits::<K, L, R, Plain, TwoSided, <K::Native as Other>::Other, FromZero>(law);
    }
    if K::SIGN_BITS {
        form::<K, L, R, Early, Last, Plain, TwoSided, SignBits, K::Native, FromZero>(law);
        form::<K, L, R, Full, Last, Plain, TwoSided, SignBits, K::Native, FromZero>(law);
        form::<K, L, R, Early, Last, Plain, TwoSided, SignBitsSafe, K::Native, FromZero>(law);
        form::<K, L, R, Full, Last, Plain, TwoSided, SignBitsSafe, K::Native, Between>(law);
    }
    if K::TECHNIQUES {
        divisions::<K, L, R, Once, Plain, TwoSided, K::Native, FromZero>(law);
    }
    if K::PRODUCTS {
        form::<K, L, R, Early, Last, Plain, TwoSided, Products, K::Native, FromZero>(law);
        form::<K, L, R, Full, Last, Plain, TwoSided, Products, K::Native, FromZero>(law);
    }
}

fn plain<K: Offers, L: Level, R: Real<Element: Precision> + On<L>>(law: &mut Law) {
    exits::<K, L, R, Plain, TwoSided, K::Native, FromZero>(law);
}

fn fused<K: Offers, L: Level, R: Real<Element: Precision> + On<L>>(law: &mut Law) {
    exits::<K, L, R, Fused, TwoSided, K::Native, FromZero>(law);
}

/// Every width that the registry builds, at the level that has it.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn kernel<K: Offers>(law: &mut Law) {
    use fearless_simd::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
    use ray_test::level::{Avx2, Avx512, Sse2, Sse42};

    type In<L, V> = Lanes<<L as Level>::Token, V>;
    type S2 = <Sse2 as Level>::Token;
    type S4 = <Sse42 as Level>::Token;
    type A2 = <Avx2 as Level>::Token;
    type A5 = <Avx512 as Level>::Token;

    plain::<K, Sse2, In<Sse2, f32x4<S2>>>(law);
    plain::<K, Sse2, In<Sse2, f64x2<S2>>>(law);
    plain::<K, Sse42, In<Sse42, f32x4<S4>>>(law);
    plain::<K, Avx2, In<Avx2, f32x8<A2>>>(law);
    plain::<K, Avx2, In<Avx2, f64x4<A2>>>(law);
    plain::<K, Avx512, In<Avx512, f32x16<A5>>>(law);
    plain::<K, Avx512, In<Avx512, f64x8<A5>>>(law);
    fused::<K, Avx2, In<Avx2, f32x8<A2>>>(law);
    fused::<K, Avx2, In<Avx2, f64x4<A2>>>(law);
    fused::<K, Avx512, In<Avx512, f32x16<A5>>>(law);
    fused::<K, Avx512, In<Avx512, f64x8<A5>>>(law);
    others::<K, Sse2, In<Sse2, f32x4<S2>>>(law);
    others::<K, Avx512, In<Avx512, f32x16<A5>>>(law);
}

/// Every width that the registry builds, at the level that has it.
#[cfg(target_arch = "aarch64")]
fn kernel<K: Offers>(law: &mut Law) {
    use fearless_simd::{f32x4, f64x2};
    use ray_test::level::Neon;

    type N = <Neon as Level>::Token;

    plain::<K, Neon, Lanes<N, f32x4<N>>>(law);
    plain::<K, Neon, Lanes<N, f64x2<N>>>(law);
    fused::<K, Neon, Lanes<N, f32x4<N>>>(law);
    fused::<K, Neon, Lanes<N, f64x2<N>>>(law);
    others::<K, Neon, Lanes<N, f32x4<N>>>(law);
}

/// Every kernel that has packets (the sum of angles is single: its arc cosine is `libm`'s; Moeller-Trumbore in f64
/// is, too).
#[test]
fn lanes_agree_bit_for_bit() {
    let mut law = Law {
        singles: packets(),
        doubles: packets(),
        levels: BTreeMap::new(),
        families: BTreeMap::new(),
    };
    visit_kernels(&mut law);

    let skipped = law.levels.iter().filter(|(_, forms)| forms.is_none()).count();
    for (level, forms) in &law.levels {
        match forms {
            Some(forms) => println!("{level}: {forms} forms"),
            None => println!("skipped: no {level}"),
        }
    }
    println!("{skipped} levels skipped; lanes, hits, NaN, excused by family: {:?}", law.families);
    assert_eq!(law.levels.len(), level::levels().len(), "a level without a packet");
    assert!(skipped < law.levels.len(), "the baseline is there on every processor");
    for family in FAMILIES {
        let [lanes, hits, nan, _] = law.families[family];
        assert!(hits * 100 >= lanes || family == "subnormal", "{family}: {hits} hits of {lanes}");
        assert!(nan * 100 >= lanes || ["random", "lattice"].contains(&family), "{family}: {nan}");
    }
}
