//! Where the numbers stored of a triangle are read from.

use crate::number::{Axis, Real, Vec3};

/// The numbers stored of one triangle (`T` is a scalar), or of one triangle per lane. Which place
/// holds what is the kernel's; how far apart two places lie is the memory layout's.
pub trait Source<T: Real> {
    /// The number at a place, below the number of numbers in the kernel's record.
    fn number(&self, place: usize) -> T;
    /// The numbers at three places in a row.
    #[inline(always)]
    fn vector(&self, place: usize) -> Vec3<T> {
        Vec3([self.number(place), self.number(place + 1), self.number(place + 2)])
    }
    /// The numbers at two places in a row.
    #[inline(always)]
    fn pair(&self, place: usize) -> [T; 2] {
        [self.number(place), self.number(place + 1)]
    }
    /// The axis whose index is stored at a place.
    #[inline(always)]
    fn axis(&self, place: usize) -> Axis<T::Mask> {
        Axis::of_index(self.number(place))
    }
}

/// One record, number behind number: the layout `aos`.
pub struct Whole<'a, E>(pub &'a [E]);

impl<E: Real> Source<E> for Whole<'_, E> {
    #[inline(always)]
    fn number(&self, place: usize) -> E {
        self.0[place]
    }
}
