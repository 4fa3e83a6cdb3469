//! Counts of rays that are lost in a closed mesh, or met twice.

#[cfg(feature = "cli")]
use crate::table::Row;

/// Of one form on one kind of rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Rays that exactly cross the mesh in one point.
    pub rays: u64,
    /// Those that no triangle is hit by.
    pub leaks: u64,
    /// Those that several triangles are hit by.
    pub doubles: u64,
    /// Hits in all.
    pub hits: u64,
    /// Hits with an output that is not finite.
    pub non_finite: u64,
}

impl Tally {
    /// Takes in a ray that exactly crosses in one point: how many hits are reported, and how many
    /// of them with an output that is not finite.
    pub fn add(&mut self, (hits, non_finite): (u64, u64)) {
        self.rays += 1;
        self.hits += hits;
        self.non_finite += non_finite;
        self.leaks += u64::from(hits == 0);
        self.doubles += u64::from(hits > 1);
    }

    /// The counts of both.
    pub fn plus(self, other: Tally) -> Tally {
        Tally {
            rays: self.rays + other.rays,
            leaks: self.leaks + other.leaks,
            doubles: self.doubles + other.doubles,
            hits: self.hits + other.hits,
            non_finite: self.non_finite + other.non_finite,
        }
    }
}

#[cfg(feature = "cli")]
impl Tally {
    /// The counts of rows together.
    pub fn of(rows: &[&Row]) -> Self {
        let sum = |of: fn(&Row) -> Option<u64>| rows.iter().filter_map(|row| of(row)).sum();
        Tally {
            rays: sum(|row| row.cases),
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
        row.leaks = Some(self.leaks);
        row.double_hits = Some(self.doubles);
        row.hits = Some(self.hits);
        row.nan_outputs = Some(self.non_finite);
        row.leaks_per_million = per_million(self.leaks, self.rays);
        row.double_hits_per_million = per_million(self.doubles, self.rays);
        row.leaks_bound_per_million = match self.leaks {
            0 => per_million(3, self.rays),
            _ => None,
        };
    }
}

#[cfg(feature = "cli")]
fn per_million(count: u64, of: u64) -> Option<f64> {
    (of > 0).then(|| count as f64 / of as f64 * 1e6)
}

#[cfg(all(test, feature = "cli"))]
mod tests {
    use super::*;

    #[test]
    fn leaks_and_doubles_are_counted() {
        let mut tally = Tally::default();
        [(0, 0), (1, 0), (2, 1), (1, 0)].into_iter().for_each(|hits| tally.add(hits));
        let mut row = Row::default();
        tally.put(&mut row);
        assert_eq!((row.cases, row.leaks, row.double_hits), (Some(4), Some(1), Some(1)));
        assert_eq!((row.hits, row.nan_outputs), (Some(4), Some(1)));
        assert_eq!(row.leaks_per_million, Some(250_000.0));
        assert_eq!(row.leaks_bound_per_million, None);
        assert_eq!(Tally::of(&[&row, &row]).leaks, 2);
    }

    #[test]
    fn none_seen_has_a_bound() {
        let mut tally = Tally::default();
        (0..1000).for_each(|_| tally.add((1, 0)));
        let mut row = Row::default();
        tally.put(&mut row);
        assert_eq!(row.leaks_bound_per_million, Some(3000.0));
    }
}
