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

/// What a loop over pairs reads. Two loops, because an index that is stepped by 0 or 1 would need a
/// bounds check, and its jump, in every test.
pub struct Walk<'a, T> {
    /// Ray and record of every pair; one pair where it is repeated in a row.
    pub pairs: &'a [T],
    /// How often they are done, from start to end.
    pub times: usize,
}

impl<L: Level, K: Kernel, P: Policy, E: Element + On<L>> Batch<L> for Pairs<K, P, E> {
    type Data<'a> = Walk<'a, (Ray<E>, K::Record<E>)>;
    type Yield = Tally;

    #[inline(always)]
    fn run(_: L::Token, walk: Self::Data<'_>) -> Tally {
        let mut sums = Sums::default();
        for _ in 0..walk.times {
            for (ray, record) in walk.pairs {
                // The fence: without it the optimiser tests several pairs at once where nothing branches.
                black_box(());
                let (aim, met) = (K::aim::<P, E>(ray), K::meet::<P, E>((), record));
                if let Ok(found) = K::test::<P, E>(ray, &aim, &met) {
                    report::<P, E>(&mut sums, ray, &found, K::normal::<P, E>(&met));
                }
            }
        }
        Tally { hits: sums.hits, bits: sums.bits }
    }
}
