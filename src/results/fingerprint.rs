//! A number that names the rows a report was made from.

use super::Results;
use crate::table::csv_bytes;

impl Results {
    /// FNV-1a, 64 bits, over the rows of every chapter as `rows.csv` has them, in their order.
    ///
    /// # Errors
    /// A row cannot be written as CSV.
    pub fn data_hash(&self) -> Result<u64, csv::Error> {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for chapter in &self.chapters {
            for byte in csv_bytes(&chapter.rows)? {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
        Ok(hash)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::{COLUMNS, Row};

    /// The published vectors of FNV-1a, by a chapter without rows: its text is the header.
    #[test]
    fn every_cell_and_the_order_of_rows_count() {
        let row = |kernel: &str| Row { kernel: kernel.into(), ..Row::default() };
        let hash = |rows: Vec<Row>| {
            let mut results = Results::default();
            results.chapters.push(super::super::Chapter { rows, ..Default::default() });
            results.data_hash().unwrap()
        };
        assert_eq!(Results::default().data_hash().unwrap(), 0xcbf2_9ce4_8422_2325);
        let by_hand = format!("{}\n", COLUMNS.join(","))
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
                (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
            });
        assert_eq!(hash(Vec::new()), by_hand);
        assert_ne!(hash(vec![row("a"), row("b")]), hash(vec![row("b"), row("a")]));
        assert_ne!(hash(vec![row("a")]), hash(vec![row("b")]));
    }
}
