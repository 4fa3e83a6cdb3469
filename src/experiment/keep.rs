//! Keeping rows as soon as they are final, so that an interrupted run can be gone on with.
//!
//! A *piece* is what is compared with each other, and so is either kept as a whole or measured again: a
//! group of a cell, a whole cell where prices are made of its samples, the exits of a listing in
//! one order. Pieces are cut the same way in every run, so that their names find them again.

use super::bench::Bench;
use super::cells::CONTROLS;
use crate::measure::{Order, Protocol, RoundTrace};
use crate::table::{Row, TableError};

/// Where rows go as soon as they are final, and where those of an interrupted run come from.
pub trait Keep {
    /// Whether the rows of a piece were kept before, and are still here.
    fn is_kept(&self, piece: &str) -> bool;
    /// Hands out the rows of such a piece, in their order; `None` if it must be measured.
    fn hand_out(&mut self, piece: &str) -> Option<Vec<Row>>;
    /// Hands out all that is still here: of pieces that a run did not come to.
    fn hand_out_rest(&mut self) -> Vec<Row>;
    /// Keeps the rows of a piece; only columns that need the rows of all pieces are still empty.
    ///
    /// # Errors
    /// When they cannot be written.
    fn keep(&mut self, piece: &str, rows: &[Row]) -> Result<(), TableError>;
    /// Takes down the rounds of a group that was measured. What cannot be written is told by the
    /// next [`Keep::keep`]: it is no reason to stop in the middle of a piece.
    fn take_down(&mut self, _protocol: &Protocol, _rounds: &[RoundTrace]) {}
}

/// Pieces that were kept before and were not handed out yet, by name, in the order of keeping.
#[derive(Clone, Debug, Default)]
pub struct Pieces(pub Vec<(String, Vec<Row>)>);

impl Pieces {
    /// As [`Keep::is_kept`].
    pub fn has(&self, piece: &str) -> bool {
        self.0.iter().any(|(name, _)| name == piece)
    }

    /// As [`Keep::hand_out`].
    pub fn take(&mut self, piece: &str) -> Option<Vec<Row>> {
        let place = self.0.iter().position(|(name, _)| name == piece);
        place.map(|place| self.0.remove(place).1)
    }

    /// As [`Keep::hand_out_rest`].
    pub fn take_rest(&mut self) -> Vec<Row> {
        self.0.drain(..).flat_map(|(_, rows)| rows).collect()
    }
}

/// Keeps nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct KeepNothing;

impl Keep for KeepNothing {
    fn is_kept(&self, _: &str) -> bool {
        false
    }

    fn hand_out(&mut self, _: &str) -> Option<Vec<Row>> {
        None
    }

    fn hand_out_rest(&mut self) -> Vec<Row> {
        Vec::new()
    }

    fn keep(&mut self, _: &str, _: &[Row]) -> Result<(), TableError> {
        Ok(())
    }
}

/// Why a piece cannot be kept or taken back.
#[derive(Debug, thiserror::Error)]
pub enum KeepError {
    /// It cannot be written.
    #[error(transparent)]
    Write(#[from] TableError),
    /// What was kept is not what would be measured now.
    #[error(
        "{piece}: {column} of a kept row is '{kept}', now '{now}'; allowed: rows of the same \
         workload and variants"
    )]
    Changed {
        /// The piece.
        piece: String,
        /// The column that differs.
        column: &'static str,
        /// What was kept.
        kept: String,
        /// What it would be now.
        now: String,
    },
}

impl KeepError {
    /// Refuses a kept value that differs from what it would be now.
    fn check(
        piece: &str,
        column: &'static str,
        kept: impl ToString,
        now: impl ToString,
    ) -> Result<(), Self> {
        let (piece, kept, now) = (piece.to_owned(), kept.to_string(), now.to_string());
        if kept == now { Ok(()) } else { Err(KeepError::Changed { piece, column, kept, now }) }
    }
}

/// Columns that are known before anything is measured, and tell the rows of a piece apart. Other
/// outputs than before mean another program.
const IDENTITY: [&str; 5] = ["id", "order", "code", "workload_hash", "outputs_hash"];

impl Bench<'_> {
    /// Puts the rows that were kept of a piece into their places among `rows`, where they stand as
    /// they are before the measuring; whether there were any.
    ///
    /// # Errors
    /// If the kept ones are of another workload or of other variants.
    pub fn take_back(
        &mut self,
        piece: &str,
        places: &[usize],
        rows: &mut [Row],
    ) -> Result<bool, KeepError> {
        let Some(kept) = self.keep.hand_out(piece) else { return Ok(false) };
        KeepError::check(piece, "number", kept.len(), places.len())?;
        for (place, kept) in places.iter().zip(kept) {
            let now = &mut rows[*place];
            for column in IDENTITY {
                let text = |row: &Row| row.cell(column).map_or(String::new(), |c| c.to_string());
                KeepError::check(piece, column, text(&kept), text(now))?;
            }
            *now = kept;
        }
        Ok(true)
    }

    /// All rows that were kept of a cell that is one piece.
    ///
    /// # Errors
    /// If they are of another workload.
    pub fn take_cell(&mut self, cell: &str, hash: u64) -> Result<Option<Vec<Row>>, KeepError> {
        let Some(kept) = self.keep.hand_out(cell) else { return Ok(None) };
        for row in &kept {
            KeepError::check(cell, "workload_hash", &row.workload_hash, format!("{hash:016x}"))?;
        }
        Ok(Some(kept))
    }

    /// Keeps a piece: the rows in these places.
    ///
    /// # Errors
    /// When they cannot be written.
    pub fn keep_piece(
        &mut self,
        piece: &str,
        places: &[usize],
        rows: &[Row],
    ) -> Result<(), KeepError> {
        let rows: Vec<Row> = places.iter().map(|place| rows[*place].clone()).collect();
        Ok(self.keep.keep(piece, &rows)?)
    }

    /// Rows that are never timed: kept, unless they are already.
    ///
    /// # Errors
    /// As taking back and keeping.
    pub fn keep_untimed(
        &mut self,
        piece: &str,
        places: &[usize],
        rows: &mut [Row],
    ) -> Result<(), KeepError> {
        if places.is_empty() || self.take_back(piece, places, rows)? {
            return Ok(());
        }
        self.keep_piece(piece, places, rows)
    }

    /// Tells the progress of a group of so many subjects that need not be measured.
    pub fn pass_over(&mut self, subjects: usize) {
        let protocol = Protocol { rounds: self.rounds, ..Protocol::new(Order::Fixed, 0) };
        self.pass_over_as(&protocol, subjects + CONTROLS);
    }

    /// The same of so many contestants that would be measured by a protocol of their own.
    pub fn pass_over_as(&mut self, protocol: &Protocol, contestants: usize) {
        (self.progress)(protocol.planned_rounds(contestants) * contestants);
    }
}
