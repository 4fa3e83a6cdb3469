//! Streams of one kind of operation, or of two: what the units of a level can do of it at most.
//!
//! Twelve operations stand in a loop, and none waits for another but for the one at its own place in
//! the walk before. Which kind stands at which place is the digits of a number. Operands come from a
//! black box, and what comes out depends on every operation, so that none can be left out; with the
//! operands that are timed (sums of 0, products with 1) it is always the same.
//!
//! An optimiser that does two walks at once must not find two operations to be one. Roundings forbid
//! it, but for flips and selections. So the bits that are turned over come from memory in every walk,
//! and each selection is between a number and its neighbour, by another mask than the neighbour's.

use std::hint::black_box;
use std::marker::PhantomData;

use super::WIDEST;
use super::kind::{Kind, PLACES, mix};
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real, Toggle};

/// The loop of a mix.
pub struct Stream<R, const MIX: u64>(PhantomData<R>);

/// What is the same in every walk.
struct Operands<R: Real> {
    factor: R,
    addend: R,
    masks: [R::Mask; 2],
}

/// What is loaded: as many numbers for each place as the widest register has, and as many with the
/// bits that are turned over.
#[repr(align(64))]
struct Table<E>([E; (PLACES + 1) * WIDEST]);

/// What goes from walk to walk. For more masks than these few AVX-512 has no registers.
struct State<R: Real> {
    numbers: [R; PLACES],
    masks: [R::Mask; MASKS],
}

const MASKS: usize = 2;

impl<L: Level, R: Toggle + On<L>, const MIX: u64> Batch<L> for Stream<R, MIX> {
    type Data<'a> = usize;
    type Yield = u64;

    #[inline(always)]
    fn run(token: L::Token, walks: usize) -> u64 {
        let token = R::token_on(token);
        let one = R::splat(token, black_box(R::Element::ONE));
        let zero = R::splat(token, black_box(R::Element::ZERO));
        let mask = zero.lt(one);
        let masks = [mask, zero.lt(R::splat(token, black_box(R::Element::ONE)))];
        let operands = Operands { factor: one, addend: zero, masks };
        let table = Table([black_box(R::Element::ZERO); (PLACES + 1) * WIDEST]);
        // Each number from the box: of twelve that are the same the optimiser keeps one.
        let mut state = State { numbers: [one; PLACES], masks: [mask; MASKS] };
        let start = black_box([R::Element::ONE; PLACES]);
        for (number, start) in state.numbers.iter_mut().zip(start) {
            *number = R::splat(token, start);
        }
        bits(&walk::<R, MIX>(state, &operands, &table, walks))
    }
}

/// All walks.
#[inline(always)]
fn walk<R: Toggle, const MIX: u64>(
    mut state: State<R>,
    operands: &Operands<R>,
    table: &Table<R::Element>,
    walks: usize,
) -> State<R> {
    for _ in 0..walks {
        let reads = const {
            mix::count(MIX, Kind::Compare)
                + mix::count(MIX, Kind::Load)
                + mix::count(MIX, Kind::Flip)
        };
        let table = if reads > 0 { black_box(table) } else { table };
        place::<R, MIX, 0>(&mut state, operands, table);
        place::<R, MIX, 1>(&mut state, operands, table);
        place::<R, MIX, 2>(&mut state, operands, table);
        place::<R, MIX, 3>(&mut state, operands, table);
        place::<R, MIX, 4>(&mut state, operands, table);
        place::<R, MIX, 5>(&mut state, operands, table);
        place::<R, MIX, 6>(&mut state, operands, table);
        place::<R, MIX, 7>(&mut state, operands, table);
        place::<R, MIX, 8>(&mut state, operands, table);
        place::<R, MIX, 9>(&mut state, operands, table);
        place::<R, MIX, 10>(&mut state, operands, table);
        place::<R, MIX, 11>(&mut state, operands, table);
    }
    state
}

/// The operation at a place. Comparisons are of a number that nothing changes with numbers from
/// memory: in registers there is no room for twelve of them.
#[inline(always)]
fn place<R: Toggle, const MIX: u64, const PLACE: usize>(
    state: &mut State<R>,
    operands: &Operands<R>,
    table: &Table<R::Element>,
) {
    let Operands { factor, addend, masks } = *operands;
    let x = state.numbers[PLACE];
    let digit = const { mix::digit(MIX, PLACE) };
    if digit == Kind::Compare as u64 {
        let limit = R::load(x.token(), &table.0[PLACE * WIDEST..][..R::LANES]);
        let kept = &mut state.masks[PLACE % MASKS];
        *kept = *kept & factor.gt(limit);
        return;
    }
    state.numbers[PLACE] = if digit == Kind::Add as u64 {
        x + addend
    } else if digit == Kind::Multiply as u64 {
        x * factor
    } else if digit == Kind::Fused as u64 {
        x.mul_add(factor, addend)
    } else if digit == Kind::Divide as u64 {
        x / factor
    } else if digit == Kind::Select as u64 {
        let step = const { mix::step(MIX, Kind::Select) };
        R::select(masks[PLACE / step % 2], state.numbers[(PLACE + step) % PLACES], x)
    } else if digit == Kind::Flip as u64 {
        x.toggled(R::load(x.token(), &table.0[PLACES * WIDEST..][..R::LANES]))
    } else if digit == Kind::Load as u64 {
        x + R::splat(x.token(), table.0[PLACE * WIDEST])
    } else {
        x
    };
}

