//! Data that begins at a page, wherever the system puts the memory.

use std::ops::{Deref, DerefMut};

/// Bytes of a page: a processor that looks for a store before a load compares the places of both within
/// one, and data share a place in its first cache if they share one there.
const PAGE: usize = 4096;

/// Places that items can be at: odd, so that with a power of two of windows each window comes to all of
/// them, and so that there is a median one.
const PLACES: usize = 7;

/// The most bytes that are moved: sixteen pages. A choice; it was not varied.
const MOST_MOVED: usize = 64 << 10;

/// Numbers, pairs or records in a row of which the first lies at the start of a page, or as near behind
/// one as their size allows. Without it, what lies where is drawn anew with every process: which of them
/// straddle two cache lines, by which a listing was 4 % faster in one process than in the next, and
/// which loads look as if they waited for a store, by which packets were.
#[derive(Debug)]
pub struct Aligned<T> {
    memory: Vec<T>,
    first: usize,
    count: usize,
    /// Items from one place to the next.
    stride: usize,
    /// The first of the places, and how many there are.
    start: usize,
    places: usize,
}

impl<T: Copy> Aligned<T> {
    /// A copy of `items` at the start of a page.
    pub fn new(items: &[T]) -> Self {
        let Some(filler) = items.first() else { return Aligned::empty() };
        let mut aligned = Aligned::filled(*filler, items.len());
        aligned.copy_from_slice(items);
        aligned
    }

    fn empty() -> Self {
        Aligned { memory: Vec::new(), first: 0, count: 0, stride: 1, start: 0, places: 1 }
    }

    /// So many times `filler`, the first at the start of a page.
    pub fn filled(filler: T, count: usize) -> Self {
        Self::with_places(filler, count, 1)
    }

    fn with_places(filler: T, count: usize, places: usize) -> Self {
        // After so many items every place that can be reached was: they are as far apart as their size.
        let shared = 1 << size_of::<T>().trailing_zeros().min(PAGE.trailing_zeros());
        let stride = PAGE / shared;
        let moved = stride * (places - 1);
        let mut memory = vec![filler; count + stride + moved];
        let behind = |start: &usize| memory[*start..].as_ptr().addr() % PAGE;
        let start = (0..stride).min_by_key(behind).unwrap_or(0);
        memory.truncate(start + count + moved);
        Aligned { memory, first: start, count, stride, start, places }
    }

    /// Moves the items to the next of a few places, each at the start of a page as well; afterwards they
    /// are in the first-level cache, as far as they fit. Sets of more than 64 KiB stay where they are.
    pub fn relocate(&mut self) {
        let Some(filler) = self.first().copied() else { return };
        if size_of_val(&**self) > MOST_MOVED {
            return;
        }
        if self.places == 1 {
            let mut wide = Self::with_places(filler, self.count, PLACES);
            wide.copy_from_slice(self);
            *self = wide;
        }
        let from = self.first;
        let last = self.start + self.stride * (self.places - 1);
        self.first = if from == last { self.start } else { from + self.stride };
        self.memory.copy_within(from..from + self.count, self.first);
    }
}

impl<T> Deref for Aligned<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.memory[self.first..self.first + self.count]
    }
}

impl<T> DerefMut for Aligned<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.memory[self.first..self.first + self.count]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn begins_at_a_page_and_keeps_what_it_was_given() {
        let numbers: Vec<f32> = (0..1000u16).map(f32::from).collect();
        let aligned = Aligned::new(&numbers);
        assert_eq!(aligned.as_ptr().addr() % PAGE, 0);
        assert_eq!(*aligned, *numbers);
        // 108 bytes, a multiple of four like the place that any memory begins at.
        let pairs = vec![[1.0f32; 27]; 300];
        assert_eq!(Aligned::new(&pairs).as_ptr().addr() % PAGE, 0);
        assert!(Aligned::<u8>::new(&[]).is_empty());
    }

    #[test]
    fn can_be_written() {
        let mut aligned = Aligned::new(&[1, 2, 3]);
        aligned[1] = 9;
        assert_eq!(*aligned, [1, 9, 3]);
    }

    #[test]
    fn moves_from_page_to_page_and_back() {
        let pairs: Vec<[f32; 27]> = (0..300u16).map(|i| [f32::from(i); 27]).collect();
        let mut aligned = Aligned::new(&pairs);
        let mut seen: Vec<usize> = Vec::new();
        for _ in 0..2 * PLACES {
            aligned.relocate();
            assert_eq!(*aligned, *pairs);
            assert_eq!(aligned.as_ptr().addr() % PAGE, 0);
            seen.push(aligned.as_ptr().addr());
        }
        assert_eq!(seen[..PLACES], seen[PLACES..]);
        seen.sort_unstable();
        seen.dedup();
        assert_eq!(seen.len(), PLACES);
    }

    #[test]
    fn large_or_empty_stays() {
        let mut large = Aligned::filled(1u8, MOST_MOVED + 1);
        let before = large.as_ptr();
        large.relocate();
        assert_eq!(large.as_ptr(), before);
        let mut none = Aligned::<u8>::new(&[]);
        none.relocate();
        assert!(none.is_empty());
    }
}
