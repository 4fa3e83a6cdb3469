//! What rays with a common origin, or a common direction, share of a test (thesis H, 4.2).

use super::{Kernel, Source};
use crate::number::Real;
use crate::policy::{Found, Miss, Policy, Ray};

/// What the rays of a packet have in common.
pub trait Common: 'static {
    /// What follows the number of rays in the column `drive`.
    const NAME: &'static str;
}

/// The origin: rays of a camera, or of a shadow as seen from its light.
pub struct CommonOrigin;
/// The direction: rays of a distant light, or of an orthographic camera.
pub struct Parallel;

impl Common for CommonOrigin {
    const NAME: &'static str = "common-origin";
}

impl Common for Parallel {
    const NAME: &'static str = "parallel";
}

/// Numbers of the largest [`Shares::Shared`].
pub const MOST_SHARED: usize = 16;

/// A kernel that does part of its test once per triangle and packet, where rays have something in
/// common. The parts are those of [`Kernel::test`], in the same operations: the answers are the same
/// bits.
pub trait Shares<C: Common>: Kernel {
    /// All that the rest of the test needs of a triangle: an array of at most [`MOST_SHARED`] numbers.
    type Shared<R: Real>: AsRef<[R]> + Copy;
    /// What is shared, of one triangle or of one per lane. Of `ray`, only what is common may be read.
    fn share<P: Policy, R: Real>(ray: &Ray<R>, met: &Self::Met<R>) -> Self::Shared<R>;
    /// What the first part of what is left gives to the second; `()` where it is in one piece.
    type Begun<R: Real>: Copy;
    /// What is left of [`Kernel::test`] up to its division, or its determinant.
    ///
    /// # Errors
    /// As [`Kernel::test`].
    fn begin_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        aim: &Self::Aim<R>,
        shared: &S,
    ) -> Result<<Self as Shares<C>>::Begun<R>, Miss>;
    /// The rest of it.
    ///
    /// # Errors
    /// As [`Kernel::test`].
    fn end_shared<P: Policy, R: Real, S: Source<R>>(
        ray: &Ray<R>,
        aim: &Self::Aim<R>,
        shared: &S,
        begun: &<Self as Shares<C>>::Begun<R>,
    ) -> Result<Found<R>, Miss>;
}

/// `known!(part.value, other)`, or `known!(known.part.value, other)` of a [`Known`]: the value of that
/// name, if that part of a test is known, else the other; `known!(part.value)`: that value or `None`. Which
/// one is decided when a form is compiled. No closures: one that is not inlined is compiled without the
/// instructions of its level.
macro_rules! known {
    ($known:ident.$part:ident.$value:ident, $otherwise:expr) => {
        match $known.$part {
            Some(part) => part.$value,
            None => $otherwise,
        }
    };
    ($part:ident.$value:ident, $otherwise:expr) => {
        match $part {
            Some(part) => part.$value,
            None => $otherwise,
        }
    };
    ($part:ident.$value:ident) => {
        match $part {
            Some(part) => Some(part.$value),
            None => None,
        }
    };
}

/// [`Shares::begin_shared`] of a test that is in one piece.
macro_rules! shared_in_one_piece {
    () => {
        type Begun<R: Real> = ();

        #[inline(always)]
        fn begin_shared<P: Policy, R: Real, T: Source<R>>(
            _: &Ray<R>,
            _: &Self::Aim<R>,
            _: &T,
        ) -> Result<(), Miss> {
            Ok(())
        }
    };
}

/// What is known before a test: `O` of a common origin, `D` of a common direction.
#[derive(Clone, Copy)]
pub struct Known<O, D> {
    /// What follows from the origin.
    pub origin: Option<O>,
    /// What follows from the direction.
    pub direction: Option<D>,
}

impl<O, D> Known<O, D> {
    /// Nothing: a general packet, or a single ray.
    pub const NOTHING: Self = Known { origin: None, direction: None };
}

pub(super) use {known, shared_in_one_piece};
