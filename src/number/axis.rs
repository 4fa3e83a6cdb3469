//! The axis along which a triangle is projected, and the two that are kept.

use super::{Element, Mask, Real, Vec3};

/// Which component of a vector a projecting kernel drops.
///
/// `Uniform`: one triangle, so one axis for every lane. `Lanes`: one axis per lane (groups of
/// triangles, frames per ray), as two masks.
#[derive(Clone, Copy)]
pub enum Axis<M> {
    /// 0, 1 or 2 in every lane.
    Uniform(usize),
    /// Where the axis is 0, and where it is 1; elsewhere it is 2.
    Lanes(M, M),
}

impl<M: Mask> Axis<M> {
    /// The axis whose index was stored as a number ([`Element::from_index`]), per lane.
    #[inline(always)]
    pub fn of_index<R: Real<Mask = M>>(index: R) -> Self {
        if R::LANES == 1 {
            let mut place = [R::Element::ZERO];
            index.store(&mut place);
            Axis::stored(place[0].index())
        } else {
            let (x, y) = (R::Element::from_index(0), R::Element::from_index(1));
            Axis::Lanes(!index.ne(index.like(x)), !index.ne(index.like(y)))
        }
    }

    /// A stored axis. Values above 2 cannot be stored by us; the clamp tells the optimiser so.
    #[inline(always)]
    pub fn stored(axis: u32) -> Self {
        Axis::Uniform((axis as usize).min(2))
    }

    /// The axis of the largest magnitude of `v`: the earlier one on a tie, as [`dominant`]; the last
    /// where there are NaN. One for all where there is one lane, and without a jump.
    #[inline(always)]
    pub fn largest<R: Real<Mask = M>>(v: &Vec3<R>) -> Self {
        let [x, y, z] = [v.x().signed_by(v.x()), v.y().signed_by(v.y()), v.z().signed_by(v.z())];
        let is_x = x.ge(y) & x.ge(z);
        let is_y = !is_x & y.ge(z);
        if R::LANES == 1 {
            let axis = 2 - 2 * u32::from(is_x.lane(0)) - u32::from(is_y.lane(0));
            Axis::stored(axis)
        } else {
            Axis::Lanes(is_x, is_y)
        }
    }

    /// The next axis in the cycle x, y, z, x.
    #[inline(always)]
    pub fn next(self) -> Self {
        match self {
            Axis::Uniform(axis) => Axis::Uniform(if axis >= 2 { 0 } else { axis + 1 }),
            Axis::Lanes(is_x, is_y) => Axis::Lanes(!(is_x | is_y), is_x),
        }
    }

    /// The component of `v` along this axis.
    #[inline(always)]
    pub fn pick<R: Real<Mask = M>>(self, v: &Vec3<R>) -> R {
        match self {
            Axis::Uniform(axis) => v.0[axis],
            Axis::Lanes(is_x, is_y) => R::select(is_x, v.0[0], R::select(is_y, v.0[1], v.0[2])),
        }
    }
}

/// The axis of the component of largest magnitude; the earlier one on a tie (thesis B, 3.15).
pub fn dominant<E: Element>(v: Vec3<E>) -> u32 {
    let [x, y, z] = [v.x().signed_by(v.x()), v.y().signed_by(v.y()), v.z().signed_by(v.z())];
    if x.ge(y) & x.ge(z) {
        0
    } else if y.ge(z) {
        1
    } else {
        2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniform_and_lane_axes_pick_the_same_component() {
        let v = Vec3([1.0f32, 2.0, 3.0]);
        for axis in 0..3usize {
            let uniform = Axis::<bool>::Uniform(axis);
            let lanes = Axis::Lanes(axis == 0, axis == 1);
            for (a, b) in [
                (uniform, lanes),
                (uniform.next(), lanes.next()),
                (uniform.next().next(), lanes.next().next()),
            ] {
                assert_eq!(a.pick(&v), b.pick(&v));
            }
            assert_eq!(uniform.next().pick(&v), v.0[(axis + 1) % 3]);
        }
    }

    #[test]
    fn dominant_axis_is_the_largest_magnitude_and_the_first_on_ties() {
        assert_eq!(dominant(Vec3([1.0f32, -3.0, 2.0])), 1);
        assert_eq!(dominant(Vec3([-4.0f32, 3.0, 2.0])), 0);
        assert_eq!(dominant(Vec3([0.0f32, 0.5, -2.0])), 2);
        assert_eq!(dominant(Vec3([1.0f32, 1.0, 1.0])), 0);
        assert_eq!(dominant(Vec3([0.0f32, -2.0, 2.0])), 1);
    }

    #[test]
    fn largest_axis_of_one_lane_is_the_dominant_one() {
        let numbers = [0.0f32, -1.0, 2.0, -2.0, f32::NAN];
        for x in numbers {
            for y in numbers {
                for z in numbers {
                    let v = Vec3([x, y, z]);
                    let places = Vec3([0.0f32, 1.0, 2.0]);
                    assert_eq!(Axis::largest(&v).pick(&places), dominant(v) as f32, "{v:?}");
                }
            }
        }
    }
}
