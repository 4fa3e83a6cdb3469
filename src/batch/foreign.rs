//! Ray i against triangle i, by a test that is not written over our numbers.

use std::hint::black_box;
use std::marker::PhantomData;

use super::Sums;
use super::pairs::Walk;
use crate::job::Tally;
use crate::level::{Batch, Level};
use crate::number::Element;

/// A test of another crate, or of whoever uses this one, in types of its own.
pub trait Foreign: 'static {
    /// What it computes in.
    type Number: Element;
    /// Its ray, with the bounds of t that it takes.
    type Ray: Copy + 'static;
    /// What it reads of a triangle.
    type Triangle: Copy + 'static;

    /// t, u and v of a hit, in units and weights of ours; u and v mean nothing unless `UV`.
    fn test<const UV: bool>(
        ray: &Self::Ray,
        triangle: &Self::Triangle,
    ) -> Option<[Self::Number; 3]>;
}

/// The loop of [`super::Pairs`] around a foreign test; `UV` asks for u and v as well.
pub struct ForeignPairs<F, const UV: bool>(PhantomData<F>);

impl<L: Level, F: Foreign, const UV: bool> Batch<L> for ForeignPairs<F, UV> {
    type Data<'a> = Walk<'a, (F::Ray, F::Triangle)>;
    type Yield = Tally;

    #[inline(always)]
    fn run(_: L::Token, walk: Self::Data<'_>) -> Tally {
        let mut sums = Sums::default();
        for _ in 0..walk.times {
            for (ray, triangle) in walk.pairs {
                // The fence of our own loop.
                black_box(());
                if let Some([t, u, v]) = F::test::<UV>(ray, triangle) {
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
