//! The uniform grid, walked cell by cell (Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray
//! Tracing", 1987). A triangle lies in every closed cell that its box touches.
//!
//! A walk goes on across the plane that the ray meets first. Which of two that is rounding can mistake
//! where the ray passes an edge of cells closely: then the cells on both ways around the edge are looked
//! into. What is computed of a plane errs by less than [`WIDER`]; from a distance of more than 2^20 cells
//! that is not much less than a cell any more, and every triangle is tested.

use super::beam::WIDER;
use super::placed::{Placed, around, placed};
use super::search::Search;
use super::volume::{Bounds, Crossing, Volume};
use super::{Beam, Structure};
use crate::workload::Triangle;

/// Cells per triangle that are aimed at.
const DENSITY: f64 = 4.0;
/// Cells along an axis, at most.
const MOST_CELLS: f64 = 512.0;
/// How often a triangle may be in a list, on average.
const MOST_COPIES: usize = 16;
/// From how many cells away a walk can trust its planes.
const FARTHEST: f64 = (1u64 << 20) as f64;

/// A box of cells.
#[derive(Clone, Debug)]
pub struct Grid {
    bounds: Bounds,
    cells: [usize; 3],
    /// Where the triangles of a cell begin; one more than there are cells.
    starts: Vec<u32>,
    indices: Vec<u32>,
    all: Vec<u32>,
}

impl Grid {
    /// Of about four cells per triangle, as near to cubes as whole numbers allow; of fewer, where large
    /// triangles would lie in too many of them.
    pub fn new(triangles: &[Triangle]) -> Self {
        let placed = placed(triangles);
        let bounds = around(&placed);
        let (starts, indices, all) = (Vec::new(), Vec::new(), Vec::new());
        let mut grid = Grid { bounds, cells: [1; 3], starts, indices, all };
        let mut density = DENSITY * placed.len() as f64;
        loop {
            grid.cells = divisions(&bounds, density);
            let copies: usize = placed.iter().map(|one| grid.cells_of(one)).sum();
            if copies <= MOST_COPIES * placed.len() {
                break;
            }
            density *= 0.5;
        }
        let mut counts = vec![0u32; grid.cells.iter().product::<usize>() + 1];
        for one in &placed {
            grid.each_cell(one, |cell| counts[cell + 1] += 1);
        }
        for cell in 1..counts.len() {
            counts[cell] += counts[cell - 1];
        }
        grid.starts = counts.clone();
        let mut indices = vec![0; counts[counts.len() - 1] as usize];
        for one in &placed {
            grid.each_cell(one, |cell| {
                indices[counts[cell] as usize] = one.triangle;
                counts[cell] += 1;
            });
        }
        grid.indices = indices;
        grid.all = placed.iter().map(|one| one.triangle).collect();
        grid
    }

    /// The plane below cell `index`, and above the one before it.
    #[inline(always)]
    fn plane(&self, axis: usize, index: usize) -> f64 {
        if index == self.cells[axis] {
            return self.bounds.high[axis].into();
        }
        let share = index as f64 / self.cells[axis] as f64;
        f64::from(self.bounds.low[axis]) + share * self.bounds.extent(axis)
    }

    /// Cells of an axis whose closed interval touches that from `low` to `high`.
    fn touched(&self, axis: usize, low: f64, high: f64) -> [usize; 2] {
        let last = self.cells[axis] - 1;
        let mut first = self.near_index(axis, low);
        while first > 0 && self.plane(axis, first) >= low {
            first -= 1;
        }
        while first < last && self.plane(axis, first + 1) < low {
            first += 1;
        }
        let mut end = self.near_index(axis, high).max(first);
        while end > first && self.plane(axis, end) > high {
            end -= 1;
        }
        while end < last && self.plane(axis, end + 1) <= high {
            end += 1;
        }
        [first, end]
    }

    /// The index of a place's cell, within rounding; that of the nearest cell outside.
    #[inline(always)]
    fn near_index(&self, axis: usize, place: f64) -> usize {
        let extent = self.bounds.extent(axis);
        if extent <= 0.0 {
            return 0;
        }
        // Negative and NaN become 0.
        let share = (place - f64::from(self.bounds.low[axis])) / extent;
        ((share * self.cells[axis] as f64) as usize).min(self.cells[axis] - 1)
    }

    /// The first and the last cell of a triangle along each axis.
    fn ranges(&self, one: &Placed) -> [[usize; 2]; 3] {
        let Bounds { low, high } = one.bounds;
        [0, 1, 2].map(|i| self.touched(i, low[i].into(), high[i].into()))
    }

    fn cells_of(&self, one: &Placed) -> usize {
        self.ranges(one).iter().map(|[first, last]| last - first + 1).product()
    }

    fn each_cell(&self, one: &Placed, mut with: impl FnMut(usize)) {
        let [x, y, z] = self.ranges(one);
        for z in z[0]..=z[1] {
            for y in y[0]..=y[1] {
                for x in x[0]..=x[1] {
                    with(self.cell([x, y, z]));
                }
            }
        }
    }

    #[inline(always)]
    fn cell(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.cells[1] + y) * self.cells[0] + x
    }

    /// Looks into a cell. Whether the search is over.
    #[inline(always)]
    fn look(&self, cell: [usize; 3], search: &mut Search) -> bool {
        let cell = self.cell(cell);
        let (first, end) = (self.starts[cell] as usize, self.starts[cell + 1] as usize);
        search.test_once(&self.indices[first..end])
    }

    /// Whether the ray begins too far away for its planes to be told apart.
    fn is_far(&self, beam: &Beam) -> bool {
        (0..3).any(|axis| {
            let width = self.bounds.extent(axis) / self.cells[axis] as f64;
            let below = (beam.origin[axis] - f64::from(self.bounds.low[axis])).abs();
            let above = (beam.origin[axis] - f64::from(self.bounds.high[axis])).abs();
            self.cells[axis] > 1 && below.max(above) > FARTHEST * width
        })
    }
}

