//! A ray as the boxes of a wide tree see it.

use super::tree::{Node, Wide};
use crate::number::{Extremes, Vec3};
use crate::policy::{Policy, Ray};
use crate::structure::Beam;

/// Origins that are farther away, in parts of the scene, are walked in f64.
const FARTHEST: f32 = 64.0;
/// Sizes of scenes and directions between this and its inverse are walked in f32.
const LEAST: f32 = 1.0 / (1u64 << 20) as f32;
/// Where inverses of directions are cut off, in parts of 1 / size of the scene.
const STEEPEST: f32 = (1u128 << 100) as f32;

/// A ray in f32.
#[derive(Clone, Copy)]
pub struct Pose<R> {
    inverse: Vec3<R>,
    shift: Vec3<R>,
    t_min: R,
    /// Of each axis, which plane is met first: 0 or 1.
    first: [usize; 3],
}

/// Whether the ray can be walked in f32.
pub fn is_plain<const W: usize>(tree: &Wide<W>, ray: &Ray<f32>) -> bool {
    let largest = |v: Vec3<f32>| v.x().abs().max(v.y().abs()).max(v.z().abs());
    let is_usual = |size: f32| (LEAST..=1.0 / LEAST).contains(&size);
    let origin = ray.origin - Vec3(tree.middle);
    // NaN in one component is not seen by a maximum.
    let is_number = !(origin.x() + origin.y() + origin.z()).is_nan()
        && !(ray.direction.x() + ray.direction.y() + ray.direction.z()).is_nan();
    is_number
        && is_usual(tree.reach)
        && is_usual(largest(ray.direction))
        && largest(origin) <= FARTHEST * tree.reach
}

impl<R: Extremes<Element = f32>> Pose<R> {
    /// Of a ray for which [`is_plain`].
    #[inline(always)]
    pub fn new<const W: usize>(token: R::Token, tree: &Wide<W>, ray: &Ray<f32>) -> Self {
        let steepest = STEEPEST / tree.reach;
        let (mut inverse, mut shift, mut first) = ([0.0; 3], [0.0; 3], [0; 3]);
        for axis in 0..3 {
            inverse[axis] = (1.0 / ray.direction.0[axis]).clamp(-steepest, steepest);
            shift[axis] = -((ray.origin.0[axis] - tree.middle[axis]) * inverse[axis]);
            first[axis] = usize::from(ray.direction.0[axis].is_sign_negative());
        }
        Pose {
            inverse: Vec3::splat(token, Vec3(inverse)),
            shift: Vec3::splat(token, Vec3(shift)),
            t_min: R::splat(token, ray.t_min),
            first,
        }
    }

    /// Where each child is entered, and a bit for each that is met not beyond `limit`.
    #[inline(always)]
    pub fn meet<P: Policy, const W: usize>(
        &self,
        token: R::Token,
        node: &Node<W>,
        limit: R,
    ) -> (R, u64) {
        let at = |axis: usize, side: usize| {
            let plane = R::load(token, &node.planes[2 * axis + side]);
            P::multiply_add(plane, self.inverse.0[axis], self.shift.0[axis])
        };
        let [x, y, z] = self.first;
        let near = at(0, x).larger(at(1, y)).larger(at(2, z).larger(self.t_min));
        let far = at(0, 1 - x).smaller(at(1, 1 - y)).smaller(at(2, 1 - z).smaller(limit));
        (near, R::bits(near.le(far)))
    }
}

/// The same in f64, for any ray.
pub fn meet_in_f64<const W: usize>(beam: &Beam, node: &Node<W>, limit: f64) -> ([f32; W], u64) {
    use crate::structure::volume::{Bounds, Volume};

    let (mut near, mut bits) = ([0.0; W], 0);
    for (place, near) in near.iter_mut().enumerate() {
        let plane = |row: usize| node.planes[row][place];
        let bounds =
            Bounds { low: [plane(0), plane(2), plane(4)], high: [plane(1), plane(3), plane(5)] };
        if bounds.low[0] <= bounds.high[0]
            && let Some(enters) = bounds.hit(beam, &(), limit)
        {
            // Rounded down, so that it is not beyond.
            *near = (enters as f32).next_down();
            bits |= 1 << place;
        }
    }
    (near, bits)
}
