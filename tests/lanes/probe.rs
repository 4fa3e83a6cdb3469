//! A packet and a single ray through the same form, and what makes them the same.

use std::marker::PhantomData;

use ray_test::kernels::Kernel;
use ray_test::level::{Batch, Level, On};
use ray_test::number::{Element, Mask, Real, Vec3};
use ray_test::policy::{Policy, Ray};

use crate::packets::{Packet, RAYS};

/// What one ray finds: whether the test was left early, the hit, then t, u, v and the normal.
#[derive(Clone, Copy)]
pub struct Lane<E> {
    left: bool,
    hit: bool,
    numbers: [E; 6],
}

/// One packet through a form, inside its level.
pub struct Probe<K, P, R>(PhantomData<(K, P, R)>);

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
            let ray = load(token, rays);
            let found = K::test::<P, R>(&ray, &K::aim::<P, R>(&ray), &met);
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
    lanes.extend((0..R::LANES).map(|lane| {
        let numbers = std::array::from_fn(|i| stored[i][lane]);
        Lane { left, hit: hit.lane(lane), numbers }
    }));
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
    lane.hit == scalar.hit && compared.into_iter().all(|i| same(lane.numbers[i], scalar.numbers[i]))
}

/// Whether the one that hits does so with numbers that are not finite.
fn hits_without_numbers<E: Element>(lane: &Lane<E>, scalar: &Lane<E>) -> bool {
    let hit = if lane.hit { lane } else { scalar };
    let finite = |x: E| x.signed_by(x).le(E::MAX);
    hit.hit && !hit.numbers[..3].iter().all(|x| finite(*x))
}

/// The scalar kernel for every ray of a packet, not in any level's shell.
pub fn scalars<K: Kernel, P: Policy, E: Element>(packet: &Packet<E>) -> Vec<Lane<E>> {
    let record = K::prepare(&packet.corners);
    packet.rays.iter().map(|ray| scalar::<K, P, E>(ray, &record)).collect()
}

fn scalar<K: Kernel, P: Policy, E: Element>(ray: &Ray<E>, record: &K::Record<E>) -> Lane<E> {
    let met = K::meet::<P, E>((), record);
    let [x, y, z] = K::normal::<P, E>(&met).0;
    match K::test::<P, E>(ray, &K::aim::<P, E>(ray), &met) {
        Ok(found) => {
            Lane { left: false, hit: found.hit, numbers: [found.t, found.u, found.v, x, y, z] }
        }
        Err(_) => Lane { left: true, hit: false, numbers: [E::ZERO, E::ZERO, E::ZERO, x, y, z] },
    }
}

/// Lanes, hits, lanes with a NaN, and lanes excused.
pub fn judge<E: Element>(
    form: &str,
    sign_bits: bool,
    family: &str,
    lanes: &[Lane<E>],
    scalars: &[Lane<E>],
) -> [usize; 4] {
    let mut counts = [lanes.len(), 0, 0, 0];
    assert_eq!(lanes.len(), scalars.len());
    for (i, (lane, scalar)) in lanes.iter().zip(scalars).enumerate() {
        let excused = lane.hit != scalar.hit
            && sign_bits
            && family != "random"
            && hits_without_numbers(lane, scalar);
        assert!(
            excused || agrees(lane, scalar),
            "{form}, ray {i} of {family}: {} {:?}, scalar {} {:?}",
            lane.hit,
            lane.numbers.map(Element::to_f64),
            scalar.hit,
            scalar.numbers.map(Element::to_f64),
        );
        counts[1] += usize::from(lane.hit);
        counts[2] += usize::from(lane.numbers.iter().any(|x| x.ne(*x)));
        counts[3] += usize::from(excused);
    }
    counts
}
