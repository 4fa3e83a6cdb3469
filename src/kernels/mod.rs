//! The kernels: one file per algorithm, each written once.
//!
//! A kernel has four stages. [`Kernel::prepare`] runs once per triangle and fills the stored
//! record. [`Kernel::aim`] runs once per ray or packet of rays. [`Kernel::read`] runs once per
//! triangle and packet, on scalars, and what it yields is put into every lane; or once per group of
//! triangles, of which each lane has one. [`Kernel::test`] runs per triangle and ray, packet of rays
//! or group of triangles; it has two parts, so that a loop can begin a test before it ends the one
//! before.

mod angle_sum;
mod badouel_cramer;
mod baldwin_weber;
mod begun;
mod chirkov;
mod edges;
mod embree_plucker;
mod half_spaces;
mod keidy;
mod kensler_shirley;
pub mod listings;
mod moller_trumbore;
mod moller_trumbore_in_f64;
mod perpendicular_planes;
mod plucker;
mod projection;
mod shares;
mod shevtsov;
mod signed_areas;
mod source;
mod stored;
mod triple;
mod wald;
mod woop_affine;
mod woop_watertight;

pub use angle_sum::AngleSum;
pub use badouel_cramer::BadouelCramer;
pub use baldwin_weber::{BaldwinWeber, Column, FromPositions, FromRows};
pub use begun::Begun;
pub use chirkov::Chirkov;
pub use edges::{Edges, ExactSign, Fallback, NoFallback};
pub use embree_plucker::EmbreePlucker;
pub use half_spaces::HalfSpaces;
pub use keidy::Keidy;
pub use kensler_shirley::KenslerShirley;
pub use moller_trumbore::MollerTrumbore;
pub use moller_trumbore_in_f64::MollerTrumboreInF64;
pub use perpendicular_planes::PerpendicularPlanes;
pub use plucker::Plucker;
pub use projection::{Fixed, OneIndex, Projection, ThreeIndices};
pub use shares::{Common, CommonOrigin, MOST_SHARED, Parallel, Shares};
pub use shevtsov::Shevtsov;
pub use signed_areas::SignedAreas;
pub use source::{Source, Whole};
pub use stored::{Precomputed, Stored, Vertices, WithNormal};
pub use triple::{Triple, WithDirection, WithEdges};
pub use wald::Wald;
pub use woop_affine::WoopAffine;
pub use woop_watertight::WoopWatertight;

use crate::number::{Element, Real, Spread, Vec3, spread};
use crate::policy::{Found, Miss, Policy, Ray};

/// The corners of a triangle: u is the weight of `b`, v of `c`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners<R> {
    /// Vertex a.
    pub a: Vec3<R>,
    /// Vertex b.
    pub b: Vec3<R>,
    /// Vertex c.
    pub c: Vec3<R>,
}

impl<R: Real> Corners<R> {
    /// The edges b - a and c - a.
    #[inline(always)]
    pub fn edges(&self) -> (Vec3<R>, Vec3<R>) {
        (self.b - self.a, self.c - self.a)
    }
    /// As they are stored in nine places, from `place` on.
    #[inline(always)]
    pub fn read<S: Source<R>>(stored: &S, place: usize) -> Self {
        Corners {
            a: stored.vector(place),
            b: stored.vector(place + 3),
            c: stored.vector(place + 6),
        }
    }
}

impl<E: Element> Corners<E> {
    /// What [`Corners::read`] reads.
    pub fn numbers(&self) -> [E; 9] {
        let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (self.a.0, self.b.0, self.c.0);
        [ax, ay, az, bx, by, bz, cx, cy, cz]
    }
}

spread!(Corners { a, b, c });

