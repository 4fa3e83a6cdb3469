//! How many questions a second the exact answer takes, by the stage that decides them.

use crate::measure::Clock;
use crate::oracle::{Query, Stage, classify, stage};
use crate::workload::{Generator, Pcg, Ray, Triangle, WorkloadError, draw_pairs};
use std::hint::black_box;

/// Questions asked in a pass: more than a core's nearest cache holds.
const QUESTIONS: usize = 20_000;
/// Passes; the fastest counts, since nothing makes a pass faster than the code is.
const PASSES: usize = 25;

/// Stretch of an axis that makes a query too wide for 128 bits: 2^40.
const STRETCH: f64 = (1u64 << 40) as f64;

/// Decisions a second, single-threaded.
#[derive(Clone, Copy, Debug)]
pub struct OracleSpeed {
    /// Random f32 pairs, from ray and triangle to class.
    pub pairs: f64,
    /// Share of them that the f64 filter decides.
    pub filtered: f64,
    /// Rays exactly through edges of small lattice triangles: 128-bit integers.
    pub small_integers: f64,
    /// The same with axes of very different scale, whose bits span too much: big integers.
    pub big_integers: f64,
}

/// Asks a fixed set of questions of each kind.
///
/// # Errors
/// As drawing.
pub fn oracle_speed(clock: &mut dyn Clock) -> Result<OracleSpeed, WorkloadError> {
    let mut pairs: Vec<(Ray, Triangle)> = Vec::with_capacity(QUESTIONS);
    draw_pairs(Generator::Pcg, 1, QUESTIONS, |ray, triangle| pairs.push((ray, triangle)))?;
    let queries: Vec<Query> = pairs.iter().map(|(ray, tri)| Query::of(ray, tri)).collect();
    let filtered = queries.iter().filter(|query| stage(query) == Stage::Filter).count();
    let small = edges(Stage::SmallIntegers, 1.0);
    let big = edges(Stage::BigIntegers, STRETCH);
    let of_pairs = |(ray, triangle): &(Ray, Triangle)| Query::of(ray, triangle);
    Ok(OracleSpeed {
        pairs: per_second(clock, &pairs, of_pairs),
        filtered: filtered as f64 / queries.len() as f64,
        small_integers: per_second(clock, &small, |query| *query),
        big_integers: per_second(clock, &big, |query| *query),
    })
}

/// Rays at the middle of an edge of a lattice triangle: no float arithmetic can certify the zero.
/// One axis is stretched by a power of two, another shrunk by it, which changes no answer but makes
/// the bits span more.
fn edges(wanted: Stage, stretch: f64) -> Vec<Query> {
    let mut source = Pcg::new(2);
    let mut found = Vec::with_capacity(QUESTIONS);
    while found.len() < QUESTIONS {
        let mut even = || 2.0 * (source.below(2001) as f64 - 1000.0);
        let mut vector = || [even(), even() * stretch, even() / stretch];
        let (triangle, direction) = ([vector(), vector(), vector()], vector());
        let [a, b, _] = triangle;
        let origin = std::array::from_fn(|i| (a[i] + b[i]) / 2.0 - direction[i]);
        let query = Query { origin, direction, end: None, triangle, t_min: 0.0, t_max: 4.0 };
        if stage(&query) == wanted {
            found.push(query);
        }
    }
    found
}

fn per_second<T>(clock: &mut dyn Clock, items: &[T], query: impl Fn(&T) -> Query) -> f64 {
    let mut least = u64::MAX;
    for _ in 0..PASSES {
        let start = clock.now_ns();
        let hits = items.iter().filter(|item| classify(&query(black_box(item))).is_hit()).count();
        black_box(hits);
        least = least.min(clock.now_ns() - start);
    }
    items.len() as f64 * 1e9 / least.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::ScriptedClock;

    #[test]
    fn questions_are_decided_where_they_are_meant_to_be() {
        for (wanted, stretch) in [(Stage::SmallIntegers, 1.0), (Stage::BigIntegers, STRETCH)] {
            for query in edges(wanted, stretch).iter().take(500) {
                assert!(classify(query).is_hit(), "{query:?}");
            }
        }
        // Each pass takes a step of this clock.
        let speed = oracle_speed(&mut ScriptedClock::new(1000)).expect("it is drawn");
        assert_eq!((speed.pairs, speed.big_integers), (2e10, 2e10));
        assert!(speed.filtered > 0.99, "{}", speed.filtered);
    }
}
