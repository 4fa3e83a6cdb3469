//! A large set as a [`Job`]: the same few triangles, a *tile*, again and again at other places in
//! memory, so that from a small set to a large one nothing changes but where the numbers lie:
//! what a branch predictor sees is the same, and so are the exact answers.
//!
//! An item is a tile with the next few rays. Items go through memory from the first tile to the last,
//! and begin again there. The rays of one item meet each triangle once: a second time it would be near.

use std::hint::black_box;

use super::aligned::Aligned;
use super::best::ANSWER_NUMBERS;
use super::nearest::{RAY_NUMBERS, Scene};
use super::nearest_job::{NearestLoop, Shape, Storing};
use super::packed::{self, pack, unpack};
use crate::job::{Answer, Block, Job, Tally};
use crate::number::Element;
use crate::policy::Ray;

/// Triangles of a tile: a multiple of every layout's step, and with 16 rays as many tests as a branch
/// predictor remembers ([`crate::measure::PREDICTED_TESTS`]).
pub const TILE: usize = 256;

/// How often every ray walks over a tile before a block: until its branches are known.
const WARM_PASSES: usize = 4;

/// Bytes that are brought near together.
const LINE: usize = 64;

/// How large a set is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Number of tiles, at least 1.
    pub tiles: usize,
    /// Bytes of the machine's largest cache; `usize::MAX` where that is unknown.
    pub cache_bytes: usize,
}

/// Rays and a large set with the loop that tests them.
pub struct TilesJob<E> {
    shape: Shape,
    rays: Aligned<E>,
    /// Every tile's numbers.
    numbers: Aligned<E>,
    /// Runs of numbers that a tile lies in.
    runs: usize,
    /// Numbers of a tile.
    tile: usize,
    extent: Extent,
    answers: Aligned<E>,
    run: NearestLoop<E>,
}

impl<E: Element> TilesJob<E> {
    /// A job over `rays`, whose number is a multiple of the shape's, and a set made of `records`, of
    /// which there are [`TILE`].
    pub fn new<T: AsRef<[E]>>(
        shape: Shape,
        rays: &[Ray<E>],
        records: &[T],
        storing: &Storing<E, T>,
        extent: Extent,
        run: NearestLoop<E>,
    ) -> Self {
        let mut tile = vec![E::ZERO; (storing.length)(records)];
        (storing.lay_out)(records, &mut tile);
        let runs = (storing.runs)(records.first().map_or(1, |record| record.as_ref().len()));
        TilesJob {
            shape,
            rays: Aligned::new(&pack(rays, shape.lanes)),
            numbers: laid_out(&tile, runs, extent.tiles),
            runs,
            tile: tile.len(),
            extent,
            answers: Aligned::new(&vec![E::ZERO; rays.len() * ANSWER_NUMBERS]),
            run,
        }
    }

    /// Items' worth of rays.
    fn turns(&self) -> usize {
        self.rays.len() / (RAY_NUMBERS * self.shape.rays)
    }

    /// One tile against the rays whose turn it is.
    fn item(&mut self, item: usize) -> Tally {
        let Shape { rays, lanes, outputs } = self.shape;
        let (turn, tile) = (item % self.turns(), item % self.extent.tiles);
        let first = tile * (self.tile / self.runs);
        let length = if self.runs == 1 { self.tile } else { self.tile * self.extent.tiles };
        let answer = turn * ANSWER_NUMBERS * rays..(turn + 1) * ANSWER_NUMBERS * rays;
        (self.run)(Scene {
            rays: &self.rays[turn * RAY_NUMBERS * rays..][..RAY_NUMBERS * rays],
            numbers: &self.numbers[first..first + length],
            triangles: TILE,
            answers: &mut self.answers[answer.clone()],
        });
        packed::tally(&self.answers[answer], lanes, outputs)
    }

    /// Reads a number of every line of a tile.
    fn touch_tile(&self, tile: usize) {
        let run = self.tile / self.runs;
        for first in (0..self.runs).map(|of| (of * self.extent.tiles + tile) * run) {
            for number in self.numbers[first..first + run].iter().step_by(LINE / size_of::<E>()) {
                black_box(*number);
            }
        }
    }
}

/// A tile so many times. Where it lies in several runs, each is repeated by itself. Behind the last run
/// there is room for a walk that begins at the last tile to be told where that run would end.
fn laid_out<E: Element>(tile: &[E], runs: usize, tiles: usize) -> Aligned<E> {
    let run = tile.len() / runs;
    let behind = if runs == 1 { 0 } else { run * (tiles - 1) };
    let mut numbers = Aligned::filled(E::ZERO, tile.len() * tiles + behind);
    for (stretch, run) in numbers.chunks_exact_mut(run * tiles).zip(tile.chunks_exact(run)) {
        stretch.chunks_exact_mut(run.len()).for_each(|place| place.copy_from_slice(run));
    }
    numbers
}

impl<E: Element> Job for TilesJob<E> {
    /// Whole walks over the set; of one with fewer tiles than turns, as many as let every tile meet
    /// every ray equally often.
    fn items(&self) -> usize {
        let (tiles, turns) = (self.extent.tiles, self.turns());
        if tiles < turns { tiles * turns / greatest_common_divisor(tiles, turns) } else { tiles }
    }

    fn tests_per_item(&self) -> u64 {
        (self.shape.rays * TILE) as u64
    }

    fn run(&mut self, block: Block) -> Tally {
        let mut tally = Tally::default();
        let items = block.first..block.first + block.items;
        if block.literal {
            for item in items {
                (0..block.repeats).for_each(|_| tally = tally.plus(self.item(item)));
            }
        } else {
            for _ in 0..block.repeats {
                items.clone().for_each(|item| tally = tally.plus(self.item(item)));
            }
        }
        tally
    }

