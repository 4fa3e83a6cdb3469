//! Streams of one kind of operation, or of two: what the units of a level can do of it at most.
//!
//! Twelve operations stand in a loop, and none waits for another but for the one at its own place in
//! the walk before. Which kind stands at which place is the digits of a number. Operands come from a
//! black box, and what comes out depends on every operation, so that none can be left out; with the
//! operands that are timed (sums of 0, products with 1) it is always the same.

use std::hint::black_box;
use std::marker::PhantomData;

use super::WIDEST;
use super::kind::{Kind, PLACES, mix};
use crate::level::{Batch, Level, On};
use crate::number::{Element, Real};

/// The loop of a mix.
pub struct Stream<R, const MIX: u64>(PhantomData<R>);

/// What is the same in every walk.
struct Operands<R: Real> {
    factor: R,
    addend: R,
    sign: R,
    other: R,
    mask: R::Mask,
}

/// What is loaded, as many numbers for each place as the widest register has.
#[repr(align(64))]
struct Table<E>([E; PLACES * WIDEST]);

/// What goes from walk to walk. More masks than these few AVX-512 has no registers for.
struct State<R: Real> {
    numbers: [R; PLACES],
    masks: [R::Mask; MASKS],
}

const MASKS: usize = 6;

impl<L: Level, R: Real + On<L>, const MIX: u64> Batch<L> for Stream<R, MIX> {
    type Data<'a> = usize;
    type Yield = u64;

    #[inline(always)]
    fn run(token: L::Token, walks: usize) -> u64 {
        let token = R::token_on(token);
        let one = R::splat(token, black_box(R::Element::ONE));
        let zero = R::splat(token, black_box(R::Element::ZERO));
        let mask = zero.lt(one);
        let operands = Operands { factor: one, addend: zero, sign: one, other: one, mask };
        let table = Table([black_box(R::Element::ZERO); PLACES * WIDEST]);
        let state = State { numbers: [one; PLACES], masks: [mask; MASKS] };
        bits(&walk::<R, MIX>(state, &operands, &table, walks))
    }
}

/// All walks.
#[inline(always)]
fn walk<R: Real, const MIX: u64>(
    mut state: State<R>,
    operands: &Operands<R>,
    table: &Table<R::Element>,
    walks: usize,
) -> State<R> {
    for _ in 0..walks {
        let reads = mix::count(MIX, Kind::Compare) + mix::count(MIX, Kind::Load) > 0;
        let table = if reads { black_box(table) } else { table };
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
fn place<R: Real, const MIX: u64, const PLACE: usize>(
    state: &mut State<R>,
    operands: &Operands<R>,
    table: &Table<R::Element>,
) {
    let Operands { factor, addend, sign, other, mask } = *operands;
    let x = state.numbers[PLACE];
    let digit = const { mix::digit(MIX, PLACE) };
    if digit == Kind::Compare as u64 {
        let limit = R::load(x.token(), &table.0[PLACE * WIDEST..][..R::LANES]);
        let kept = &mut state.masks[PLACE / 2 % MASKS];
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
        R::select(mask, other, x)
    } else if digit == Kind::Flip as u64 {
        x.signed_by(sign)
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

    /// The numbers and masks after two walks with operands of which each does something.
    fn after<const MIX: u64>(mask: bool, table: f32) -> ([f32; PLACES], [bool; MASKS]) {
        let operands = Operands { factor: 2.0, addend: 5.0, sign: -1.0f32, other: 7.0, mask };
        let state = State { numbers: [3.0; PLACES], masks: [true; MASKS] };
        let table = Table([table; PLACES * WIDEST]);
        let State { numbers, masks } = walk::<f32, MIX>(state, &operands, &table, 2);
        (numbers, masks)
    }

    #[test]
    fn every_place_does_its_kind() {
        assert_eq!(after::<{ mix::alone(Kind::Add) }>(true, 0.0).0, [13.0; PLACES]);
        assert_eq!(after::<{ mix::alone(Kind::Multiply) }>(true, 0.0).0, [12.0; PLACES]);
        assert_eq!(after::<{ mix::alone(Kind::Fused) }>(true, 0.0).0, [27.0; PLACES]);
        assert_eq!(after::<{ mix::alone(Kind::Divide) }>(true, 0.0).0, [0.75; PLACES]);
        assert_eq!(after::<{ mix::alone(Kind::Select) }>(true, 0.0).0, [7.0; PLACES]);
        assert_eq!(after::<{ mix::alone(Kind::Select) }>(false, 0.0).0, [3.0; PLACES]);
        assert_eq!(after::<{ mix::quarter(Kind::Flip, Kind::Add) }>(true, 0.0).0[3], 3.0);
        assert_eq!(after::<{ mix::alone(Kind::Load) }>(true, 4.0).0, [11.0; PLACES]);
        assert_eq!(after::<{ mix::alone(Kind::Compare) }>(true, 1.0), ([3.0; PLACES], [true; 6]));
        assert_eq!(after::<{ mix::alone(Kind::Compare) }>(true, 2.0).1, [false; 6]);
    }

    #[test]
    fn flips_are_done_once_a_walk() {
        let operands = Operands { factor: 1.0, addend: 0.0, sign: -1.0f32, other: 1.0, mask: true };
        let state = State { numbers: [3.0; PLACES], masks: [true; MASKS] };
        let table = Table([0.0; PLACES * WIDEST]);
        let state = walk::<f32, { mix::alone(Kind::Flip) }>(state, &operands, &table, 1);
        assert_eq!(state.numbers, [-3.0; PLACES]);
    }

    /// A comparison of any one place that fails shows in the mask of its pair of places.
    #[test]
    fn every_comparison_counts() {
        let operands = Operands { factor: 2.0, addend: 0.0, sign: 1.0f32, other: 1.0, mask: true };
        for place in 0..PLACES {
            let mut table = Table([0.0; PLACES * WIDEST]);
            table.0[place * WIDEST] = 9.0;
            let state = State { numbers: [3.0; PLACES], masks: [true; MASKS] };
            let state = walk::<f32, { mix::alone(Kind::Compare) }>(state, &operands, &table, 1);
            let failed: Vec<usize> = (0..MASKS).filter(|mask| !state.masks[*mask]).collect();
            assert_eq!(failed, [place / 2]);
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