/// About so many cells, by axis; one where there is no extent.
fn divisions(bounds: &Bounds, wanted: f64) -> [usize; 3] {
    let extents = [0, 1, 2].map(|axis| bounds.extent(axis).max(0.0));
    let wide: Vec<f64> = extents.iter().copied().filter(|extent| *extent > 0.0).collect();
    let measure: f64 = wide.iter().product();
    // In as many dimensions as there are.
    let per_length = (wanted / measure).powf(1.0 / wide.len().max(1) as f64);
    extents.map(|extent| {
        let cells = (extent * per_length).round();
        if cells.is_finite() { cells.clamp(1.0, MOST_CELLS) as usize } else { 1 }
    })
}

/// Where a walk is, and where it meets the next plane of each axis.
struct Steps {
    cell: [usize; 3],
    next: [f64; 3],
}

impl Steps {
    /// At the cell in which the ray enters, or at one before it: the place is computed with a few
    /// roundings, and moved back by more.
    fn begin(grid: &Grid, beam: &Beam, near: f64) -> Self {
        let cell = [0, 1, 2].map(|axis| {
            let (origin, way) = (beam.origin[axis], beam.direction[axis] * near);
            let error = WIDER * (origin.abs() + way.abs());
            let back = if beam.is_backward[axis] { error } else { -error };
            if beam.direction[axis] == 0.0 {
                // In a plane of cells either side will do, but outside of both none.
                return grid.touched(axis, origin, origin)[0];
            }
            grid.near_index_below(axis, origin + way + back, beam.is_backward[axis])
        });
        let mut steps = Steps { cell, next: [f64::INFINITY; 3] };
        for axis in 0..3 {
            steps.look_ahead(grid, beam, axis);
        }
        steps
    }

    #[inline(always)]
    fn look_ahead(&mut self, grid: &Grid, beam: &Beam, axis: usize) {
        if beam.direction[axis] != 0.0 {
            let above = usize::from(!beam.is_backward[axis]);
            self.next[axis] = beam.at(axis, grid.plane(axis, self.cell[axis] + above));
        }
    }

    /// The next cell along an axis; `None` behind the last.
    #[inline(always)]
    fn beyond(&self, grid: &Grid, beam: &Beam, axis: usize) -> Option<usize> {
        if beam.is_backward[axis] {
            self.cell[axis].checked_sub(1)
        } else {
            Some(self.cell[axis] + 1).filter(|index| *index < grid.cells[axis])
        }
    }
}

impl Grid {
    /// [`Grid::near_index`], and one cell farther back where the place is beyond its plane.
    fn near_index_below(&self, axis: usize, place: f64, is_backward: bool) -> usize {
        let index = self.near_index(axis, place);
        if is_backward {
            let is_beyond = place > self.plane(axis, index + 1);
            (index + usize::from(is_beyond)).min(self.cells[axis] - 1)
        } else {
            index - usize::from(index > 0 && place < self.plane(axis, index))
        }
    }

    /// Looks into the cells behind every choice of the planes that may come first, and goes on behind all
    /// of them. Whether the walk is over.
    fn step(&self, beam: &Beam, steps: &mut Steps, search: &mut Search) -> bool {
        let [x, y, z] = steps.next;
        let first = x.min(y).min(z);
        let tied = first + 4.0 * WIDER * first.abs();
        let axes: [bool; 3] = steps.next.map(|next| next <= tied);
        let beyond = [0, 1, 2].map(|axis| steps.beyond(self, beam, axis));
        for choice in 1..8usize {
            let mut cell = steps.cell;
            let mut is_there = true;
            for axis in 0..3 {
                if choice >> axis & 1 != 0 {
                    is_there &= axes[axis] && beyond[axis].is_some();
                    cell[axis] = beyond[axis].unwrap_or(cell[axis]);
                }
            }
            if is_there && self.look(cell, search) {
                return true;
            }
        }
        for axis in 0..3 {
            if axes[axis] {
                let Some(index) = beyond[axis] else { return true };
                steps.cell[axis] = index;
                steps.look_ahead(self, beam, axis);
            }
        }
        false
    }
}

impl Structure for Grid {
    fn walk(&self, beam: &Beam, search: &mut Search) {
        let Some(Crossing { near, far }) = self.bounds.crossing(beam, &()) else { return };
        if self.is_far(beam) {
            search.test_once(&self.all);
            return;
        }
        let mut steps = Steps::begin(self, beam, near);
        if self.look(steps.cell, search) {
            return;
        }
        // A walk ends at the last cell, where it has crossed more planes than there are: never later.
        let most: usize = self.cells.iter().sum();
        for _ in 0..=most {
            // Where the next cell begins, at the earliest.
            let next = steps.next[0].min(steps.next[1]).min(steps.next[2]) * (1.0 - WIDER);
            if next > far.min(search.bound()) || self.step(beam, &mut steps, search) {
                return;
            }
        }
    }

    fn bytes(&self) -> usize {
        let lists = self.starts.len() + self.indices.len() + self.all.len();
        lists * size_of::<u32>()
    }
}
