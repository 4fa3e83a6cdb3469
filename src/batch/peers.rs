//! Ray i against triangle i, by the test of another crate.

use std::hint::black_box;
use std::marker::PhantomData;

use super::Sums;
use super::pairs::Walk;
use crate::job::Tally;
use crate::level::{Batch, Level};
use crate::peers::Peer;

/// The loop of [`super::Pairs`] around a peer; `UV` asks for u and v as well.
pub struct PeerPairs<P, const UV: bool>(PhantomData<P>);

impl<L: Level, P: Peer, const UV: bool> Batch<L> for PeerPairs<P, UV> {
    type Data<'a> = Walk<'a, (P::Ray, P::Triangle)>;
    type Yield = Tally;

    #[inline(always)]
    fn run(_: L::Token, walk: Self::Data<'_>) -> Tally {
        let mut sums = Sums::default();
        for _ in 0..walk.times {
            for (ray, triangle) in walk.pairs {
                // The fence of our own loop.
                black_box(());
                if let Some([t, u, v]) = P::test::<UV>(ray, triangle) {
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
