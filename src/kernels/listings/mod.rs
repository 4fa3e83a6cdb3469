//! Published code, reproduced with its branches and its return codes.
//!
//! A listing is a function over a scalar with native `if`; it is single, early and plain only, and
//! it tests no t: a hit means that the *line* meets the triangle. On [`Counted`](crate::number::Counted)
//! it gives thesis B's operation tables exactly.

mod badouel;
mod chirkov_line;
mod moller;
mod script;

pub use badouel::Badouel;
pub use chirkov_line::ChirkovLine;
pub use moller::{Moller, Placement};
pub use script::{Cost, Literally, Priced, Script};

use super::{About, Corners};
use crate::number::{Element, Vec3};
use crate::policy::Ray;

/// What a listing returns: its code (0 is a hit), t, u and v (0 where it does not compute them).
pub type Returned<E> = (u8, E, E, E);

/// A published listing. `UV` asks for barycentric coordinates as well (thesis B, 4.6).
pub trait Listing: 'static {
    /// What it is; `codes` are the return codes from 1 on.
    const ABOUT: About;
    /// What is stored of a triangle.
    type Record<E: Element>: Copy + 'static;
    /// Fills the record.
    fn prepare<E: Element>(corners: &Corners<E>) -> Self::Record<E>;
    /// The code, as printed.
    fn run<E: Element, S: Script, const UV: bool>(
        ray: &Ray<E>,
        tri: &Self::Record<E>,
    ) -> Returned<E>;
}

/// Thesis B's EPSILON, 0.000001, rounded to the precision.
fn epsilon<E: Element>() -> E {
    E::from_f32(1e-6)
}

/// Plane, axis and corners, as thesis B's TRIANGLE holds them (4.5, common definitions).
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Planar<E> {
    v0: Vec3<E>,
    v1: Vec3<E>,
    v2: Vec3<E>,
    normal: Vec3<E>,
    d: E,
    i0: u32,
    i1: u32,
    i2: u32,
}

impl<E: Element> Planar<E> {
    /// The plane of `corners`. Claims.md: the normal is a unit vector, which makes the test
    /// |N . D| < EPSILON one of an angle (published: 1 such pair in a million; with N of any length 6).
    fn of(corners: &Corners<E>) -> Self {
        let (e1, e2) = corners.edges();
        let n = super::stored::plain_cross(e1, e2);
        let normal = n.scaled(E::ONE / super::stored::plain_dot(n, n).sqrt());
        let [i0, i1, i2] =
            super::shevtsov::cycle(crate::number::dominant(normal)).map(|i| i as u32);
        Planar {
            v0: corners.a,
            v1: corners.b,
            v2: corners.c,
            normal,
            d: -super::stored::plain_dot(corners.a, normal),
            i0,
            i1,
            i2,
        }
    }

    /// The indices i1 and i2; the clamp costs less than a bounds check in a test that is timed.
    #[inline(always)]
    fn axes(&self) -> (usize, usize) {
        ((self.i1 as usize).min(2), (self.i2 as usize).min(2))
    }
}
