//! What operations cost, and what work costs at least.

use std::collections::BTreeMap;

use super::Work;
use crate::batch::{Kind, mix};

/// The least cycles of a test.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// Cycles of one test.
    pub cycles: f64,
    /// What they are spent on: a kind, kinds that share their units, or `vector units`.
    pub resource: String,
}

/// Cycles of one instruction in each mix of a level's registers, by the code of the mix.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Costs(BTreeMap<u64, f64>);

/// Two kinds in turn take as long as one after the other where they have all units in common: this
/// share of it is as good as all. Where they have a part in common, it is 6/7 at most (kinds with three
/// and with four units); the middle between that and 1.
const SHARED: f64 = 13.0 / 14.0;

/// Kinds that may have their units in common.
const TRIO: [Kind; 3] = [Kind::Add, Kind::Multiply, Kind::Fused];

/// Kinds that are done by vector units, in one or several of their places.
const PLACED: [Kind; 6] =
    [Kind::Add, Kind::Multiply, Kind::Fused, Kind::Compare, Kind::Select, Kind::Flip];

impl Costs {
    /// Notes the cycles of one instruction of a mix.
    pub fn insert(&mut self, mix: u64, cycles: f64) {
        self.0.insert(mix, cycles);
    }

    /// Whether nothing was measured.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn of(&self, mix: u64) -> Option<f64> {
        self.0.get(&mix).copied()
    }

    /// Cycles of a kind that has the machine for itself.
    fn alone(&self, kind: Kind) -> Option<f64> {
        self.of(mix::alone(kind))
    }

    fn share_units(&self, one: Kind, other: Kind) -> bool {
        let mixed = self.of(mix::half(one, other)).or_else(|| self.of(mix::half(other, one)));
        let (Some(mixed), Some(a), Some(b)) = (mixed, self.alone(one), self.alone(other)) else {
            return false;
        };
        2.0 * mixed >= SHARED * (a + b)
    }

    /// Cycles that an operation takes from those of flips, which every vector unit can do: by how much
    /// longer a stream of flips takes with it in between. With more flips than it needs to fill the
    /// units that is what it takes; with fewer it is more, and so the least of the mixes counts.
    fn place(&self, kind: Kind) -> Option<f64> {
        let (alone, flip) = (self.alone(kind)?, self.alone(Kind::Flip)?);
        if kind == Kind::Flip {
            return Some(flip);
        }
        let among = |mix: u64| {
            let (flips, own) = (mix::count(mix, Kind::Flip), mix::count(mix, kind));
            let cycles = self.of(mix)? * (flips + own) as f64;
            Some((cycles - flips as f64 * flip) / own as f64)
        };
        let half = among(mix::half(kind, Kind::Flip)).unwrap_or(alone);
        let third = among(mix::third(kind, Kind::Flip)).unwrap_or(alone);
        Some(alone.min(half).min(third).max(0.0))
    }

    /// The least cycles of so many operations of each kind; `None` where no cost is known.
    fn least(&self, amount: impl Fn(Kind) -> f64) -> Option<Bound> {
        let alone = |kind| self.alone(kind).unwrap_or(0.0) * amount(kind);
        let mut bounds: Vec<(f64, String)> =
            Kind::ALL.into_iter().map(|kind| (alone(kind), kind.word().to_owned())).collect();
        let sets = [&TRIO[..], &TRIO[..2], &TRIO[1..], &[TRIO[0], TRIO[2]]];
        for set in sets {
            let set: Vec<Kind> = set.iter().copied().filter(|kind| amount(*kind) > 0.0).collect();
            let all =
                |one: &Kind| set.iter().all(|other| one == other || self.share_units(*one, *other));
            if set.len() > 1 && set.iter().all(all) {
                let words: Vec<&str> = set.iter().map(|kind| kind.word()).collect();
                bounds.push((set.iter().map(|kind| alone(*kind)).sum(), words.join(" + ")));
            }
        }
        let placed = |kind: Kind| self.place(kind).unwrap_or(0.0) * amount(kind);
        // A division fills one place at least.
        let division = amount(Kind::Divide) * self.alone(Kind::Flip).unwrap_or(0.0);
        let units = PLACED.into_iter().map(placed).sum::<f64>() + division;
        bounds.push((units, "vector units".to_owned()));
        let (cycles, resource) = bounds.into_iter().reduce(|a, b| if b.0 > a.0 { b } else { a })?;
        (cycles > 0.0).then_some(Bound { cycles, resource })
    }

    /// The least cycles of a test in packets of `rays` rays, `lanes` of which fill a register. What is
    /// done once for all of them are single numbers, of which the compiler can put as many into one
    /// instruction as `narrow`, the lanes of the smallest register; or a register of them, if it is done
    /// of several triangles.
    pub fn packet(&self, work: &Work, rays: usize, lanes: usize, narrow: usize) -> Option<Bound> {
        let registers = rays as f64 / lanes as f64;
        let amount = |kind: Kind| {
            let once = work.once_of(kind) as f64;
            let together = if work.in_groups { lanes } else { narrow };
            let once = if kind == Kind::Load { once } else { once / together as f64 };
            work.each_of(kind) as f64 * registers + once
        };
        let bound = self.least(amount)?;
        Some(Bound { cycles: bound.cycles / rays as f64, ..bound })
    }

    /// The least cycles of a test of a single ray, whose numbers take an instruction each. Comparisons
    /// and selections of single numbers are the business of other units, and are not counted.
    pub fn single(&self, work: &Work) -> Option<Bound> {
        let counted = [Kind::Add, Kind::Multiply, Kind::Fused, Kind::Divide];
        self.least(|kind| {
            let both = work.each_of(kind) + work.once_of(kind);
            if counted.contains(&kind) { both as f64 } else { 0.0 }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A machine with units 0 and 5: both do everything, but comparisons, which need unit 5, and
    /// divisions (10 cycles). What a model of its ports gives for each mix.
    fn two_units() -> Costs {
        let mut costs = Costs::default();
        for kind in Kind::ALL {
            let cycles = match kind {
                Kind::Compare => 1.0,
                Kind::Divide => 10.0,
                _ => 0.5,
            };
            costs.insert(mix::alone(kind), cycles);
        }
        for (one, other) in [(0, 1), (0, 2), (1, 2)] {
            costs.insert(mix::half(TRIO[one], TRIO[other]), 0.5);
        }
        for kind in [Kind::Add, Kind::Multiply, Kind::Fused, Kind::Compare, Kind::Select] {
            costs.insert(mix::half(kind, Kind::Flip), 0.5);
            costs.insert(mix::third(kind, Kind::Flip), 0.5);
        }
        costs
    }

    /// Units 0, 1 and 5: fused and multiplications on 0 and 1, additions on 1 and 5, flips on all,
    /// a selection is three instructions.
    fn three_units() -> Costs {
        let third = 1.0 / 3.0;
        let mut costs = two_units();
        for (kind, cycles) in
            [(Kind::Flip, third), (Kind::Select, 1.0), (Kind::Compare, 2.0 * third)]
        {
            costs.insert(mix::alone(kind), cycles);
        }
        costs.insert(mix::half(Kind::Add, Kind::Multiply), third);
        costs.insert(mix::half(Kind::Add, Kind::Fused), third);
        for kind in [Kind::Add, Kind::Multiply, Kind::Fused] {
            costs.insert(mix::half(kind, Kind::Flip), third);
            costs.insert(mix::third(kind, Kind::Flip), third);
        }
        for (kind, instructions) in [(Kind::Compare, 2.0), (Kind::Select, 3.0)] {
            costs.insert(mix::half(kind, Kind::Flip), (1.0 + instructions) / 6.0);
            costs.insert(mix::third(kind, Kind::Flip), (2.0 + instructions) / 9.0);
        }
        costs
    }

    /// add, multiply, fused, divide, compare, select, flip, load.
    fn work(each: [u64; 8], once: [u64; 8]) -> Work {
        Work { each, once, in_groups: false }
    }

    fn close(bound: Option<Bound>, cycles: f64, resource: &str) {
        let bound = bound.unwrap();
        assert!((bound.cycles - cycles).abs() < 1e-12, "{bound:?}");
        assert_eq!(bound.resource, resource);
    }

    #[test]
    fn what_shares_its_units_is_summed_and_what_does_not_is_not() {
        let each = [4, 6, 8, 0, 0, 0, 0, 0];
        let (none, work) = ([0; 8], work(each, [0; 8]));
        assert_eq!(work.once, none);
        // All on units 0 and 5: 18 / 2.
        close(two_units().packet(&work, 1, 1, 1), 9.0, "add + multiply + fused");
        // 14 on units 0 and 1: 7; all 18 on three units: 6.
        close(three_units().packet(&work, 1, 1, 1), 7.0, "multiply + fused");
    }

    #[test]
    fn everything_that_vector_units_do_fills_their_places() {
        let many = work([2, 0, 10, 1, 5, 4, 0, 9], [0; 8]);
        // 2 + 10 + 5 + 4 and a division, two in a cycle.
        close(two_units().packet(&many, 1, 1, 1), 11.0, "vector units");
        // 2 + 10 + 5 x 2 + 4 x 3 and a division, three in a cycle.
        close(three_units().packet(&many, 1, 1, 1), 35.0 / 3.0, "vector units");
    }

    #[test]
    fn scarce_units_bound_alone() {
        let compares = work([0, 0, 2, 0, 9, 0, 0, 0], [0; 8]);
        close(two_units().packet(&compares, 1, 1, 1), 9.0, "compare");
        let divisions = work([2, 0, 10, 2, 5, 4, 0, 9], [0; 8]);
        close(two_units().packet(&divisions, 1, 1, 1), 20.0, "divide");
    }

    #[test]
    fn what_is_done_once_is_shared_by_all_rays() {
        let fused = work([0, 0, 16, 0, 0, 0, 0, 0], [8, 0, 0, 0, 0, 0, 0, 0]);
        // Two registers of 16 rays: 32 fused and 8 additions, four to an instruction.
        close(two_units().packet(&fused, 32, 16, 4), (32.0 + 2.0) / 2.0 / 32.0, "add + fused");
        let in_groups = Work { in_groups: true, ..fused };
        let cycles = (32.0 + 0.5) / 2.0 / 32.0;
        close(two_units().packet(&in_groups, 32, 16, 4), cycles, "add + fused");
        let loads = work([0, 0, 2, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0, 0, 12]);
        close(two_units().packet(&loads, 16, 16, 4), 6.0 / 16.0, "load");
    }

    #[test]
    fn single_rays_compare_elsewhere() {
        let single = work([4, 6, 0, 0, 90, 90, 90, 0], [2, 0, 0, 0, 0, 0, 0, 90]);
        close(two_units().single(&single), 6.0, "add + multiply");
    }

    #[test]
    fn nothing_known_is_no_bound() {
        assert_eq!(Costs::default().single(&work([1; 8], [1; 8])), None);
        assert!(Costs::default().is_empty() && !two_units().is_empty());
        // The place of a kind that was not measured among flips is no more than it takes alone.
        let mut costs = Costs::default();
        costs.insert(mix::alone(Kind::Add), 0.5);
        close(costs.single(&work([4, 0, 0, 0, 0, 0, 0, 0], [0; 8])), 2.0, "add");
    }
}
