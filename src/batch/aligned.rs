//! Data that begins at a cache line, wherever the system puts the memory.

use std::ops::{Deref, DerefMut};

/// Bytes of a cache line.
const LINE: usize = 64;

/// Numbers, pairs or records in a row of which the first lies at the start of a cache line, or as
/// near behind one as their size allows. Without it, which of them straddle two lines is drawn anew
/// with every process: a listing was 4 % faster in one process than in the next.
#[derive(Clone, Debug)]
pub struct Aligned<T> {
    memory: Vec<T>,
    first: usize,
}

impl<T: Copy> Aligned<T> {
    /// A copy of `items` at the start of a line.
    pub fn new(items: &[T]) -> Self {
        let Some(filler) = items.first() else { return Aligned { memory: Vec::new(), first: 0 } };
        let mut aligned = Aligned::filled(*filler, items.len());
        aligned.copy_from_slice(items);
        aligned
    }

    /// So many times `filler`, the first at the start of a line.
    pub fn filled(filler: T, count: usize) -> Self {
        // After as many items as a line has bytes, every place that can be reached was.
        let mut memory = vec![filler; count + LINE];
        let behind = |first: &usize| memory[*first..].as_ptr().addr() % LINE;
        let first = (0..LINE).min_by_key(behind).unwrap_or(0);
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
    fn begins_at_a_line_and_keeps_what_it_was_given() {
        let numbers: Vec<f32> = (0..1000u16).map(f32::from).collect();
        let aligned = Aligned::new(&numbers);
        assert_eq!(aligned.as_ptr().addr() % LINE, 0);
        assert_eq!(*aligned, *numbers);
        // 108 bytes, a multiple of four like the place that any memory begins at.
        let pairs = vec![[1.0f32; 27]; 300];
        assert_eq!(Aligned::new(&pairs).as_ptr().addr() % LINE, 0);
        assert!(Aligned::<u8>::new(&[]).is_empty());
    }

    #[test]
    fn can_be_written() {
        let mut aligned = Aligned::new(&[1, 2, 3]);
        aligned[1] = 9;
        assert_eq!(*aligned, [1, 9, 3]);
    }
}
