//! Every variant that is built: its axes, its id, and how to bind it to a workload.

mod arithmetic;
mod asked;
mod axes;
mod busy;
mod calling;
mod drives;
mod every;
mod exit_code;
mod forms;
#[cfg(feature = "cli")]
mod leaves;
mod listings;
mod offers;
mod packets;
#[cfg(feature = "peers")]
mod peers;
mod points;
mod projections;
mod registers;
mod sharing;
mod streams;
mod techniques;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod variations;
mod vectors;
#[cfg(feature = "cli")]
mod wide;

pub use arithmetic::{Unit, units};
pub use asked::{Asked, asked, asked_with_peers};
pub(crate) use asked::{answer, posed};
pub use axes::{Axes, COLUMNS};
pub use busy::busy_kernel;
pub use every::{KernelVisitor, ListingVisitor, visit_kernels, visit_listings};
#[cfg(feature = "cli")]
pub use leaves::{LeafForm, leaves};
pub use offers::{Offers, Other};
pub use streams::{OneStream, streams};
#[cfg(feature = "cli")]
pub use wide::{SearchBinder, WideForm, wide_forms};

use std::sync::LazyLock;

use crate::batch::{
    Extent, NearestJob, NearestLoop, PairsJob, PrepareJob, Shape, Storing, TilesJob, prepare_all,
    widened,
};
use crate::bound::Work;
use crate::job::Job;
use crate::kernels::{About, Corners, Kernel};
use crate::number::{Element, Vec3};
use crate::policy::Ray;
use crate::workload;

/// The library is built a second time for its own tests, which need a form of each kind; those in
/// `tests` are built with all forms, and hold every one of them to the laws. Two thirds of a build saved. Nor do
/// parsers, which are fuzzed, care for forms.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
const EVERY_FORM: bool = cfg!(not(any(test, fuzzing)));
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
const EVERY_FORM: bool = true;

/// Makes a job of a variant over rays and triangles.
pub type Binder =
    Box<dyn Fn(&[workload::Ray], &[workload::Triangle]) -> Box<dyn Job> + Send + Sync>;

/// Makes a job of preparing triangles.
pub type PrepareBinder = fn(&[workload::Triangle]) -> Box<dyn Job>;

/// Makes a job of a variant over rays and a large set made of a tile of triangles.
pub type TilesBinder =
    Box<dyn Fn(&[workload::Ray], &[workload::Triangle], Extent) -> Box<dyn Job> + Send + Sync>;

/// One compiled form of one kernel.
pub struct Variant {
    /// Its place on every axis.
    pub axes: Axes,
    /// The kernel.
    pub about: &'static About,
    /// Bytes stored per triangle.
    pub bytes_per_triangle: usize,
    /// Whether this processor has the level.
    pub available: fn() -> bool,
    /// Ray i against triangle i; packets have none.
    pub pairs: Option<Binder>,
    /// Every ray against every triangle; listings and point tests have none. The number of rays
    /// must be a multiple of [`Variant::rays`].
    pub nearest: Option<Binder>,
    /// The same over a large set, made of [`crate::batch::TILE`] triangles again and again.
    pub tiles: Option<TilesBinder>,
    /// The preparing of what is stored of triangles; listings and point tests have none.
    pub preparing: Option<PrepareBinder>,
    /// Rays of a packet or a bundle; 1 for single rays.
    pub rays: usize,
    /// Tests that are done side by side: rays of a packet or a bundle, triangles of a group.
    pub lanes: usize,
    /// The work of a test; counted of single rays and packets that compute everything, in layout `aos` or
    /// with something in common.
    pub work: Option<fn() -> Work>,
}

impl Variant {
    /// Whether a wrong decision is a fault. The sum of angles claims none, nor does what computes with
    /// estimates, and what other crates claim is not for us to say: their wrong decisions are counted,
    /// and they are timed.
    pub fn claims_exactness(&self) -> bool {
        self.axes.kernel != "angle-sum" && self.axes.reciprocal == "divide" && !self.is_peer()
    }

    /// Whether it is a test of another crate, or what people write instead of taking one.
    pub fn is_peer(&self) -> bool {
        self.axes.kernel.starts_with("peer-")
    }

    /// Whether it is a placebo of `other`.
    pub fn is_copy_of(&self, other: &Variant) -> bool {
        let original = Axes { copy: 0, ..self.axes.clone() };
        self.axes.copy > 0 && original == other.axes
    }

