//! Who takes part: a kernel of one's own, or one of ours.

use std::marker::PhantomData;

use super::contest::OwnError;
use super::kernel::{Hit, OwnKernel, Ray, Triangle};
use crate::accuracy::Reported;
use crate::batch::{Foreign, ForeignPairs, LoopOver, PairsJob, widened};
use crate::check;
use crate::job::{Answer, Job};
use crate::level::Level;
use crate::number::{Element, Precision};
use crate::oracle::Query;
use crate::registry::{self, Variant, answer, corners, posed};
use crate::workload;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
type Base = crate::level::Sse2;
#[cfg(target_arch = "aarch64")]
type Base = crate::level::Neon;

type Bind = fn(&[workload::Ray], &[workload::Triangle]) -> Box<dyn Job>;

/// A kernel that takes part.
#[derive(Clone)]
pub struct Entrant {
    /// What it is called: `NAME/f32` of one's own, a variant's id of ours.
    pub id: String,
    /// What it computes in.
    pub precision: Precision,
    /// Its answer to one question, whose numbers are rounded to the precision.
    pub ask: fn(&Query) -> Answer,
    reported: Reported,
    bind: Binding,
}

#[derive(Clone, Copy)]
enum Binding {
    Own(Bind),
    Ours(&'static Variant),
}

impl Entrant {
    /// A kernel of one's own, at the level that the program is compiled for.
    pub fn own<K: OwnKernel>() -> Self {
        let name = <K::Number as Element>::NAME;
        let precision = if name == Precision::F64.name() { Precision::F64 } else { Precision::F32 };
        let reported = reported(precision, true, K::CULLS);
        let id = format!("{}/{name}", K::NAME);
        Entrant { id, precision, ask: ask::<K>, reported, bind: Binding::Own(bind::<K>) }
    }

    /// One of ours by its kernel's id, such as `wald`: its usual form, a single ray at the baseline
    /// level that leaves early.
    ///
    /// # Errors
    /// An id that no kernel has, or one that has no such form: [`OwnError::Unknown`].
    pub fn ours(kernel: &str, precision: Precision) -> Result<Self, OwnError> {
        let unknown = || OwnError::Unknown { kernel: kernel.to_owned(), precision };
        let asked = check::form(kernel, precision).filter(|asked| !asked.is_segment);
        let asked = asked.ok_or_else(unknown)?;
        let id = asked.id();
        let variant = registry::find(&id).filter(|variant| variant.pairs.is_some());
        let bind = Binding::Ours(variant.ok_or_else(unknown)?);
        let reported = reported(precision, asked.axes.output != "t", asked.axes.cull == "on");
        Ok(Entrant { id, precision, ask: asked.ask, reported, bind })
    }

    /// A variant as it stands.
    pub(super) fn of(variant: &'static Variant, precision: Precision) -> Option<Self> {
        let asked = check::form(variant.axes.kernel, precision)?;
        let reported = reported(precision, true, false);
        let bind = Binding::Ours(variant);
        Some(Entrant { id: variant.id(), precision, ask: asked.ask, reported, bind })
    }

    /// What it reports, and how it rounds.
    pub fn reported(&self) -> Reported {
        self.reported
    }

    /// Whether it is a kernel of one's own.
    pub(super) fn is_own(&self) -> bool {
        matches!(self.bind, Binding::Own(_))
    }

    /// Whether its wrong decisions are faults: all but those of ours that claim none.
    pub(super) fn claims_exactness(&self) -> bool {
        match self.bind {
            Binding::Own(_) => true,
            Binding::Ours(variant) => variant.claims_exactness(),
        }
    }

    /// The batch that is timed: ray i against triangle i. `None` where the processor lacks its level.
    pub fn job(
        &self,
        rays: &[workload::Ray],
        triangles: &[workload::Triangle],
    ) -> Option<Box<dyn Job>> {
        match self.bind {
            Binding::Own(bind) => Some(bind(rays, triangles)),
            Binding::Ours(variant) if (variant.available)() => {
                variant.pairs.as_ref().map(|bind| bind(rays, triangles))
            }
            Binding::Ours(_) => None,
        }
    }
}

fn reported(precision: Precision, uv: bool, culls: bool) -> Reported {
    let unit_roundoff = precision.unit_roundoff();
    Reported { unit_roundoff, t: true, uv, surface: false, culls }
}

fn ask<K: OwnKernel>(query: &Query) -> Answer {
    let (ray, corners) = posed::<K::Number>(query);
    match K::test(&Ray::of(&ray), &K::prepare(&Triangle::of(&corners))) {
        Some(Hit { t, u, v }) => answer(true, [t, u, v], 0),
        None => answer(false, [K::Number::ZERO; 3], u8::MAX),
    }
}

/// A kernel of one's own, in the loop of foreign tests.
struct OfOwn<K>(PhantomData<K>);

impl<K: OwnKernel> Foreign for OfOwn<K> {
    type Number = K::Number;
    type Ray = Ray<K::Number>;
    type Triangle = K::Record;

    #[inline(always)]
    fn test<const UV: bool>(ray: &Self::Ray, record: &K::Record) -> Option<[K::Number; 3]> {
        K::test(ray, record).map(|hit| [hit.t, hit.u, hit.v])
    }
}

fn bind<K: OwnKernel>(rays: &[workload::Ray], triangles: &[workload::Triangle]) -> Box<dyn Job> {
    let pair = |(ray, triangle)| {
        let ray = Ray::of(&widened::<K::Number>(ray));
        (ray, K::prepare(&Triangle::of(&corners(triangle))))
    };
    let run: LoopOver<(Ray<K::Number>, K::Record)> = Base::enter::<ForeignPairs<OfOwn<K>, true>, 0>;
    let code = |ray: &Ray<K::Number>, record: &K::Record| {
        if K::test(ray, record).is_some() { 0 } else { u8::MAX }
    };
    let pairs = rays.iter().zip(triangles).map(pair).collect();
    Box::new(PairsJob::<K::Number, _, _>::new(pairs, run, code))
}