/// Something of every number and every mask.
#[inline(always)]
fn bits<R: Real>(state: &State<R>) -> u64 {
    let mut lanes = [R::Element::ZERO; WIDEST];
    let mut bits = 0u64;
    for number in state.numbers {
        number.store(&mut lanes);
        bits = bits.wrapping_mul(3).wrapping_add(lanes[0].bits());
    }
    for mask in state.masks {
        let number = state.numbers[0];
        R::select(mask, number.one(), number.zero()).store(&mut lanes);
        bits = bits.wrapping_mul(3).wrapping_add(lanes[0].bits());
    }
    bits
}

impl<R: Real> Clone for Operands<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: Real> Copy for Operands<R> {}

#[cfg(test)]
mod tests {
    use super::*;

    const NUMBERS: [f32; PLACES] = [1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12.];

    /// What is there after some walks from these numbers.
    fn after<const MIX: u64>(walks: usize, masks: [bool; 2], entry: f32) -> State<f32> {
        let operands = Operands { factor: 2.0, addend: 5.0, masks };
        let state = State { numbers: NUMBERS, masks: [true; MASKS] };
        let mut table = Table([entry; (PLACES + 1) * WIDEST]);
        table.0[PLACES * WIDEST..].fill(-0.0);
        walk::<f32, MIX>(state, &operands, &table, walks)
    }

    /// The numbers after two walks.
    fn twice<const MIX: u64>() -> [f32; PLACES] {
        after::<MIX>(2, [true, false], 4.0).numbers
    }

    #[test]
    fn every_place_does_its_kind() {
        assert_eq!(twice::<{ mix::alone(Kind::Add) }>(), NUMBERS.map(|x| x + 10.0));
        assert_eq!(twice::<{ mix::alone(Kind::Multiply) }>(), NUMBERS.map(|x| x * 4.0));
        assert_eq!(twice::<{ mix::alone(Kind::Fused) }>(), NUMBERS.map(|x| x * 4.0 + 15.0));
        assert_eq!(twice::<{ mix::alone(Kind::Divide) }>(), NUMBERS.map(|x| x / 4.0));
        assert_eq!(twice::<{ mix::alone(Kind::Load) }>(), NUMBERS.map(|x| x + 8.0));
        let once = after::<{ mix::alone(Kind::Flip) }>(1, [true; 2], 4.0).numbers;
        assert_eq!(once, NUMBERS.map(|x| -x));
        let mixed = after::<{ mix::third(Kind::Flip, Kind::Add) }>(1, [true; 2], 4.0).numbers;
        assert_eq!(mixed[..4], [6.0, 7.0, -3.0, 9.0]);
    }

    /// Even places take the next number, odd ones keep theirs; where both take, the last place has what
    /// the first one took.
    #[test]
    fn selections_are_by_the_masks_in_turn() {
        let of = |masks| after::<{ mix::alone(Kind::Select) }>(1, masks, 4.0).numbers;
        assert_eq!(of([true, false]), [2., 2., 4., 4., 6., 6., 8., 8., 10., 10., 12., 12.]);
        assert_eq!(of([true; 2]), [2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 2.]);
        assert_eq!(of([false; 2]), NUMBERS);
    }

    /// 2 is above 1 and not above 2.
    #[test]
    fn comparisons_join_the_masks() {
        let of = |entry| after::<{ mix::alone(Kind::Compare) }>(1, [true; 2], entry);
        assert_eq!((of(1.0).numbers, of(1.0).masks), (NUMBERS, [true; MASKS]));
        assert_eq!(of(2.0).masks, [false; MASKS]);
    }

    /// A comparison of any one place that fails shows in the mask of that place.
    #[test]
    fn every_comparison_counts() {
        let operands = Operands { factor: 2.0, addend: 0.0, masks: [true; 2] };
        for place in 0..PLACES {
            let mut table = Table([0.0; (PLACES + 1) * WIDEST]);
            table.0[place * WIDEST] = 9.0;
            let state = State { numbers: NUMBERS, masks: [true; MASKS] };
            let state = walk::<f32, { mix::alone(Kind::Compare) }>(state, &operands, &table, 1);
            let failed: Vec<usize> = (0..MASKS).filter(|mask| !state.masks[*mask]).collect();
            assert_eq!(failed, [place % MASKS]);
        }
    }

    #[test]
    fn what_comes_out_depends_on_every_place() {
        let of = |numbers: [f32; PLACES], masks| bits(&State { numbers, masks });
        let usual = of([1.0; PLACES], [true; MASKS]);
        for place in 0..PLACES {
            let mut numbers = [1.0; PLACES];
            numbers[place] = 2.0;
            assert_ne!(of(numbers, [true; MASKS]), usual);
        }
        for place in 0..MASKS {
            let mut masks = [true; MASKS];
            masks[place] = false;
            assert_ne!(of([1.0; PLACES], masks), usual);
        }
    }
}
