//! Point i of triangle i's plane against triangle i.

use std::hint::black_box;
use std::marker::PhantomData;

use super::Sums;
use super::pairs::Walk;
use crate::job::Tally;
use crate::kernels::PointTest;
use crate::level::{Batch, Level, On};
use crate::number::Element;
use crate::policy::{Policy, Ray};

/// The loop of [`super::Pairs`] around a point test; the point is the ray's `end`.
pub struct Points<K, P, E>(PhantomData<(K, P, E)>);

impl<L: Level, K: PointTest, P: Policy, E: Element + On<L>> Batch<L> for Points<K, P, E> {
    type Data<'a> = Walk<'a, (Ray<E>, K::Record<E>)>;
    type Yield = Tally;

    #[inline(always)]
    fn run(_: L::Token, walk: Self::Data<'_>) -> Tally {
        let mut sums = Sums::default();
        let mut at = walk.first;
        for _ in 0..walk.count {
            black_box(());
            let Some((ray, record)) = walk.pairs.get(at) else { break };
            at += walk.step;
            let met = K::meet::<P, E>((), record);
            if let Ok((hit, u, v)) = K::contains::<P, E>(&ray.end, &met) {
                sums.add(hit, &[E::ZERO, u, v]);
            }
        }
        Tally { hits: sums.hits, bits: sums.bits }
    }
}
