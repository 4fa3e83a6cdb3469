//! Data that begins at a page, wherever the system puts the memory.

use std::ops::{Deref, DerefMut};

/// Bytes of a page: a processor that looks for a store before a load compares the places of both within
/// one, and data share a place in its first cache if they share one there.
const PAGE: usize = 4096;

/// Numbers, pairs or records in a row of which the first lies at the start of a page, or as near behind
/// one as their size allows. Without it, what lies where is drawn anew with every process: which of them
/// straddle two cache lines, by which a listing was 4 % faster in one process than in the next, and
/// which loads look as if they waited for a store, by which packets were.
#[derive(Clone, Debug)]
pub struct Aligned<T> {
    memory: Vec<T>,
    first: usize,
}

impl<T: Copy> Aligned<T> {
    /// A copy of `items` at the start of a page.
    pub fn new(items: &[T]) -> Self {
        let Some(filler) = items.first() else { return Aligned { memory: Vec::new(), first: 0 } };
        let mut aligned = Aligned::filled(*filler, items.len());
        aligned.copy_from_slice(items);
        aligned
    }

    /// So many times `filler`, the first at the start of a page.
    pub fn filled(filler: T, count: usize) -> Self {
        // After so many items every place that can be reached was: they are as far apart as their size.
        let shared = 1 << size_of::<T>().trailing_zeros().min(PAGE.trailing_zeros());
        let places = PAGE / shared;
        let mut memory = vec![filler; count + places];
        let behind = |first: &usize| memory[*first..].as_ptr().addr() % PAGE;
        let first = (0..places).min_by_key(behind).unwrap_or(0);
        memory.truncate(first + count);
        Aligned { memory, first }
    }
}

impl<T> Deref for Aligned<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.memory[self.first..]
    }
}

impl<T> DerefMut for Aligned<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.memory[self.first..]
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
}
