//! What a test cannot take less than.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use crate::counting::{counters, paths};
use crate::measure::MOST_OPERATIONS_PER_CYCLE;
use crate::registry::Variant;
use crate::workload::{Generator, draw_pairs};

/// Pairs on which the shortest exit of each kernel is looked for.
const PAIRS: usize = 1000;

/// Fewest arithmetic operations of any exit of a kernel, by its id.
static FEWEST: LazyLock<BTreeMap<&'static str, u64>> = LazyLock::new(|| {
    let (mut rays, mut triangles) = (Vec::new(), Vec::new());
    let drawn = draw_pairs(Generator::Pcg, 1, PAIRS, |ray, triangle| {
        rays.push(ray);
        triangles.push(triangle);
    });
    let mut fewest = BTreeMap::new();
    if drawn.is_err() {
        return fewest;
    }
    for counter in counters() {
        for path in paths(&counter, &rays, &triangles) {
            // A change of sign is often folded into the operation that follows.
            let operations = path.shortest.arithmetic() - path.shortest.neg;
            let least = fewest.entry(counter.kernel).or_insert(operations);
            *least = operations.min(*least);
        }
    }
    fewest
});

/// Cycles that a test of `variant` takes at least on any core: the operations of its kernel's
/// shortest exit, all lanes at once, as many in a cycle as any core can. 0 where nobody counted:
/// whoever asks about points of the plane does a part of the kernel only.
pub fn least_cycles(variant: &Variant) -> f64 {
    if variant.axes.query == "point" {
        return 0.0;
    }
    let fewest = FEWEST.get(variant.axes.kernel).copied().unwrap_or(0);
    fewest as f64 / (MOST_OPERATIONS_PER_CYCLE * variant.lanes as f64)
}
