//! Point i of triangle i's plane against triangle i.

use std::hint::black_box;
use std::marker::PhantomData;

use super::Sums;
use super::pairs::Walk;
use crate::job::Tally;
use crate::kernels::PointTest;
use crate::level::{Batch, Level, On};
use crate::number::Element;
use crate::policy::{Exit, Policy, Ray};

/// The loop of [`super::Pairs`] around a point test; the point is the ray's `end`.
pub struct Points<K, P, E>(PhantomData<(K, P, E)>);

impl<L: Level, K: PointTest, P: Policy, E: Element + On<L>> Batch<L> for Points<K, P, E> {
    type Data<'a> = Walk<'a, (Ray<E>, K::Record<E>)>;
    type Yield = Tally;

    #[inline(always)]
    fn run(_: L::Token, walk: Self::Data<'_>) -> Tally {
        let mut sums = Sums::default();
        for _ in 0..walk.times {
            for (ray, record) in walk.pairs {
                black_box(());
                let met = K::meet::<P, E>((), record);
                if let Ok((hit, u, v)) = K::contains::<P, E>(&ray.end, &met) {
                    sums.add(P::Exit::spread(hit), &[E::ZERO, u, v]);
                }
            }
        }
        Tally { hits: sums.hits, bits: sums.bits }
    }
}
