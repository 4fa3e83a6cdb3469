//! What a loop over rays and triangles reads and writes, in one piece of memory.

use super::aligned::Aligned;
use super::best::ANSWER_NUMBERS;
use crate::number::Element;

/// Bytes of a cache line.
const LINE: usize = 64;

/// Rays, answers and records, one behind the other, each from the start of a cache line on. If each had a
/// page of its own, all three would begin at the same place within one, and a small set would share
/// the few lines of a cache that are meant for that place, while the rest of it is empty.
pub struct NearestData<E> {
    memory: Aligned<E>,
    rays: usize,
    answers: [usize; 2],
    records: usize,
}

/// The three of them.
pub struct Parts<'a, E> {
    /// Numbers of the rays.
    pub rays: &'a mut [E],
    /// [`ANSWER_NUMBERS`] for each ray.
    pub answers: &'a mut [E],
    /// Numbers of the records.
    pub records: &'a mut [E],
}

impl<E: Element> NearestData<E> {
    /// Zeros: room for the `numbers` of so many `rays`, their answers, and records of `records` numbers.
    pub fn new(numbers: usize, rays: usize, records: usize) -> Self {
        let line = LINE / size_of::<E>();
        let first = numbers.next_multiple_of(line);
        let last = first + rays * ANSWER_NUMBERS;
        let behind = last.next_multiple_of(line);
        let memory = Aligned::filled(E::ZERO, behind + records);
        NearestData { memory, rays: numbers, answers: [first, last], records: behind }
    }

    /// All three, to be read and written.
    pub fn parts(&mut self) -> Parts<'_, E> {
        let [first, last] = self.answers;
        let (before, records) = self.memory.split_at_mut(self.records);
        let (rays, answers) = before.split_at_mut(first);
        Parts { rays: &mut rays[..self.rays], answers: &mut answers[..last - first], records }
    }

    /// As [`Aligned::relocate`].
    pub fn relocate(&mut self) {
        self.memory.relocate();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_parts_that_begin_at_cache_lines_and_move_together() {
        let mut data = NearestData::<f32>::new(9, 2, 7);
        data.parts().rays.fill(1.0);
        data.parts().answers.fill(2.0);
        data.parts().records.fill(3.0);
        for _ in 0..3 {
            data.relocate();
            let Parts { rays, answers, records } = data.parts();
            assert_eq!(rays, [1.0; 9]);
            assert_eq!(answers, [2.0; 2 * ANSWER_NUMBERS]);
            assert_eq!(records, [3.0; 7]);
            for part in [rays.as_ptr(), answers.as_ptr(), records.as_ptr()] {
                assert_eq!(part.addr() % LINE, 0);
            }
        }
    }
}
