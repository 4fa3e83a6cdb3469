//! How the numbers of many triangles lie in memory (thesis H, 4.2).
//!
//! | layout | order of the numbers | next number of a triangle | same number of the next |
//! |---|---|---|---|
//! | `aos` | triangle by triangle | beside it | a record away |
//! | `soa` | number by number | as many away as there are triangles | beside it |
//! | `aosoa` | blocks of a few triangles, number by number within a block | a block's width away | beside it |

use crate::kernels::{Source, Whole};
use crate::number::Element;

/// A memory layout of records.
pub trait Layout: 'static {
    /// The column `layout`.
    const NAME: &'static str;
    /// Triangles that are stored in steps of so many; the last step is filled up.
    const STEP: usize;
    /// Where a number of a triangle lies; `places` are the numbers of a record, `count` is the number
    /// of triangles, filled up.
    fn position(triangle: usize, place: usize, places: usize, count: usize) -> usize;
    /// In how many runs of numbers, each without a gap and as far from the next as from the one
    /// before, some steps of triangles in a row lie, where a record has `places` numbers.
    fn runs(_places: usize) -> usize {
        1
    }
    /// One triangle after the other.
    type Walk<'a, E: Element>: Iterator<Item: Source<E>>;
    /// All triangles of `numbers`, the first `count`.
    fn walk<E: Element>(numbers: &[E], places: usize, count: usize) -> Self::Walk<'_, E>;
}

/// Array of structures.
pub struct Aos;
/// Structure of arrays.
pub struct Soa;
/// Arrays of small arrays, of `WIDTH` triangles each; a power of two.
pub struct Aosoa<const WIDTH: usize>;

/// Numbers of the largest record.
const MOST_PLACES: usize = 14;

impl Layout for Aos {
    const NAME: &'static str = "aos";
    const STEP: usize = 1;
    fn position(triangle: usize, place: usize, places: usize, _: usize) -> usize {
        triangle * places + place
    }
    type Walk<'a, E: Element> = Records<'a, E>;
    #[inline(always)]
    fn walk<E: Element>(numbers: &[E], places: usize, count: usize) -> Records<'_, E> {
        Records(numbers[..places * count].chunks_exact(places))
    }
}

/// The walk of [`Aos`].
pub struct Records<'a, E>(std::slice::ChunksExact<'a, E>);

impl<'a, E: Element> Iterator for Records<'a, E> {
    type Item = Whole<'a, E>;
    #[inline(always)]
    fn next(&mut self) -> Option<Whole<'a, E>> {
        match self.0.next() {
            Some(record) => Some(Whole(record)),
            None => None,
        }
    }
}

impl Layout for Soa {
    const NAME: &'static str = "soa";
    /// Every row begins at a cache line if the first does.
    const STEP: usize = 16;
    fn position(triangle: usize, place: usize, _: usize, count: usize) -> usize {
        place * count + triangle
    }
    fn runs(places: usize) -> usize {
        places
    }
    type Walk<'a, E: Element> = Columns<'a, E>;
    #[inline(always)]
    fn walk<E: Element>(numbers: &[E], places: usize, count: usize) -> Columns<'_, E> {
        Columns { rows: rows(numbers, places, count), count, next: 0 }
    }
}

/// The rows of [`Soa`], each cut to the triangles that there are, so that one comparison with `count`
/// does for all of them.
#[inline(always)]
fn rows<E>(numbers: &[E], places: usize, count: usize) -> [&[E]; MOST_PLACES] {
    let padded = numbers.len() / places;
    let mut rows = [&numbers[..0]; MOST_PLACES];
    for (row, numbers) in rows.iter_mut().zip(numbers.chunks_exact(padded)) {
        *row = &numbers[..count];
    }
    rows
}

/// The walk of [`Soa`].
pub struct Columns<'a, E> {
    rows: [&'a [E]; MOST_PLACES],
    count: usize,
    next: usize,
}

/// One triangle of [`Columns`].
pub struct Column<'a, E> {
    rows: [&'a [E]; MOST_PLACES],
    triangle: usize,
}

impl<'a, E: Element> Iterator for Columns<'a, E> {
    type Item = Column<'a, E>;
    #[inline(always)]
    fn next(&mut self) -> Option<Column<'a, E>> {
        let triangle = self.next;
        if triangle < self.count {
            self.next += 1;
            Some(Column { rows: self.rows, triangle })
        } else {
            None
        }
    }
}

impl<E: Element> Source<E> for Column<'_, E> {
    #[inline(always)]
    fn number(&self, place: usize) -> E {
        self.rows[place][self.triangle]
    }
}

