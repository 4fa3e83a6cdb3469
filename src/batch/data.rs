//! The prepared data behind a [`Job`], generic over kernel and element only.

use std::hint::black_box;

use super::aligned::Aligned;
use super::nearest::{ANSWER_NUMBERS, RAY_NUMBERS, Scene};
use super::pairs::Walk;
use crate::job::{Answer, Block, Job, Tally};
use crate::number::{Element, Vec3};
use crate::policy::Ray;
use crate::workload;

/// A ray of a workload in the precision `E`; infinite bounds become the largest finite number.
pub fn widened<E: Element>(ray: &workload::Ray) -> Ray<E> {
    let vector = |v: glam::Vec3| Vec3(v.to_array().map(E::from_f32));
    let bound = |t: f32| {
        if t >= f32::MAX {
            E::MAX
        } else if t <= -f32::MAX {
            -E::MAX
        } else {
            E::from_f32(t)
        }
    };
    Ray {
        origin: vector(ray.origin),
        direction: vector(ray.direction),
        end: vector(ray.end),
        t_min: bound(ray.t_min),
        t_max: bound(ray.t_max),
    }
}

/// The compiled loop of a form over pairs.
pub type PairsLoop<E, T> = fn(Walk<'_, (Ray<E>, T)>) -> Tally;

/// The compiled loop of a form over packets of rays and all triangles.
pub type NearestLoop<E, T> = fn(Scene<'_, E, T>);

/// Pairs of rays and records with the loop that tests them.
pub struct PairsJob<E, T> {
    original: Vec<(Ray<E>, T)>,
    laid_out: Aligned<(Ray<E>, T)>,
    run: PairsLoop<E, T>,
    code: fn(&Ray<E>, &T) -> u8,
}

impl<E: Element, T: Copy> PairsJob<E, T> {
    /// A job over `pairs`; `code` gives the exit of one test, for answers only.
    pub fn new(pairs: Vec<(Ray<E>, T)>, run: PairsLoop<E, T>, code: fn(&Ray<E>, &T) -> u8) -> Self {
        PairsJob { laid_out: Aligned::new(&pairs), original: pairs, run, code }
    }
}

impl<E: Element, T: Copy> Job for PairsJob<E, T> {
    fn items(&self) -> usize {
        self.original.len()
    }

    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        let mut tally = Tally::default();
        let pairs = &*self.laid_out;
        if block.literal {
            for pair in pairs[block.first..][..block.items].chunks_exact(1) {
                tally = tally.plus((self.run)(Walk { pairs: pair, times: block.repeats }));
            }
        } else {
            let pairs = &pairs[block.first..][..block.items];
            tally = (self.run)(Walk { pairs, times: block.repeats });
        }
        tally
    }

    fn permute(&mut self, permutation: &[u32]) {
        for (place, &from) in self.laid_out.iter_mut().zip(permutation) {
            *place = self.original[from as usize];
        }
    }

    fn touch(&mut self, block: Block) {
        for pair in &self.laid_out[block.first..][..block.items] {
            black_box(*pair);
        }
    }

    fn answers(&mut self) -> Vec<Answer> {
        let mut answers = Vec::with_capacity(self.original.len());
        for (first, (ray, record)) in self.original.iter().enumerate() {
            let pairs = &self.original[first..=first];
            let tally = (self.run)(Walk { pairs, times: 1 });
            let number = |i: usize| E::from_bits(tally.bits[i]).to_f64();
            answers.push(Answer {
                triangle: (tally.hits > 0).then_some(first),
                t: number(0),
                u: number(1),
                v: number(2),
                point: [number(3), number(4), number(5)],
                normal: [number(6), number(7), number(8)],
                code: (self.code)(ray, record),
            });
        }
        answers
    }
}

/// Packets of rays and records with the loop that tests them.
pub struct NearestJob<E, T> {
    lanes: usize,
    outputs: usize,
    original: Vec<E>,
    laid_out: Aligned<E>,
    original_records: Vec<T>,
    records: Aligned<T>,
    answers: Aligned<E>,
    run: NearestLoop<E, T>,
}

impl<E: Element, T: Copy> NearestJob<E, T> {
    /// A job over `rays`, whose number is a multiple of `lanes`, and `records`. `outputs` numbers of
    /// an answer are reported: 0, t, with u and v, or all 9.
    pub fn new(
        (lanes, outputs): (usize, usize),
        rays: &[Ray<E>],
        records: Vec<T>,
        run: NearestLoop<E, T>,
    ) -> Self {
        let mut numbers = Vec::with_capacity(rays.len() * RAY_NUMBERS);
        for packet in rays.chunks_exact(lanes) {
            for row in 0..RAY_NUMBERS {
                numbers.extend(packet.iter().map(|ray| ray_number(ray, row)));
            }
        }
        let answers = vec![E::ZERO; rays.len() * ANSWER_NUMBERS];
        NearestJob {
            lanes,
            outputs,
            laid_out: Aligned::new(&numbers),
            original: numbers,
            records: Aligned::new(&records),
            original_records: records,
            answers: Aligned::new(&answers),
            run,
        }
    }
}

/// The `row`-th number of a ray, in the order of [`RAY_NUMBERS`].
fn ray_number<E: Element>(ray: &Ray<E>, row: usize) -> E {
    match row {
        0..3 => ray.origin.0[row],
        3..6 => ray.direction.0[row - 3],
        6..9 => ray.end.0[row - 6],
        9 => ray.t_min,
        _ => ray.t_max,
    }
}

/// The tally of packets' answers, of which the first `outputs` numbers are reported. Here, once per
/// element type, rather than in every form: a packet has been through all triangles by then.
fn sum<E: Element>(answers: &[E], lanes: usize, outputs: usize) -> Tally {
    let mut tally = Tally::default();
    for packet in answers.chunks_exact(ANSWER_NUMBERS * lanes) {
        let (triangles, numbers) = packet.split_at(lanes);
        for (sum, row) in tally.bits.iter_mut().zip(numbers.chunks_exact(lanes)).take(outputs) {
            for (number, triangle) in row.iter().zip(triangles) {
                *sum = sum.wrapping_add(number.bits() & keep(*triangle));
            }
        }
        tally.hits += triangles.iter().map(|triangle| keep(*triangle) & 1).sum::<u64>();
    }
    tally
}

/// All bits where a triangle was hit, none where its number is -1.
fn keep<E: Element>(triangle: E) -> u64 {
    u64::from(triangle.ge(E::ZERO)).wrapping_neg()
}

impl<E: Element, T: Copy> Job for NearestJob<E, T> {
    fn items(&self) -> usize {
        self.laid_out.len() / (RAY_NUMBERS * self.lanes)
    }

    fn tests_per_item(&self) -> u64 {
        (self.lanes * self.records.len()) as u64
    }

    fn run(&mut self, block: Block) -> Tally {
        let (ray, answer) = (RAY_NUMBERS * self.lanes, ANSWER_NUMBERS * self.lanes);
        let mut tally = Tally::default();
        let mut run = |first: usize, items: usize| {
            let scene = Scene {
                rays: &self.laid_out[first * ray..(first + items) * ray],
                records: &self.records,
                answers: &mut self.answers[first * answer..(first + items) * answer],
            };
            (self.run)(scene);
            let found = &self.answers[first * answer..(first + items) * answer];
            tally = tally.plus(sum(found, self.lanes, self.outputs));
        };
        if block.literal {
            for first in block.first..block.first + block.items {
                (0..block.repeats).for_each(|_| run(first, 1));
            }
        } else {
            (0..block.repeats).for_each(|_| run(block.first, block.items));
        }
        tally
    }

    fn permute(&mut self, permutation: &[u32]) {
        let ray = RAY_NUMBERS * self.lanes;
        for (place, &from) in self.laid_out.chunks_exact_mut(ray).zip(permutation) {
            place.copy_from_slice(&self.original[from as usize * ray..][..ray]);
        }
    }

    fn shared_records(&self) -> usize {
        self.original_records.len()
    }

    fn permute_shared(&mut self, permutation: &[u32]) {
        for (place, &from) in self.records.iter_mut().zip(permutation) {
            *place = self.original_records[from as usize];
        }
    }

    fn touch(&mut self, block: Block) {
        let ray = RAY_NUMBERS * self.lanes;
        for number in &self.laid_out[block.first * ray..][..block.items * ray] {
            black_box(*number);
        }
        for record in self.records.iter() {
            black_box(*record);
        }
    }

    fn answers(&mut self) -> Vec<Answer> {
        self.laid_out.copy_from_slice(&self.original);
        self.records.copy_from_slice(&self.original_records);
        self.run(Block::whole(self));
        let mut answers = Vec::with_capacity(self.items() * self.lanes);
        for packet in self.answers.chunks_exact(ANSWER_NUMBERS * self.lanes) {
            for lane in 0..self.lanes {
                let number = |row: usize| packet[row * self.lanes + lane].to_f64();
                let triangle = (number(0) >= 0.0).then_some(number(0) as usize);
                answers.push(Answer {
                    triangle,
                    t: number(1),
                    u: number(2),
                    v: number(3),
                    point: [number(4), number(5), number(6)],
                    normal: [number(7), number(8), number(9)],
                    code: 255,
                });
            }
        }
        answers
    }
}
