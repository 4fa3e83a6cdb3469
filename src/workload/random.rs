//! Two generators, and what is made of their numbers. Nothing here may change: every published
//! result names its workload by seed.

use super::WorkloadError;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;

/// A source of numbers in the unit interval.
pub trait Unit {
    /// The next number: in [0, 1) for [`Pcg`], in [0, 1] for [`Msvc`].
    fn unit(&mut self) -> f32;
}

/// The project's generator: PCG XSL RR 128/64 (MCG), O'Neill 2014, by its 64-bit outputs alone.
#[derive(Clone, Debug)]
pub struct Pcg(Pcg64Mcg);

impl Pcg {
    /// The 128-bit state is two successive outputs of SplitMix64 (Steele, Lea, Flood 2014) started
    /// at `seed`, the first one high, with the lowest bit set as the generator demands. Seeds that
    /// are close so give states that are not.
    pub fn new(seed: u64) -> Self {
        let mut state = seed;
        let high = split_mix(&mut state);
        let low = split_mix(&mut state);
        Pcg(Pcg64Mcg::new((u128::from(high) << 64) | u128::from(low)))
    }

    /// A generator of its own for a second purpose of the same seed.
    pub fn stream(seed: u64, purpose: u64) -> Self {
        let mut state = purpose;
        Pcg::new(seed ^ split_mix(&mut state))
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// A number in [0, 1) with 53 bits: the top 53 bits times 2^-53.
    pub fn unit_f64(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// A whole number below `bound`, each equally likely (0 for a bound of 0).
    ///
    /// The high half of a 64 x 64 bit product, redrawn where the low half shows that this number
    /// had one chance too many (Lemire 2019, "Fast random integer generation in an interval").
    pub fn below(&mut self, bound: u64) -> u64 {
        if bound == 0 {
            return 0;
        }
        let surplus = bound.wrapping_neg() % bound;
        loop {
            let product = u128::from(self.bits()) * u128::from(bound);
            if product as u64 >= surplus {
                return (product >> 64) as u64;
            }
        }
    }

    /// Puts the items into a random order (Fisher and Yates, from the last item down).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            let other = self.below(last as u64 + 1) as usize;
            items.swap(last, other);
        }
    }

    /// A random permutation of `0..count`.
    pub fn permutation(&mut self, count: u32) -> Vec<u32> {
        let mut items: Vec<u32> = (0..count).collect();
        self.shuffle(&mut items);
        items
    }
}

impl Unit for Pcg {
    /// The top 24 bits of one output, times 2^-24.
    fn unit(&mut self) -> f32 {
        (self.bits() >> 40) as f32 * (1.0 / (1u32 << 24) as f32)
    }
}

fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The 15-bit `rand()` of Visual C++, which thesis B used.
#[derive(Clone, Debug)]
pub struct Msvc(u32);

impl Msvc {
    /// As after `srand(seed)`.
    pub fn new(seed: u32) -> Self {
        Msvc(seed)
    }

    /// The next `rand()`: 0 to 32767.
    pub fn rand(&mut self) -> u16 {
        self.0 = self.0.wrapping_mul(214_013).wrapping_add(2_531_011);
        ((self.0 >> 16) & 0x7fff) as u16
    }
}

impl Unit for Msvc {
    /// `rand() / 32767`, divided in f32: 0 and 1 both occur.
    fn unit(&mut self) -> f32 {
        f32::from(self.rand()) / 32767.0
    }
}

/// Which generator draws a workload's coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Generator {
    /// [`Pcg`].
    #[default]
    Pcg,
    /// [`Msvc`]; the seed must fit into 32 bits.
    Msvc,
}

impl Generator {
    /// The generator, started at `seed`.
    ///
    /// # Errors
    /// [`WorkloadError::Seed`] for a seed that the 15-bit generator cannot hold.
    pub fn start(self, seed: u64) -> Result<Source, WorkloadError> {
        match self {
            Generator::Pcg => Ok(Source::Pcg(Pcg::new(seed))),
            Generator::Msvc => u32::try_from(seed)
                .map(|seed| Source::Msvc(Msvc::new(seed)))
                .map_err(|_| WorkloadError::Seed { value: seed, high: u64::from(u32::MAX) }),
        }
    }
}