impl<const WIDTH: usize> Layout for Aosoa<WIDTH> {
    const NAME: &'static str = "aosoa";
    const STEP: usize = WIDTH;
    fn position(triangle: usize, place: usize, places: usize, _: usize) -> usize {
        (triangle / WIDTH * places + place) * WIDTH + triangle % WIDTH
    }
    type Walk<'a, E: Element> = Blocks<'a, E, WIDTH>;
    #[inline(always)]
    fn walk<E: Element>(numbers: &[E], places: usize, count: usize) -> Blocks<'_, E, WIDTH> {
        Blocks { blocks: numbers.chunks_exact(places * WIDTH), block: &[], lane: 0, left: count }
    }
}

/// The walk of [`Aosoa`].
pub struct Blocks<'a, E, const WIDTH: usize> {
    blocks: std::slice::ChunksExact<'a, E>,
    block: &'a [E],
    lane: usize,
    left: usize,
}

/// One triangle of [`Blocks`].
pub struct InBlock<'a, E, const WIDTH: usize> {
    block: &'a [E],
    lane: usize,
}

impl<'a, E: Element, const WIDTH: usize> Iterator for Blocks<'a, E, WIDTH> {
    type Item = InBlock<'a, E, WIDTH>;
    #[inline(always)]
    fn next(&mut self) -> Option<InBlock<'a, E, WIDTH>> {
        if self.left == 0 {
            return None;
        }
        if self.lane == 0 {
            self.block = self.blocks.next()?;
        }
        let lane = self.lane;
        self.lane = (lane + 1) % WIDTH;
        self.left -= 1;
        Some(InBlock { block: self.block, lane })
    }
}

impl<E: Element, const WIDTH: usize> Source<E> for InBlock<'_, E, WIDTH> {
    #[inline(always)]
    fn number(&self, place: usize) -> E {
        self.block[place * WIDTH + self.lane % WIDTH]
    }
}

/// Writes records into `numbers`, filled up with records of NaN, which nothing hits. `numbers` is as
/// long as [`length`] says.
pub fn lay_out<E: Element, T: AsRef<[E]>, L: Layout>(records: &[T], numbers: &mut [E]) {
    numbers.fill((E::MAX + E::MAX) * E::ZERO);
    let count = records.len().next_multiple_of(L::STEP);
    for (triangle, record) in records.iter().enumerate() {
        let record = record.as_ref();
        for (place, number) in record.iter().enumerate() {
            numbers[L::position(triangle, place, record.len(), count)] = *number;
        }
    }
}

/// How many numbers [`lay_out`] writes.
pub fn length<E: Element, T: AsRef<[E]>, L: Layout>(records: &[T]) -> usize {
    let places = records.first().map_or(0, |record| record.as_ref().len());
    records.len().next_multiple_of(L::STEP) * places
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nine records of five numbers: triangle x 10 + place.
    fn records() -> Vec<[f32; 5]> {
        (0..9u8).map(|i| [0u8, 1, 2, 3, 4].map(|place| f32::from(i * 10 + place))).collect()
    }

    fn walked<L: Layout>() -> Vec<[f32; 5]> {
        let records = records();
        let mut numbers = vec![0.0; length::<f32, _, L>(&records)];
        lay_out::<f32, _, L>(&records, &mut numbers);
        let walk = L::walk(&numbers, 5, records.len());
        walk.map(|source| [0, 1, 2, 3, 4].map(|place| source.number(place))).collect()
    }

    #[test]
    fn every_layout_gives_every_number_back() {
        assert_eq!(walked::<Aos>(), records());
        assert_eq!(walked::<Soa>(), records());
        assert_eq!(walked::<Aosoa<4>>(), records());
        assert_eq!(walked::<Aosoa<8>>(), records());
    }

    #[test]
    fn numbers_lie_where_the_layout_says() {
        let records = records();
        let mut numbers = vec![0.0; length::<f32, _, Aosoa<4>>(&records)];
        lay_out::<f32, _, Aosoa<4>>(&records, &mut numbers);
        assert_eq!(numbers[..8], [0.0, 10.0, 20.0, 30.0, 1.0, 11.0, 21.0, 31.0]);
        assert!(numbers[numbers.len() - 1].is_nan());
        let mut numbers = vec![0.0; length::<f32, _, Soa>(&records)];
        lay_out::<f32, _, Soa>(&records, &mut numbers);
        assert_eq!(numbers[..3], [0.0, 10.0, 20.0]);
        assert_eq!(numbers[16..19], [1.0, 11.0, 21.0]);
        assert!(numbers[9].is_nan());
    }
}
