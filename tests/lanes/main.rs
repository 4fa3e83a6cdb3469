//! Law 3: lane i of a packet is the scalar kernel of the same policy, bit for bit.
//!
//! Any NaN equals any NaN: neither its payload nor its sign is specified. The sign-bit forms look at
//! that sign, as printed, so where what they report is not finite their hit may differ, too; such
//! lanes are counted, and none may be of a family that does not overflow.

mod packets;

use std::any::type_name;
use std::collections::BTreeMap;
use std::marker::PhantomData;

use ray_test::kernels::{
    BadouelCramer, Chirkov, HalfSpaces, Keidy, KenslerShirley, Kernel, MollerTrumbore,
    PerpendicularPlanes, Plucker, Precomputed, Shevtsov, SignedAreas, Vertices, Wald, WithNormal,
};
use ray_test::level::{self, Batch, Level, On, enter};
use ray_test::number::{Element, Lanes, Mask, Real, Vec3};
use ray_test::policy::{
    Between, Compare, Cull, Division, Early, Exit, Facing, First, Form, FromZero, Full, Fused, Last,
    Leading, Plain, Policy, Products, Ray, Rounding, SignBits, Span, Tests, Tuv, TwoSided,
};
use ray_test::registry::{Offers, Other};

use packets::{FAMILIES, Packet, RAYS, packets};

/// What one ray finds: whether the test was left early, the hit, then t, u, v and the normal.
#[derive(Clone, Copy)]
struct Lane<E> {
    left: bool,
    hit: bool,
    numbers: [E; 6],
}

/// The packets of both precisions, and what has been compared.
struct Law {
    singles: Vec<Packet<f32>>,
    doubles: Vec<Packet<f64>>,
    /// Per level: forms compared, or None where this processor has not got it.
    levels: BTreeMap<&'static str, Option<usize>>,
    /// Per family: the sums of [`judge`].
    families: BTreeMap<&'static str, [usize; 4]>,
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

/// One packet through a form, inside its level.
struct Probe<K, P, R>(PhantomData<(K, P, R)>);

impl<L: Level, K: Kernel, P: Policy, R: Real + On<L>> Batch<L> for Probe<K, P, R> {
    type Data<'a> = (&'a [Ray<R::Element>], &'a K::Record<R::Element>);
    type Yield = Vec<Lane<R::Element>>;