/// A generator that has been started.
#[derive(Clone, Debug)]
pub enum Source {
    /// The project's.
    Pcg(Pcg),
    /// The thesis's.
    Msvc(Msvc),
}

impl Unit for Source {
    fn unit(&mut self) -> f32 {
        match self {
            Source::Pcg(pcg) => pcg.unit(),
            Source::Msvc(msvc) => msvc.unit(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pcg_outputs_are_golden() {
        let mut pcg = Pcg::new(1);
        let drawn: Vec<u64> = (0..3).map(|_| pcg.bits()).collect();
        // Computed a second time from the definitions alone, in another language.
        let golden: [u64; 3] =
            [957_873_715_440_576_536, 12_398_400_452_474_924_614, 11_313_496_995_139_904_887];
        assert_eq!(drawn, golden);
    }

    #[test]
    fn split_mix_matches_its_reference_vector() {
        // The first outputs for state 1234567, from the reference implementation by Vigna.
        let mut state = 1_234_567;
        assert_eq!(split_mix(&mut state), 6_457_827_717_110_365_317);
        assert_eq!(split_mix(&mut state), 3_203_168_211_198_807_973);
    }

    #[test]
    fn msvc_is_the_known_sequence_after_srand_1() {
        let mut msvc = Msvc::new(1);
        let drawn: Vec<u16> = (0..5).map(|_| msvc.rand()).collect();
        assert_eq!(drawn, [41, 18467, 6334, 26500, 19169]);
    }

    #[test]
    fn units_stay_in_their_interval_and_reach_its_ends() {
        let mut pcg = Pcg::new(7);
        let mut msvc = Msvc::new(7);
        let (mut least, mut most) = (1.0f32, 0.0f32);
        let mut ends = (false, false);
        for _ in 0..300_000 {
            let x = pcg.unit();
            assert!((0.0..1.0).contains(&x));
            (least, most) = (least.min(x), most.max(x));
            let y = msvc.unit();
            assert!((0.0..=1.0).contains(&y));
            ends = (ends.0 || y == 0.0, ends.1 || y == 1.0);
        }
        assert!(least < 1e-4 && most > 0.9999, "{least} {most}");
        assert_eq!(ends, (true, true));
    }

    #[test]
    fn below_is_even_over_a_bound_that_is_no_power_of_two() {
        let mut pcg = Pcg::new(3);
        let n = 70_000.0f64;
        let mut counts = [0u32; 7];
        for _ in 0..70_000 {
            counts[pcg.below(7) as usize] += 1;
        }
        let deviation = (n * (1.0 / 7.0) * (6.0 / 7.0)).sqrt();
        for count in counts {
            assert!((f64::from(count) - n / 7.0).abs() < 5.0 * deviation, "{counts:?}");
        }
    }

    #[test]
    fn every_order_of_three_is_equally_likely() {
        let mut pcg = Pcg::new(5);
        let mut counts = [0u32; 9];
        for _ in 0..60_000 {
            let order = pcg.permutation(3);
            counts[(order[0] * 3 + order[1]) as usize] += 1;
        }
        let deviation = (60_000.0 * (1.0 / 6.0) * (5.0 / 6.0f64)).sqrt();
        let drawn: Vec<u32> = counts.into_iter().filter(|count| *count > 0).collect();
        assert_eq!(drawn.len(), 6);
        for count in drawn {
            assert!((f64::from(count) - 10_000.0).abs() < 5.0 * deviation, "{counts:?}");
        }
    }

    #[test]
    fn a_seed_too_wide_for_msvc_is_refused() {
        let error = Generator::Msvc.start(1 << 32).map(|_| ()).unwrap_err();
        assert_eq!(
            error.to_string(),
            "seed is 4294967296; allowed for the generator msvc is 0 to 4294967295"
        );
    }
}
