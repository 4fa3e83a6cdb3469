//! Where the calls of thesis B's methods end, over a million of its pairs (tables 4.5 and 4.7):
//! line query, no clock.

use ray_test::batch::widened;
use ray_test::kernels::listings::{Badouel, Listing, Literally, Moller};
use ray_test::registry::corners;
use ray_test::workload::{Generator, draw_pairs};

const PAIRS: usize = 1_000_000;

/// Calls by return code.
fn codes<K: Listing, const N: usize>(generator: Generator, seed: u64) -> [u64; N] {
    let mut codes = [0; N];
    draw_pairs(generator, seed, PAIRS, |ray, triangle| {
        let record = K::prepare(&corners::<f32>(&triangle));
        codes[usize::from(K::run::<f32, Literally, false>(&widened(&ray), &record).0)] += 1;
    })
    .unwrap();
    codes
}

/// Whether two counts of a million draws each can be of one probability.
///
/// Large counts: within five standard errors of the difference, sqrt(2 p (1 - p) / n) each way.
/// Small counts (below 100, where the normal approximation to the tail is poor): two Poisson counts
/// of one rate with the sum s are, given s, Binomial(s, 1/2); the smaller one must not lie in a
/// tail of less than 2.87e-7, which is that of five standard errors.
fn agree(published: u64, found: u64) -> bool {
    if published >= 100 {
        let (n, p) = (PAIRS as f64, published as f64 / PAIRS as f64);
        let difference = (published as f64 - found as f64).abs() / n;
        return difference < 5.0 * (2.0 * p * (1.0 - p) / n).sqrt();
    }
    let sum = published + found;
    let (mut term, mut tail) = (0.5f64.powi(sum as i32), 0.0);
    for k in 0..=published.min(found) {
        tail += term;
        term *= (sum - k) as f64 / (k + 1) as f64;
    }
    tail >= 2.87e-7
}

#[test]
fn agreement_is_neither_blind_nor_too_strict() {
    assert!(agree(317_737, 319_000) && !agree(317_737, 321_500) && !agree(317_737, 314_000));
    assert!(agree(14, 6) && agree(18, 14) && agree(1, 1) && agree(0, 0));
    // 2^-22 = 2.4e-7 and 2^-21 = 4.8e-7.
    assert!(!agree(0, 22) && agree(0, 21) && !agree(22, 0) && !agree(14, 70));
}

#[test]
fn moller_ends_where_table_4_5_says() {
    let published = [120_720, 317_737, 121_256, 318_641, 121_632, 14];
    for generator in [Generator::Pcg, Generator::Msvc] {
        let found = codes::<Moller<1>, 6>(generator, 45);
        println!("{generator:?}: {found:?}");
        for (code, (&published, &found)) in published.iter().zip(&found).enumerate() {
            assert!(
                agree(published, found),
                "{generator:?} code {code}: {found}, published {published}"
            );
        }
    }
}

#[test]
fn badouel_ends_where_table_4_7_says() {
    let published = [121_034, 1, 18, 637_180, 241_767];
    let found = codes::<Badouel, 5>(Generator::Msvc, 47);
    println!("15 bits: {found:?}");
    for (code, (&published, &found)) in published.iter().zip(&found).enumerate() {
        assert!(agree(published, found), "code {code}: {found}, published {published}");
    }
    // Code 2 tells the generators apart. Two draws of 24 bits are equal once in 2^24, of 15 bits
    // once in 2^15; one in three such pairs or fewer comes to that branch and ends there. Over a
    // million pairs that is 0.03 or less (Poisson: more than 3 has a chance of 3e-8) against 14.
    let fine = codes::<Badouel, 5>(Generator::Pcg, 47);
    println!("24 bits: {fine:?}");
    assert!(
        fine[2] <= 3 && found[2] > fine[2],
        "code 2: {} with 24 bits, {} with 15",
        fine[2],
        found[2]
    );
}