/// What a reader should know of a kernel before its code.
#[derive(Clone, Copy, Debug)]
pub struct About {
    /// The id: the name in lower case with hyphens.
    pub id: &'static str,
    /// The name as its authors write it.
    pub name: &'static str,
    /// Year of publication (of the folklore ones: of the thesis that describes them).
    pub year: u16,
    /// Paper and section of the formula.
    pub source: &'static str,
    /// What is prepared per triangle, in words.
    pub setup: &'static str,
    /// The column `stored`: what the record holds.
    pub stored: &'static str,
    /// Whether rays through shared edges and vertices are never lost.
    pub watertight: bool,
    /// Meaning of the return codes from 1 on.
    pub codes: &'static [&'static str],
}

/// A ray-triangle test, written over a number and a policy.
pub trait Kernel: 'static {
    /// What it is.
    const ABOUT: About;
    /// What is stored of one triangle: an array of numbers.
    type Record<E: Element>: AsRef<[E]> + Copy + 'static;
    /// The record as the test needs it, with what follows from the triangle alone.
    type Met<R: Real>: Spread<R, One = Self::Met<R::Element>>;
    /// What is prepared of a ray, or of a packet of rays; `()` for nothing.
    type Aim<R: Real>: Copy;

    /// The record of a triangle; any triangle, degenerate ones too.
    fn prepare<E: Element>(corners: &Corners<E>) -> Self::Record<E>;
    /// What is done once per triangle, before any ray is known: on one triangle, or on one per lane.
    fn read<P: Policy, T: Real, S: Source<T>>(stored: &S) -> Self::Met<T>;
    /// [`Kernel::read`] of one triangle, put into every lane.
    #[inline(always)]
    fn meet<P: Policy, R: Real>(
        token: R::Token,
        record: &Self::Record<R::Element>,
    ) -> Self::Met<R> {
        let met = Self::read::<P, R::Element, _>(&Whole(record.as_ref()));
        Spread::spread(token, met)
    }
    /// What is done once per ray or packet. It must not read `t_max`, which shrinks from hit to hit.
    fn aim<P: Policy, R: Real>(ray: &Ray<R>) -> Self::Aim<R>;
    /// What the first part of a test leaves to the second; `()` where a test is in one piece.
    type Begun<R: Real>: Copy;
    /// The test up to its division, or its determinant. In `full` forms it must not read `t_max`: it is
    /// done before the test of the triangle before this one ends, see [`Begun`].
    ///
    /// # Errors
    /// As [`Kernel::test`].
    fn begin<P: Policy, R: Real>(
        ray: &Ray<R>,
        aim: &Self::Aim<R>,
        met: &Self::Met<R>,
    ) -> Result<Self::Begun<R>, Miss>;
    /// The rest of the test.
    ///
    /// # Errors
    /// As [`Kernel::test`].
    fn end<P: Policy, R: Real>(
        ray: &Ray<R>,
        aim: &Self::Aim<R>,
        met: &Self::Met<R>,
        begun: &Self::Begun<R>,
    ) -> Result<Found<R>, Miss>;
    /// The test.
    ///
    /// # Errors
    /// [`Miss`] with the exit's code, in `early` forms, when no lane can hit any more.
    #[inline(always)]
    fn test<P: Policy, R: Real>(
        ray: &Ray<R>,
        aim: &Self::Aim<R>,
        met: &Self::Met<R>,
    ) -> Result<Found<R>, Miss> {
        let begun = Self::begin::<P, R>(ray, aim, met)?;
        Self::end::<P, R>(ray, aim, met, &begun)
    }
    /// A normal of the triangle, of any length, on the side from which a, b, c is counter-clockwise.
    fn normal<P: Policy, R: Real>(met: &Self::Met<R>) -> Vec3<R>;
}

/// A kernel that can say whether a point of the triangle's plane lies in the triangle.
pub trait PointTest: Kernel {
    /// The weights of b and c, and where the point is inside.
    ///
    /// # Errors
    /// [`Miss`] as [`Kernel::test`].
    fn contains<P: Policy, R: Real>(
        point: &Vec3<R>,
        met: &Self::Met<R>,
    ) -> Result<(R::Mask, R, R), Miss>;
}
