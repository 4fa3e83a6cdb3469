//! Rays and answers of packets as rows of numbers, and what is read from them.

use super::best::ANSWER_NUMBERS;
use super::nearest::RAY_NUMBERS;
use crate::job::{Answer, Tally};
use crate::number::Element;
use crate::policy::Ray;

/// Rays as loops read them: packets of `lanes` rays, [`RAY_NUMBERS`] rows of one number of each.
pub fn pack<E: Element>(rays: &[Ray<E>], lanes: usize) -> Vec<E> {
    let mut numbers = Vec::with_capacity(rays.len() * RAY_NUMBERS);
    for packet in rays.chunks_exact(lanes) {
        for row in 0..RAY_NUMBERS {
            numbers.extend(packet.iter().map(|ray| ray_number(ray, row)));
        }
    }
    numbers
}

/// The numbers of a ray, in the order of [`RAY_NUMBERS`].
pub fn ray_numbers<E: Element>(ray: &Ray<E>) -> [E; RAY_NUMBERS] {
    std::array::from_fn(|row| ray_number(ray, row))
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
pub fn tally<E: Element>(answers: &[E], lanes: usize, outputs: usize) -> Tally {
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

/// The answers of packets, ray by ray.
pub fn unpack<E: Element>(answers: &[E], lanes: usize) -> Vec<Answer> {
    let mut unpacked = Vec::with_capacity(answers.len() / ANSWER_NUMBERS);
    for packet in answers.chunks_exact(ANSWER_NUMBERS * lanes) {
        for lane in 0..lanes {
            let number = |row: usize| packet[row * lanes + lane].to_f64();
            let triangle = (number(0) >= 0.0).then_some(number(0) as usize);
            unpacked.push(Answer {
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
    unpacked
}
