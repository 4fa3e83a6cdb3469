//! Ray i against triangle i, by a published listing.

use std::hint::black_box;
use std::marker::PhantomData;

use super::Sums;
use super::pairs::Walk;
use crate::job::Tally;
use crate::kernels::listings::{Listing, Script};
use crate::level::{Batch, Level, On};
use crate::number::Element;
use crate::policy::Ray;

/// The loop of [`super::Pairs`] around a listing.
pub struct Listed<K, S, E, const UV: bool>(PhantomData<(K, S, E)>);

impl<L, K, S, E, const UV: bool> Batch<L> for Listed<K, S, E, UV>
where
    L: Level,
    K: Listing,
    S: Script,
    E: Element + On<L>,
{
    type Data<'a> = Walk<'a, (Ray<E>, K::Record<E>)>;
    type Yield = Tally;

    #[inline(always)]
    fn run(_: L::Token, walk: Self::Data<'_>) -> Tally {
        let mut sums = Sums::default();
        for _ in 0..walk.times {
            for (ray, record) in walk.pairs {
                black_box(());
                let (code, t, u, v) = K::run::<E, S, UV>(ray, record);
                if code == 0 {
                    if UV {
                        sums.add(u64::MAX, &[t, u, v]);
                    } else {
                        sums.add(u64::MAX, &[t]);
                    }
                }
            }
        }
        Tally { hits: sums.hits, bits: sums.bits }
    }
}
