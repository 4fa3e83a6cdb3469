//! Adaptive subsampling, as thesis B's ray tracer has it: rays on a coarse grid, and between them only
//! where their colours differ.

use super::picture::Picture;
use glam::DVec3;

/// How a cell whose corners are alike is filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Between the four corners, linear along each side.
    Bilinear,
    /// As the nearest corner.
    Nearest,
}

/// Which pixels get a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subsampling {
    /// Columns and rows from one point of the grid to the next; both above 0. 1 x 1 is a ray for
    /// every pixel.
    pub grid: [u32; 2],
    /// A cell is filled without rays if red, green and blue of its corners, from 0 to 1, differ by
    /// less. So 0 is a ray for every pixel; above 1 everything is filled.
    pub tolerance: f64,
    /// How it is filled.
    pub interpolation: Interpolation,
}

impl Subsampling {
    /// A ray for every pixel.
    pub const NONE: Subsampling =
        Subsampling { grid: [1, 1], tolerance: 0.0, interpolation: Interpolation::Bilinear };
}

/// A cell: first and last column, first and last row, all of which belong to it. Neighbours share
/// their sides.
#[derive(Clone, Copy, Debug)]
struct Cell {
    columns: [u32; 2],
    rows: [u32; 2],
}

impl Cell {
    /// Columns and rows that it is wide and high, both sides counted as one.
    fn spans(&self) -> [u32; 2] {
        [self.columns[1] - self.columns[0], self.rows[1] - self.rows[0]]
    }

    fn corners(&self) -> [[u32; 2]; 4] {
        let ([left, right], [top, bottom]) = (self.columns, self.rows);
        [[left, top], [right, top], [left, bottom], [right, bottom]]
    }

    /// The two to four cells that it consists of: cut in the middle of every side of more than one.
    fn parts(&self) -> Vec<Cell> {
        let halves = |[first, last]: [u32; 2]| match last - first {
            0 | 1 => vec![[first, last]],
            span => vec![[first, first + span / 2], [first + span / 2, last]],
        };
        let columns = halves(self.columns);
        let of_rows = |rows| columns.iter().map(move |columns| Cell { columns: *columns, rows });
        halves(self.rows).into_iter().flat_map(of_rows).collect()
    }
}

/// A picture in the making.
pub(super) struct Sampler<'a> {
    subsampling: Subsampling,
    picture: &'a mut Picture,
    /// Pixels that had their ray.
    traced: Vec<bool>,
}

impl<'a> Sampler<'a> {
    pub fn new(subsampling: Subsampling, picture: &'a mut Picture) -> Self {
        let traced = vec![false; picture.pixels().len()];
        Sampler { subsampling, picture, traced }
    }

    /// Number of rows of cells.
    pub fn bands(&self) -> usize {
        grid_lines(self.picture.size()[1], self.subsampling.grid[1]).len()
    }

    /// Makes the cells of a row; `trace` tells the colour of a pixel by its column and row.
    pub fn band(&mut self, band: usize, trace: &mut dyn FnMut(u32, u32) -> DVec3) {
        let ([columns, rows], grid) = (self.picture.size(), self.subsampling.grid);
        let rows = grid_lines(rows, grid[1])[band];
        for columns in grid_lines(columns, grid[0]) {
            self.cell(Cell { columns, rows }, trace);
        }
    }

    fn cell(&mut self, cell: Cell, trace: &mut dyn FnMut(u32, u32) -> DVec3) {
        let corners = cell.corners().map(|[column, row]| self.traced(column, row, trace));
        if cell.spans().iter().all(|span| *span <= 1) {
            return;
        }
        if difference(&corners) < self.subsampling.tolerance {
            self.fill(&cell, &corners);
            return;
        }
        for part in cell.parts() {
            self.cell(part, trace);
        }
    }

    /// The colour of a pixel that gets a ray, if it had none.
    fn traced(&mut self, column: u32, row: u32, trace: &mut dyn FnMut(u32, u32) -> DVec3) -> DVec3 {
        let index = self.picture.index(column, row);
        if !self.traced[index] {
            self.traced[index] = true;
            self.picture.pixels_mut()[index] = trace(column, row);
        }
        self.picture.pixels()[index]
    }

    /// Fills what had no ray.
    fn fill(&mut self, cell: &Cell, corners: &[DVec3; 4]) {
        for row in cell.rows[0]..=cell.rows[1] {
            for column in cell.columns[0]..=cell.columns[1] {
                let index = self.picture.index(column, row);
                if !self.traced[index] {
                    let x = share(column, cell.columns);
                    let y = share(row, cell.rows);
                    let colour = between(corners, [x, y], self.subsampling.interpolation);
                    self.picture.pixels_mut()[index] = colour;
                }
            }
        }
    }
}

/// First and last of every cell along a side of `count` pixels. The last cell may be smaller; a side of
/// one pixel is one cell.
fn grid_lines(count: u32, step: u32) -> Vec<[u32; 2]> {
    let last = count - 1;
    let cell = |first: u32| [first, last.min(first.saturating_add(step))];
    (0..last.max(1)).step_by(step as usize).map(cell).collect()
}

/// How far along a side, from 0 to 1.
fn share(place: u32, [first, last]: [u32; 2]) -> f64 {
    if first == last { 0.0 } else { f64::from(place - first) / f64::from(last - first) }
}

/// The largest difference of a colour's parts.
fn difference(corners: &[DVec3; 4]) -> f64 {
    let most = corners.iter().copied().fold(DVec3::MIN, DVec3::max);
    let least = corners.iter().copied().fold(DVec3::MAX, DVec3::min);
    (most - least).max_element()
}

fn between(corners: &[DVec3; 4], [x, y]: [f64; 2], interpolation: Interpolation) -> DVec3 {
    match interpolation {
        Interpolation::Bilinear => {
            corners[0].lerp(corners[1], x).lerp(corners[2].lerp(corners[3], x), y)
        }
        Interpolation::Nearest => corners[usize::from(x >= 0.5) + 2 * usize::from(y >= 0.5)],
    }
}