    #[inline(always)]
    fn run(token: L::Token, (rays, record): Self::Data<'_>) -> Self::Yield {
        let token = R::token_on(token);
        let mut lanes = Vec::with_capacity(rays.len());
        for rays in rays.chunks_exact(R::LANES) {
            let met = K::meet::<P, R>(token, record);
            let normal = K::normal::<P, R>(&met);
            let found = K::test::<P, R>(&load(token, rays), &met);
            let (left, hit, [t, u, v]) = match found {
                Ok(found) => (false, found.hit, [found.t, found.u, found.v]),
                Err(_) => (true, R::mask(token, false), normal.0),
            };
            let [x, y, z] = normal.0;
            collect::<R>(&mut lanes, left, hit, [t, u, v, x, y, z]);
        }
        lanes
    }
}

// Not inlined: one copy a number instead of one a form keeps the test quick to build.
#[inline(never)]
fn collect<R: Real>(lanes: &mut Vec<Lane<R::Element>>, left: bool, hit: R::Mask, numbers: [R; 6]) {
    let mut stored = [[R::Element::ZERO; RAYS]; 6];
    for (place, number) in stored.iter_mut().zip(numbers) {
        number.store(place);
    }
    for lane in 0..R::LANES {
        let numbers = std::array::from_fn(|i| stored[i][lane]);
        lanes.push(Lane { left, hit: hit.lane(lane), numbers });
    }
}

#[inline(never)]
fn load<R: Real>(token: R::Token, rays: &[Ray<R::Element>]) -> Ray<R> {
    let gather = |number: &dyn Fn(&Ray<R::Element>) -> R::Element| {
        let mut place = [R::Element::ZERO; RAYS];
        for (place, ray) in place.iter_mut().zip(rays) {
            *place = number(ray);
        }
        R::load(token, &place)
    };
    Ray {
        origin: Vec3(std::array::from_fn(|i| gather(&|ray| ray.origin.0[i]))),
        direction: Vec3(std::array::from_fn(|i| gather(&|ray| ray.direction.0[i]))),
        end: Vec3(std::array::from_fn(|i| gather(&|ray| ray.end.0[i]))),
        t_min: gather(&|ray| ray.t_min),
        t_max: gather(&|ray| ray.t_max),
    }
}

/// The same bits, or a NaN each.
fn same<E: Element>(a: E, b: E) -> bool {
    a.bits() == b.bits() || (a.ne(a) && b.ne(b))
}

/// Whether a lane is what the scalar kernel found. Without a hit t, u and v mean nothing in an early
/// form, which may or may not have come to them.
fn agrees<E: Element>(lane: &Lane<E>, scalar: &Lane<E>) -> bool {
    let compared = if lane.left || scalar.left { 3..6 } else { 0..6 };
    lane.hit == scalar.hit
        && compared.into_iter().all(|i| same(lane.numbers[i], scalar.numbers[i]))
}

/// Whether the one that hits does so with numbers that are not finite.
fn hits_without_numbers<E: Element>(lane: &Lane<E>, scalar: &Lane<E>) -> bool {
    let hit = if lane.hit { lane } else { scalar };
    let finite = |x: E| x.signed_by(x).le(E::MAX);
    hit.hit && !hit.numbers[..3].iter().all(|x| finite(*x))
}

/// The scalar kernel, not in any level's shell.
#[inline(never)]
fn scalar<K: Kernel, P: Policy, E: Element>(ray: &Ray<E>, record: &K::Record<E>) -> Lane<E> {
    let met = K::meet::<P, E>((), record);
    let [x, y, z] = K::normal::<P, E>(&met).0;
    match K::test::<P, E>(ray, &met) {
        Ok(found) => Lane {
            left: false,
            hit: found.hit,
            numbers: [found.t, found.u, found.v, x, y, z],
        },
        Err(_) => Lane { left: true, hit: false, numbers: [E::ZERO, E::ZERO, E::ZERO, x, y, z] },
    }
}

/// One form at one level against its scalar.
fn hold<K: Kernel, P: Policy, L: Level, R: Real<Element: Precision> + On<L>>(law: &mut Law) {
    let count = law.levels.entry(L::NAME).or_insert_with(|| level::available::<L>().then_some(0));
    let Some(count) = count else { return };
    *count += 1;
    let form = format!("{} {} {} x{}", K::ABOUT.id, type_name::<P>(), L::NAME, R::LANES);
    let mut sums = Vec::new();
    for packet in R::Element::packets(law) {
        let record = K::prepare(&packet.corners);
        let lanes = enter::<L, Probe<K, P, R>, 0>((&packet.rays, &record));
        let scalars = packet.rays.map(|ray| scalar::<K, P, R::Element>(&ray, &record));
        sums.push((packet.family, judge(&form, P::Tests::SIGN_BITS, packet.family, &lanes, &scalars)));
    }
    for (family, counts) in sums {
        let sums = law.families.entry(family).or_default();
        sums.iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
    }
}

/// Lanes, hits, lanes with a NaN, and lanes excused.
fn judge<E: Element>(
    form: &str,
    sign_bits: bool,
    family: &str,
    lanes: &[Lane<E>],
    scalars: &[Lane<E>],
) -> [usize; 4] {
    let mut counts = [lanes.len(), 0, 0, 0];
    assert_eq!(lanes.len(), scalars.len());
    for (i, (lane, scalar)) in lanes.iter().zip(scalars).enumerate() {
        let may_overflow = !["random", "lattice"].contains(&family);
        let excused = lane.hit != scalar.hit
            && sign_bits
            && may_overflow
            && hits_without_numbers(lane, scalar);
        assert!(
            excused || agrees(lane, scalar),
            "{form}, ray {i} of {family}: {} {:?}, scalar {} {:?}",
            lane.hit, lane.numbers.map(Element::to_f64),
            scalar.hit, scalar.numbers.map(Element::to_f64),
        );
        counts[1] += usize::from(lane.hit);
        counts[2] += usize::from(lane.numbers.iter().any(|x| x.ne(*x)));
        counts[3] += usize::from(excused);
    }
    counts
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
#[cfg(target_arch = "x86_64")]
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

/// Every kernel that has packets (the sum of angles is single: its arc cosine is `libm`'s).
#[test]
fn lanes_agree_bit_for_bit() {
    let mut law = Law {
        singles: packets(),
        doubles: packets(),
        levels: BTreeMap::new(),
        families: BTreeMap::new(),
    };
    kernel::<MollerTrumbore>(&mut law);
    kernel::<KenslerShirley<Vertices>>(&mut law);
    kernel::<KenslerShirley<WithNormal>>(&mut law);
    kernel::<KenslerShirley<Precomputed>>(&mut law);
    kernel::<Shevtsov>(&mut law);
    kernel::<BadouelCramer>(&mut law);
    kernel::<Wald>(&mut law);
    kernel::<Keidy<Vertices>>(&mut law);
    kernel::<Keidy<WithNormal>>(&mut law);
    kernel::<PerpendicularPlanes>(&mut law);
    kernel::<Chirkov>(&mut law);
    kernel::<Plucker>(&mut law);
    kernel::<HalfSpaces>(&mut law);
    kernel::<SignedAreas>(&mut law);

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
