//! Several single rays that share what is done once per triangle (thesis H, 4.2: a gain "even
//! without SSE").

use std::hint::black_box;
use std::marker::PhantomData;

use super::best::{ANSWER_NUMBERS, Best};
use super::layout::{Aos, Layout};
use super::nearest::{RAY_NUMBERS, Scene, load, places};
use crate::kernels::Kernel;
use crate::level::{Batch, Level, On};
use crate::number::Element;
use crate::policy::Policy;

/// One loop over bundles of `N` rays and all triangles. Each ray is tested, and leaves, by itself.
pub struct Bundle<K, P, E, const N: usize>(PhantomData<(K, P, E)>);

impl<L, K, P, E, const N: usize> Batch<L> for Bundle<K, P, E, N>
where
    L: Level,
    K: Kernel,
    P: Policy,
    E: Element + On<L>,
{
    type Data<'a> = Scene<'a, E>;
    type Yield = ();

    #[inline(always)]
    fn run(_: L::Token, scene: Self::Data<'_>) {
        let bundles = scene.rays.chunks_exact(RAY_NUMBERS * N);
        for (rays, answers) in bundles.zip(scene.answers.chunks_exact_mut(ANSWER_NUMBERS * N)) {
            let mut bundle = [load::<E>((), &rays[..RAY_NUMBERS]); N];
            for (ray, numbers) in bundle.iter_mut().zip(rays.chunks_exact(RAY_NUMBERS)) {
                *ray = load::<E>((), numbers);
            }
            let mut best = [Best::nothing((), &bundle[0]); N];
            let mut aims = [K::aim::<P, E>(&bundle[0]); N];
            for i in 0..N {
                best[i] = Best::nothing((), &bundle[i]);
                aims[i] = K::aim::<P, E>(&bundle[i]);
            }
            let mut index = E::ZERO;
            for triangle in Aos::walk(scene.numbers, places::<K, E>(), scene.triangles) {
                let met = K::read::<P, E, _>(&triangle);
                for i in 0..N {
                    // The fence: without it the optimiser tests several rays at once.
                    black_box(());
                    if let Ok(found) = K::test::<P, E>(&bundle[i], &aims[i], &met) {
                        let normal = K::normal::<P, E>(&met);
                        best[i].update::<P>(&mut bundle[i], &found, index, normal);
                    }
                }
                index = index + E::ONE;
            }
            for ((best, ray), answer) in
                best.iter().zip(&bundle).zip(answers.chunks_exact_mut(ANSWER_NUMBERS))
            {
                best.write::<P>(ray, answer);
            }
        }
    }
}
