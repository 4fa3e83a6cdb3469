//! Groups of one experiment, measured in turns, and what came of them put into the rows.

use std::sync::atomic::Ordering;

use super::bench::Bench;
use super::calls;
use super::cells::{Cell, Piece, mark_forgotten};
use super::rows::{put_group, put_interrupted};
use super::run::Trouble;
use crate::measure::{Contestant, Group, GroupReport, Order, Protocol, Status};
use crate::table::Row;

/// Time inside the blocks of what takes turns, ns, from which on no further cell joins. Long against
/// what lasts and cannot be seen, 0.1 to 1 s. A cell is not cut: with all that is around its blocks,
/// `packets` took 25 s in 256 rounds and 157 s in 1024, `b-4.2` 18 and 66 s.
const TURNS_NS: u64 = 15_000_000_000;

/// Whether there is enough to take turns.
pub fn is_enough(pieces: &[Piece], cells: &[Cell], rounds: usize) -> bool {
    let planned =
        |piece: &Piece| protocol(piece, cells, rounds).planned_ns(piece.contestants.len());
    pieces.iter().map(planned).sum::<u64>() >= TURNS_NS
}

fn protocol(piece: &Piece, cells: &[Cell], rounds: usize) -> Protocol {
    let cell = &cells[piece.cell];
    Protocol { rounds, ..Protocol::new(cell.order, cell.seed) }
}

/// Measures groups in turns, writes their figures into the rows of their cells, and keeps those that
/// have a name to be kept under.
///
/// # Errors
/// A group that cannot be measured or kept.
pub fn measure(
    mut pieces: Vec<Piece>,
    cells: &mut [Cell],
    bench: &mut Bench<'_>,
) -> Result<(), Trouble> {
    if bench.cancel.load(Ordering::Relaxed) {
        for piece in &pieces {
            let rows = &mut cells[piece.cell].measured.rows;
            piece.places.iter().for_each(|place| put_interrupted(&mut rows[*place]));
        }
        return Ok(());
    }
    let protocols: Vec<Protocol> =
        pieces.iter().map(|piece| protocol(piece, cells, bench.rounds)).collect();
    let both = pieces.iter_mut().zip(&protocols);
    let mut groups: Vec<Group<'_>> = both
        .map(|(piece, protocol)| Group { contestants: &mut piece.contestants, protocol })
        .collect();
    let reports = bench.measure_together(&mut groups)?;
    let cut: Vec<bool> = reports.iter().map(|report| report.cancelled).collect();
    for (piece, report) in pieces.iter().zip(reports) {
        put(piece, report, &mut cells[piece.cell]);
    }
    // Of what was cut short no row is final.
    let whole = pieces
        .iter_mut()
        .zip(&cut)
        .map(|(piece, cut)| (piece.cell, piece.places.clone(), piece.name.take().filter(|_| !cut)));
    let whole: Vec<(usize, Vec<usize>, Option<String>)> = whole.collect();
    if bench.calls {
        calls::measure(pieces, cells, bench)?;
        if bench.cancel.load(Ordering::Relaxed) {
            return Ok(());
        }
    }
    for (cell, places, name) in whole {
        if let Some(name) = name {
            bench.keep_piece(&name, &places, &cells[cell].measured.rows)?;
        }
    }
    Ok(())
}

fn put(piece: &Piece, report: GroupReport, cell: &mut Cell) {
    for (place, figures) in piece.places.iter().zip(&report.figures) {
        let row = &mut cell.measured.rows[*place];
        let ok = std::mem::take(&mut row.status);
        put_group(row, figures, &report, &ok);
        if cell.order == Order::Fixed && figures.status == Status::Ok {
            mark_forgotten(row, cell.pairs_beyond);
        }
    }
    cell.measured.figures.extend(report.figures.into_iter().take(piece.places.len()));
}

/// A group of an experiment without cells.
pub struct Waiting {
    /// Where the rows of those that are measured stand.
    pub places: Vec<usize>,
    /// Those, then the controls.
    pub contestants: Vec<Contestant>,
    /// How they are measured.
    pub protocol: Protocol,
    /// What its rows are kept under.
    pub piece: String,
    /// Where those stand, measured or not.
    pub all: Vec<usize>,
}

/// Measures groups in turns, writes their figures into the rows and keeps these.
///
/// # Errors
/// A group that cannot be measured or kept.
pub fn measure_waiting(
    mut waiting: Vec<Waiting>,
    bench: &mut Bench<'_>,
    rows: &mut [Row],
) -> Result<(), Trouble> {
    if bench.cancel.load(Ordering::Relaxed) {
        let places = waiting.iter().flat_map(|group| &group.places);
        places.for_each(|place| put_interrupted(&mut rows[*place]));
        return Ok(());
    }
    let mut groups: Vec<Group<'_>> = waiting
        .iter_mut()
        .map(|group| Group { contestants: &mut group.contestants, protocol: &group.protocol })
        .collect();
    let reports = bench.measure_together(&mut groups)?;
    for (group, report) in waiting.iter().zip(&reports) {
        for (place, figures) in group.places.iter().zip(&report.figures) {
            let ok = std::mem::take(&mut rows[*place].status);
            put_group(&mut rows[*place], figures, report, &ok);
        }
        if !report.cancelled {
            bench.keep_piece(&group.piece, &group.all, rows)?;
        }
    }
    Ok(())
}
