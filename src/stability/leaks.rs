//! Counts of rays that are lost in a closed mesh, or met twice.

use super::mesh_rays::Crossings;
use crate::table::Row;

/// Of one form on one kind of rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Rays that exactly cross the mesh.
    rays: u64,
    /// Those of them that cross in a single point.
    single: u64,
    /// Rays that no triangle is hit by.
    leaks: u64,
    /// Single crossings that several triangles are hit by.
    doubles: u64,
    /// Hits in all.
    hits: u64,
    /// Hits at a t that is not finite.
    non_finite: u64,
}

impl Tally {
    /// Takes in a ray: how it exactly crosses, how many hits are reported, and how many of them
    /// with an output that is not finite. A ray that exactly crosses nothing, because rounding has
    /// put its origin outside, is in no rate.
    pub fn add(&mut self, crossings: Crossings, (hits, non_finite): (u64, u64)) {
        self.hits += hits;
        self.non_finite += non_finite;
        if crossings == Crossings::None {
            return;
        }
        self.rays += 1;
        self.leaks += u64::from(hits == 0);
        if crossings == Crossings::One {
            self.single += 1;
            self.doubles += u64::from(hits > 1);
        }
    }

    /// The counts of rows together.
    pub fn of(rows: &[&Row]) -> Self {
        let sum = |of: fn(&Row) -> Option<u64>| rows.iter().filter_map(|row| of(row)).sum();
        Tally {
            rays: sum(|row| row.cases),
            single: sum(|row| row.single_crossings),
            leaks: sum(|row| row.leaks),
            doubles: sum(|row| row.double_hits),
            hits: sum(|row| row.hits),
            non_finite: sum(|row| row.nan_outputs),
        }
    }

    /// Puts counts and rates into a row. Where none of n was seen, the rate is below 3/n with a
    /// probability of 95 %: (1 - 3/n)^n is about e^-3 = 0.05.
    pub fn put(self, row: &mut Row) {
        row.cases = Some(self.rays);
        row.rays = Some(self.rays);
        row.single_crossings = Some(self.single);
        row.leaks = Some(self.leaks);
        row.double_hits = Some(self.doubles);
        row.hits = Some(self.hits);
        row.nan_outputs = Some(self.non_finite);
        row.leaks_per_million = per_million(self.leaks, self.rays);
        row.double_hits_per_million = per_million(self.doubles, self.single);
        row.leaks_bound_per_million = match self.leaks {
            0 => per_million(3, self.rays),
            _ => None,
        };
    }
}

fn per_million(count: u64, of: u64) -> Option<f64> {
    (of > 0).then(|| count as f64 / of as f64 * 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leaks_and_doubles_are_of_rays_that_cross() {
        let mut tally = Tally::default();
        tally.add(Crossings::None, (0, 0));
        tally.add(Crossings::One, (0, 0));
        tally.add(Crossings::One, (1, 0));
        tally.add(Crossings::One, (2, 1));
        tally.add(Crossings::Several, (2, 0));
        let mut row = Row::default();
        tally.put(&mut row);
        assert_eq!((row.cases, row.leaks, row.double_hits), (Some(4), Some(1), Some(1)));
        assert_eq!((row.hits, row.nan_outputs), (Some(5), Some(1)));
        assert_eq!(row.leaks_per_million, Some(250_000.0));
        assert_eq!(row.leaks_bound_per_million, None);
        assert_eq!(Tally::of(&[&row, &row]).leaks, 2);
    }

    #[test]
    fn none_seen_has_a_bound() {
        let mut tally = Tally::default();
        (0..1000).for_each(|_| tally.add(Crossings::One, (1, 0)));
        let mut row = Row::default();
        tally.put(&mut row);
        assert_eq!(row.leaks_bound_per_million, Some(3000.0));
    }
}
