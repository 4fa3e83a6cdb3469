//! How a projecting kernel knows the axis along which a triangle is projected, and the two it keeps
//! (thesis H, 4.2).

use super::Source;
use crate::number::{Axis, Element, Real, Vec3, dominant};

/// Where the axis comes from.
pub trait Projection: 'static {
    /// The column `projection`.
    const NAME: &'static str;
    /// What is stored of a triangle: 12 numbers, and what this choice adds.
    type Record<E: Element>: AsRef<[E]> + Copy + 'static;
    /// The axis along which a triangle with this normal is projected.
    fn axis<E: Element>(n: Vec3<E>) -> u32;
    /// A record whose place 3 holds the axis.
    fn record<E: Element>(numbers: [E; 12]) -> Self::Record<E>;
    /// The axis, and the two behind it in the cycle.
    fn axes<T: Real, S: Source<T>>(stored: &S) -> [Axis<T::Mask>; 3];
}

/// One stored index; the two others follow from it.
pub struct OneIndex;
/// Three stored indices: two numbers more, and nothing to compute.
pub struct ThreeIndices;
/// One axis for all triangles of a scene, known when the test is compiled. Exact as the others are where
/// no triangle is perpendicular to the plane that is left; the closer one comes to that, the more
/// digits its weights lose.
pub struct Fixed<const AXIS: u32>;

impl Projection for OneIndex {
    const NAME: &'static str = "one-index";
    type Record<E: Element> = [E; 12];
    fn axis<E: Element>(n: Vec3<E>) -> u32 {
        dominant(n)
    }
    fn record<E: Element>(numbers: [E; 12]) -> [E; 12] {
        numbers
    }
    #[inline(always)]
    fn axes<T: Real, S: Source<T>>(stored: &S) -> [Axis<T::Mask>; 3] {
        behind(stored.axis(3))
    }
}

impl Projection for ThreeIndices {
    const NAME: &'static str = "three-indices";
    type Record<E: Element> = [E; 14];
    fn axis<E: Element>(n: Vec3<E>) -> u32 {
        dominant(n)
    }
    fn record<E: Element>([a, b, c, w, d, e, f, g, h, i, j, k]: [E; 12]) -> [E; 14] {
        let [u, v] = [1, 2].map(|step| E::from_index((w.index() + step) % 3));
        [a, b, c, w, d, e, f, g, h, i, j, k, u, v]
    }
    #[inline(always)]
    fn axes<T: Real, S: Source<T>>(stored: &S) -> [Axis<T::Mask>; 3] {
        [stored.axis(3), stored.axis(12), stored.axis(13)]
    }
}

impl<const AXIS: u32> Projection for Fixed<AXIS> {
    const NAME: &'static str = "fixed";
    type Record<E: Element> = [E; 12];
    fn axis<E: Element>(_: Vec3<E>) -> u32 {
        AXIS
    }
    fn record<E: Element>(numbers: [E; 12]) -> [E; 12] {
        numbers
    }
    #[inline(always)]
    fn axes<T: Real, S: Source<T>>(_: &S) -> [Axis<T::Mask>; 3] {
        behind(Axis::stored(AXIS))
    }
}

#[inline(always)]
fn behind<M: crate::number::Mask>(w: Axis<M>) -> [Axis<M>; 3] {
    [w, w.next(), w.next().next()]
}