    /// All tiles are alike: a new order is the old one.
    fn permute(&mut self, _permutation: &[u32]) {}

    /// Reads the whole set once, up to the tile before the block, and does the last few items of the
    /// way, so that the branches are known as well. A set larger than every cache is not read: whatever
    /// comes next in its walk has not been near for longer than any cache holds.
    fn approach(&mut self, block: Block) {
        let tiles = self.extent.tiles;
        if self.tile * tiles * size_of::<E>() <= self.extent.cache_bytes {
            let after = block.first + block.items;
            (after..after + tiles).for_each(|tile| self.touch_tile(tile % tiles));
        }
        let (items, warm) = (self.items(), WARM_PASSES * self.turns());
        // So many walks later, for the difference to be a number.
        let start = block.first + warm.next_multiple_of(items);
        (start - warm..start).for_each(|item| {
            self.item(item % items);
        });
    }

    /// Of every ray, against one tile.
    fn answers(&mut self) -> Vec<Answer> {
        (0..self.turns()).for_each(|item| {
            self.item(item);
        });
        unpack(&self.answers, self.shape.lanes)
    }
}

/// Euclid's.
fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::{Aos, Aosoa, Layout, Soa};
    use crate::kernels::Source;

    /// Records of three numbers: 3 x triangle + place.
    fn records() -> Vec<[f32; 3]> {
        (0..TILE as u16).map(|i| [0, 1, 2].map(|place| f32::from(3 * i + place))).collect()
    }

    /// What every tile of a set holds, read as a loop reads it.
    fn read<L: Layout>(tiles: usize) -> Vec<Vec<[f32; 3]>> {
        let storing = Storing::of::<L>();
        let extent = Extent { tiles, cache_bytes: usize::MAX };
        let shape = Shape { lanes: 1, rays: 1, outputs: 0 };
        let job = TilesJob::new(shape, &[], &records(), &storing, extent, |_| {});
        let (run, whole) = (job.tile / job.runs, job.tile * tiles);
        let length = if job.runs == 1 { job.tile } else { whole };
        let tile = |tile: usize| {
            let walk = L::walk(&job.numbers[tile * run..][..length], 3, TILE);
            walk.map(|source| [0, 1, 2].map(|place| source.number(place))).collect()
        };
        (0..tiles).map(tile).collect()
    }

    #[test]
    fn every_tile_holds_every_triangle_in_every_layout() {
        for tiles in [1, 2, 5, 16] {
            assert_eq!(read::<Aos>(tiles), vec![records(); tiles]);
            assert_eq!(read::<Soa>(tiles), vec![records(); tiles]);
            assert_eq!(read::<Aosoa<16>>(tiles), vec![records(); tiles]);
        }
    }

    /// A loop whose answer to any ray is a hit of the first triangle, at the distance that is its first
    /// number.
    fn first_number(scene: Scene<'_, f32>) {
        scene.answers[..2].copy_from_slice(&[0.0, scene.numbers[0]]);
    }

    fn ray() -> Ray<f32> {
        use crate::number::Vec3;
        let zero = Vec3([0.0; 3]);
        Ray { origin: zero, direction: zero, end: zero, t_min: 0.0, t_max: 1.0 }
    }

    /// A set whose tiles are numbered by their first number.
    fn numbered(tiles: usize, rays: usize) -> TilesJob<f32> {
        let storing = Storing::of::<Aos>();
        let extent = Extent { tiles, cache_bytes: usize::MAX };
        let shape = Shape { lanes: 1, rays: 1, outputs: 1 };
        let rays = vec![ray(); rays];
        let mut job = TilesJob::new(shape, &rays, &records(), &storing, extent, first_number);
        let size = job.tile;
        let tiles = job.numbers.chunks_exact_mut(size);
        tiles.zip(0u16..).for_each(|(tile, number)| tile[0] = f32::from(number));
        job
    }

    /// Tiles in the order in which the items of a block meet them.
    fn met(job: &mut TilesJob<f32>, first: usize, items: usize) -> Vec<f32> {
        let item = |item| Block { first: item, items: 1, repeats: 1, literal: false };
        let items = first..first + items;
        items.map(|at| f32::from_bits(job.run(item(at)).bits[0] as u32)).collect()
    }

    #[test]
    fn windows_meet_every_tile_once_and_in_the_order_of_memory() {
        let mut job = numbered(40, 16);
        assert_eq!(job.items(), 40);
        let windows = [(0, 13), (13, 13), (26, 14)];
        let met: Vec<f32> =
            windows.into_iter().flat_map(|(first, items)| met(&mut job, first, items)).collect();
        assert_eq!(met, (0u16..40).map(f32::from).collect::<Vec<f32>>());
    }

    #[test]
    fn where_rays_are_more_than_tiles_every_tile_meets_every_ray_equally_often() {
        for (tiles, rays, walks) in [(1, 16, 16), (3, 16, 16), (4, 16, 4), (10, 16, 8), (3, 1, 1)] {
            let mut job = numbered(tiles, rays);
            let items = job.items();
            assert_eq!(items, tiles * walks);
            for tile in 0..tiles as u16 {
                let times =
                    met(&mut job, 0, items).into_iter().filter(|met| *met == f32::from(tile));
                assert_eq!(times.count(), walks);
            }
        }
    }

    #[test]
    fn arrays_of_a_number_are_as_long_as_the_set() {
        let numbers = laid_out(&[1.0f32, 2.0, 3.0, 4.0], 2, 3);
        assert_eq!(numbers[..12], [1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 3.0, 4.0, 3.0, 4.0, 3.0, 4.0]);
        assert_eq!(numbers.len(), 12 + 4);
    }
}
