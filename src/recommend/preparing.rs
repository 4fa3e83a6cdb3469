//! What preparing a triangle adds to a test, where its rays are counted.

use super::question::Question;
use crate::table::Row;

/// Up to so many rays per triangle, forms that prepare nothing are taken where no row tells what
/// preparing costs. Preparing is a cross product and a division or so, as much as a test; a form
/// that is a tenth cheaper per test then needs ten rays to earn it back.
const FEW: u64 = 10;

/// What is stored where nothing is prepared.
const VERTICES: &str = "vertices";

/// Cycles of preparing a triangle, with their interval, and the row that they are from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Preparing<'a> {
    /// Median, lower and upper end.
    pub cycles: [f64; 3],
    /// Where it was measured.
    pub row: &'a Row,
}

/// How preparing is counted.
pub(super) enum Counting<'a> {
    /// Not at all: nobody asked, or nobody can tell and the rays are many.
    Free,
    /// Forms that prepare something are left out: the rays are few, and no row tells the cost.
    Forbidden,
    /// By these rows, over so many rays.
    Over(u64, Vec<Preparing<'a>>),
}

impl<'a> Counting<'a> {
    /// How it is counted for a question.
    pub fn of(question: &Question, rows: &[&'a Row]) -> Self {
        let Some(rays) = question.rays_per_triangle else { return Counting::Free };
        let known: Vec<Preparing<'a>> = rows.iter().filter_map(|row| preparing(row)).collect();
        match (known.is_empty(), rays <= FEW) {
            (true, true) => Counting::Forbidden,
            (true, false) => Counting::Free,
            (false, _) => Counting::Over(rays, known),
        }
    }

    /// The preparing of a row's form.
    ///
    /// # Errors
    /// Why the form is left out.
    pub fn of_row(&self, row: &Row) -> Result<Option<Preparing<'a>>, &'static str> {
        match self {
            Counting::Free => Ok(None),
            Counting::Forbidden if row.stored == VERTICES => Ok(None),
            Counting::Forbidden => Err("prepare something at a cost that no row tells"),
            Counting::Over(_, known) => {
                let alike = |other: &&Preparing<'a>| {
                    (&other.row.precision, &other.row.stored) == (&row.precision, &row.stored)
                };
                let own = known.iter().filter(alike).find(|other| other.row.kernel == row.kernel);
                // Whoever stores the corners copies them, whatever its kernel.
                let copied = || known.iter().filter(alike).find(|_| row.stored == VERTICES);
                let found = own.or_else(copied).copied();
                match found {
                    None if row.stored != VERTICES => {
                        Err("prepare something at a cost that no row tells")
                    }
                    _ if row.cycles_per_test.is_none() => Err("have no time in cycles"),
                    found => Ok(found),
                }
            }
        }
    }

    /// By what a time of a test is multiplied so that it holds the test's share of preparing: the
    /// factor, and its least and most.
    pub fn factors(&self, row: &Row, preparing: Option<Preparing<'a>>) -> [f64; 3] {
        let (Counting::Over(rays, _), Some(preparing), Some(test)) =
            (self, preparing, row.cycles_per_test)
        else {
            return [1.0; 3];
        };
        let [median, low, high] = preparing.cycles;
        let over = |cycles: f64, test: f64| 1.0 + cycles / (*rays as f64 * test);
        let (fast, slow) = (row.cycles_low.unwrap_or(test), row.cycles_high.unwrap_or(test));
        [over(median, test), over(low, slow), over(high, fast)]
    }
}

fn preparing(row: &Row) -> Option<Preparing<'_>> {
    let median = row.prepare_cycles_per_triangle?;
    let (low, high) = (row.prepare_cycles_low, row.prepare_cycles_high);
    Some(Preparing { cycles: [median, low.unwrap_or(median), high.unwrap_or(median)], row })
}