    /// The axes joined by slashes; unique.
    pub fn id(&self) -> String {
        self.axes.id()
    }
}

/// Every variant, in the order of kernels and axes; placebos excluded.
pub fn variants() -> &'static [Variant] {
    static VARIANTS: LazyLock<Vec<Variant>> = LazyLock::new(|| {
        let mut variants = Vec::new();
        forms::all(&mut variants);
        packets::all(&mut variants);
        drives::all(&mut variants);
        sharing::all(&mut variants);
        techniques::all(&mut variants);
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        vectors::all(&mut variants);
        projections::all(&mut variants);
        points::all(&mut variants);
        listings::all(&mut variants);
        #[cfg(feature = "peers")]
        peers::all(&mut variants);
        variants
    });
    &VARIANTS
}

/// Copies of the reference kernels, ours and thesis B's: the same source at other addresses, for
/// the noise floor.
pub fn placebos() -> &'static [Variant] {
    static PLACEBOS: LazyLock<Vec<Variant>> = LazyLock::new(|| {
        let mut variants = Vec::new();
        forms::placebos(&mut variants);
        listings::placebos(&mut variants);
        variants
    });
    &PLACEBOS
}

/// The variant with that id.
pub fn find(id: &str) -> Option<&'static Variant> {
    variants().iter().find(|variant| variant.id() == id)
}

/// The id of the variant that others are compared with unless an experiment names another.
pub const REFERENCE: &str = "moller-trumbore/f32/single/sse2/early/last/plain/tuv";

/// Every kernel once, in the order of the registry; the first stored form stands for the others.
pub fn kernels() -> Vec<&'static Variant> {
    let mut seen: Vec<&'static Variant> = Vec::new();
    for variant in variants() {
        if seen.iter().all(|other| other.about.id != variant.about.id) {
            seen.push(variant);
        }
    }
    seen
}

/// The corners of a workload's triangle in the precision `E`.
pub fn corners<E: Element>(triangle: &workload::Triangle) -> Corners<E> {
    let vector = |v: glam::Vec3| Vec3(v.to_array().map(E::from_f32));
    Corners { a: vector(triangle.a), b: vector(triangle.b), c: vector(triangle.c) }
}

/// A binder over pairs.
fn bind_pairs<E: Element, T: Copy + 'static>(
    prepare: fn(&Corners<E>) -> T,
    run: crate::batch::PairsLoop<E, T>,
    code: fn(&Ray<E>, &T) -> u8,
) -> Binder {
    Box::new(move |rays, triangles| {
        let pairs = rays.iter().zip(triangles);
        let pairs = pairs.map(|(ray, triangle)| (widened(ray), prepare(&corners(triangle))));
        Box::new(PairsJob::<E, _, _>::new(pairs.collect(), run, code))
    })
}

/// A binder over rays and all triangles.
fn bind_nearest<E: Element, T: Copy + 'static>(
    shape: Shape,
    prepare: fn(&Corners<E>) -> T,
    storing: Storing<E, T>,
    run: NearestLoop<E>,
) -> Binder {
    Box::new(move |rays, triangles| {
        let rays: Vec<Ray<E>> = rays.iter().map(widened).collect();
        let records = triangles.iter().map(|triangle| prepare(&corners(triangle))).collect();
        Box::new(NearestJob::new(shape, &rays, records, storing, run))
    })
}

/// Makes a job of a kernel's preparing.
fn preparing<K: Kernel, E: Element>(triangles: &[workload::Triangle]) -> Box<dyn Job> {
    let corners: Vec<Corners<E>> = triangles.iter().map(corners).collect();
    Box::new(PrepareJob::new(corners, K::prepare::<E>, prepare_all::<K, E>))
}

/// A binder over rays and a large set.
fn bind_tiles<E: Element, T: AsRef<[E]> + Copy + 'static>(
    shape: Shape,
    prepare: fn(&Corners<E>) -> T,
    storing: Storing<E, T>,
    run: NearestLoop<E>,
) -> TilesBinder {
    Box::new(move |rays, triangles, extent| {
        let rays: Vec<Ray<E>> = rays.iter().map(widened).collect();
        let records: Vec<T> = triangles.iter().map(|one| prepare(&corners(one))).collect();
        Box::new(TilesJob::new(shape, &rays, &records, &storing, extent, run))
    })
}
