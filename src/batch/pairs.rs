//! Ray i against triangle i.

use std::hint::black_box;
use std::marker::PhantomData;

use super::{Sums, report};
use crate::job::Tally;
use crate::kernels::Kernel;
use crate::level::{Batch, Level, On};
use crate::number::Element;
use crate::policy::{Policy, Ray};

/// One loop over pairs: each pair is stored whole, so that a test reads one stretch of memory.
pub struct Pairs<K, P, E>(PhantomData<(K, P, E)>);

/// What a loop over pairs reads: the pairs, where to start, how far to go on from test to test
/// (0 repeats one pair in a row), and the number of tests.
pub struct Walk<'a, T> {
    /// Ray and record of every pair.
    pub pairs: &'a [T],
    /// The first pair; `first + step * (count - 1)` is below the number of pairs.
    pub first: usize,
    /// 0 or 1.
    pub step: usize,
    /// Number of tests.
    pub count: usize,
}

impl<L: Level, K: Kernel, P: Policy, E: Element + On<L>> Batch<L> for Pairs<K, P, E> {
    type Data<'a> = Walk<'a, (Ray<E>, K::Record<E>)>;
    type Yield = Tally;

    #[inline(always)]
    fn run(_: L::Token, walk: Self::Data<'_>) -> Tally {
        let mut sums = Sums::default();
        let mut at = walk.first;
        for _ in 0..walk.count {
            // The fence: without it the optimiser tests several pairs at once where nothing branches.
            black_box(());
            let Some((ray, record)) = walk.pairs.get(at) else { break };
            at += walk.step;
            let met = K::meet::<P, E>((), record);
            if let Ok(found) = K::test::<P, E>(ray, &met) {
                report::<P, E>(&mut sums, ray, &found, K::normal::<P, E>(&met));
            }
        }
        Tally { hits: sums.hits, bits: sums.bits }
    }
}
