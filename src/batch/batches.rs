//! Triangles sorted by the axis of their projection into three batches, each of which has a loop that
//! knows its axis (thesis H, 4.2).

use std::hint::black_box;
use std::marker::PhantomData;

use super::best::{ANSWER_NUMBERS, Best};
use super::nearest::{RAY_NUMBERS, Scene, align_frame, load, places, step};
use crate::kernels::{Kernel, Whole};
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real, Spread};
use crate::policy::{Policy, Ray};

/// The place of a record that holds the axis.
const AXIS: usize = 3;
/// The place that is unused otherwise: here, which triangle it is.
const INDEX: usize = 11;

/// One loop over packets of rays and the batches of `X`, `Y` and `Z`, whose records hold the axis in place 3
/// and nothing in place 11. Of two triangles at one distance in different batches, that of the earlier
/// batch is taken.
pub struct Batches<X, Y, Z, P, R>(PhantomData<(X, Y, Z, P, R)>);

impl<L, X, Y, Z, P, R> Batch<L> for Batches<X, Y, Z, P, R>
where
    L: Level,
    X: Kernel,
    Y: Kernel,
    Z: Kernel,
    P: Policy,
    R: Real + On<L>,
{
    type Data<'a> = Scene<'a, R::Element>;
    type Yield = ();

    #[inline(always)]
    fn run(token: L::Token, scene: Self::Data<'_>) {
        let token = R::token_on(token);
        align_frame::<R>();
        let packets = scene.rays.chunks_exact(RAY_NUMBERS * R::LANES);
        let answers = scene.answers.chunks_exact_mut(ANSWER_NUMBERS * R::LANES);
        for (packet, answer) in packets.zip(answers) {
            let mut ray = load::<R>(token, packet);
            let mut best = Best::nothing(token, &ray);
            let rest = batch::<X, P, R>(token, 0, scene.numbers, &mut ray, &mut best);
            let rest = batch::<Y, P, R>(token, 1, rest, &mut ray, &mut best);
            batch::<Z, P, R>(token, 2, rest, &mut ray, &mut best);
            best.write::<P>(&ray, answer);
        }
    }
}

/// The triangles of one axis, with which `numbers` begins; what is left behind them.
#[inline(always)]
fn batch<'a, K: Kernel, P: Policy, R: Real>(
    token: R::Token,
    axis: u32,
    numbers: &'a [R::Element],
    ray: &mut Ray<R>,
    best: &mut Best<R>,
) -> &'a [R::Element] {
    let aim = K::aim::<P, R>(ray);
    let axis = R::Element::from_index(axis);
    let mut rest = numbers;
    while let Some((record, behind)) = rest.split_at_checked(places::<K, R::Element>())
        && !record[AXIS].ne(axis)
    {
        if R::LANES == 1 {
            // A single ray must not be tested against several triangles at once.
            black_box(());
        }
        let met = Spread::spread(token, K::read::<P, R::Element, _>(&Whole(record)));
        step::<K, P, R>(ray, &aim, &met, R::splat(token, record[INDEX]), best);
        rest = behind;
    }
    rest
}

/// Writes records batch after batch, in each in their order.
pub fn lay_out_batches<E: Element, T: AsRef<[E]>>(records: &[T], numbers: &mut [E]) {
    let of_axis = |axis: u32| {
        records.iter().enumerate().filter(move |(_, one)| one.as_ref()[AXIS].index() == axis)
    };
    let mut rest = numbers;
    for (triangle, record) in (0..3).flat_map(of_axis) {
        let record = record.as_ref();
        let (place, behind) = rest.split_at_mut(record.len());
        place.copy_from_slice(record);
        place[INDEX] = E::from_f32(triangle as f32);
        rest = behind;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_lie_behind_each_other_and_say_which_triangle_is_which() {
        let record = |axis: u32| {
            let mut record = [0.5f32; 12];
            record[AXIS] = f32::from_index(axis);
            record
        };
        let records = [2, 0, 1, 0, 2].map(record);
        let mut numbers = vec![0.0; 60];
        lay_out_batches(&records, &mut numbers);
        let read: Vec<(u32, f32)> =
            numbers.chunks(12).map(|record| (record[AXIS].index(), record[INDEX])).collect();
        assert_eq!(read, [(0, 1.0), (0, 3.0), (1, 2.0), (2, 0.0), (2, 4.0)]);
        assert_eq!(numbers[0], 0.5);
    }
}
