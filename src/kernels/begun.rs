//! A test between its two parts.

use crate::number::Real;
use crate::policy::{Exit, Found, Miss, Policy, Ray, Scale};

/// What most tests know after the first part: a loop that computes everything begins the test of the
/// next triangle before it ends the test of this one. A processor looks some hundred instructions
/// ahead, but what waits for a division fills its queues; this way the division is done when it is
/// asked for.
#[derive(Clone, Copy)]
pub struct Begun<R: Real> {
    /// Where the triangle can still be hit.
    pub hit: R::Mask,
    /// The numerator of t; of kernels that compute it later, the determinant.
    pub t: R,
    /// Its scale.
    pub scale: Scale<R>,
    /// What late division multiplies by, where that division was begun or is known.
    inverse: Option<R>,
}

impl<R: Real> Begun<R> {
    /// In `full` forms a division that comes last is begun, too.
    #[inline(always)]
    pub fn new<P: Policy>(hit: R::Mask, t: R, scale: Scale<R>) -> Self {
        let inverse = if P::Exit::DEFERS_RANGE { Some(P::inverse(scale)) } else { None };
        Begun { hit, t, scale, inverse }
    }
    /// With the inverse of the scale, where it is known.
    #[inline(always)]
    pub fn knowing<P: Policy>(hit: R::Mask, t: R, scale: Scale<R>, inverse: Option<R>) -> Self {
        match inverse {
            Some(_) => Begun { hit, t, scale, inverse },
            None => Begun::new::<P>(hit, t, scale),
        }
    }
    /// Of a determinant that divides everything, t too, which comes later: in its place stands the
    /// determinant. `divided` is what [`Policy::divided`] gave, where that is known.
    #[inline(always)]
    pub fn dividing<P: Policy>(hit: R::Mask, det: R, divided: Option<R>) -> Self {
        match divided {
            Some(divided) => {
                let (scale, inverse) = P::divided_by(det, divided);
                Begun { hit, t: det, scale, inverse: Some(inverse) }
            }
            None => Begun::new::<P>(hit, det, P::divide(det)),
        }
    }
    /// [`Policy::keep`], the division being begun.
    ///
    /// # Errors
    /// As that.
    #[inline(always)]
    pub fn keep<P: Policy>(self, code: u8) -> Result<Self, Miss> {
        Ok(Begun { hit: P::keep(self.hit, code)?, ..self })
    }
    /// [`Policy::finish`], by the division that was begun, if it was.
    #[inline(always)]
    pub fn finish<P: Policy>(
        &self,
        hit: R::Mask,
        ray: &Ray<R>,
        numerators: [R; 3],
    ) -> Result<Found<R>, Miss> {
        let hit = P::settle(hit, ray, numerators[0], self.scale)?;
        let inverse = match self.inverse {
            Some(inverse) => inverse,
            None => P::inverse(self.scale),
        };
        Ok(P::finish_by(hit, ray, numerators, inverse))
    }
}

/// The first part of a test that is in one piece.
macro_rules! in_one_piece {
    () => {
        type Begun<R: crate::number::Real> = ();

        #[inline(always)]
        fn begin<P: crate::policy::Policy, R: crate::number::Real>(
            _: &crate::policy::Ray<R>,
            _: &Self::Aim<R>,
            _: &Self::Met<R>,
        ) -> Result<(), crate::policy::Miss> {
            Ok(())
        }
    };
}

pub(super) use in_one_piece;
