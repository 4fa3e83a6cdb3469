//! Every kernel as a function from one case to one answer: for what is asked without a clock.
//!
//! The same source as the timed forms, in their early single-ray form with output `tuv`; lanes,
//! levels and full work give the same bits (`tests/lanes`), so nothing of accuracy is left out.

use crate::job::Answer;
use crate::kernels::listings::{Listing, Literally};
use crate::kernels::{About, Corners};
use crate::number::{Element, Flushed, Vec3};
use crate::oracle::Query;
use crate::policy::{
    Between, Compare, Division, Early, First, Form, Fused, Last, Plain, Policy, Products, Ray,
    Rounding, SignBits, SignBitsSafe, Tests, Tuv, TwoSided,
};
use std::sync::LazyLock;

use super::{Axes, KernelVisitor, ListingVisitor, Offers, visit_kernels, visit_listings};

/// One form of one kernel, to be asked.
pub struct Asked {
    /// Its place on every axis: that of the timed form of the same id, where there is one.
    pub axes: Axes,
    /// The kernel.
    pub about: &'static About,
    /// It answers about the segment from origin to end, not about the ray.
    pub is_segment: bool,
    /// The answer. Inputs are rounded to the precision; `triangle` is `Some(0)` for a hit.
    pub ask: fn(&Query) -> Answer,
}

impl Asked {
    /// The axes joined by slashes.
    pub fn id(&self) -> String {
        self.axes.id()
    }
}

/// All of them, in the order of the registry.
pub fn asked() -> &'static [Asked] {
    static ASKED: LazyLock<Vec<Asked>> = LazyLock::new(|| {
        let mut all = Vec::new();
        visit_kernels(&mut Asking(&mut all));
        visit_listings(&mut Asking(&mut all));
        all
    });
    &ASKED
}

/// [`asked`], and the peers of this build: their errors and decisions are counted beside ours. The laws
/// that our own forms are held to do not bind them.
#[cfg(feature = "peers")]
pub fn asked_with_peers() -> impl Iterator<Item = &'static Asked> {
    asked().iter().chain(super::peers::asked())
}

/// [`asked`]: there are no peers in this build.
#[cfg(not(feature = "peers"))]
pub fn asked_with_peers() -> impl Iterator<Item = &'static Asked> {
    asked().iter()
}

struct Asking<'a>(&'a mut Vec<Asked>);

impl KernelVisitor for Asking<'_> {
    fn kernel<K: Offers>(&mut self) {
        kernel::<K>(self.0);
    }
}

impl ListingVisitor for Asking<'_> {
    fn listing<K: Listing>(&mut self, division: &'static str) {
        listing::<K>(self.0, division);
    }
}

fn kernel<K: Offers>(all: &mut Vec<Asked>) {
    precision::<K, f32>(all);
    if K::F64 {
        precision::<K, f64>(all);
    }
    if K::LAST {
        form::<K, Flushed<f32>, Last, Plain, Compare>(all, FLUSHED);
    } else {
        form::<K, Flushed<f32>, First, Plain, Compare>(all, FLUSHED);
    }
}

fn precision<K: Offers, E: Element>(all: &mut Vec<Asked>) {
    if K::FIRST {
        form::<K, E, First, Plain, Compare>(all, KEPT);
        form::<K, E, First, Fused, Compare>(all, KEPT);
    }
    if K::LAST {
        form::<K, E, Last, Plain, Compare>(all, KEPT);
        form::<K, E, Last, Fused, Compare>(all, KEPT);
    }
    if K::SIGN_BITS {
        form::<K, E, Last, Plain, SignBits>(all, KEPT);
        form::<K, E, Last, Plain, SignBitsSafe>(all, KEPT);
    }
    if K::PRODUCTS {
        form::<K, E, Last, Plain, Products>(all, KEPT);
    }
}

/// The axis `subnormals`.
const KEPT: &str = "kept";
/// [`Flushed`] numbers: one form per kernel, untimed.
const FLUSHED: &str = "flushed";

/// The level at which the form is named: the lowest that has it.
fn level(fused: bool) -> &'static str {
    match (cfg!(target_arch = "aarch64"), fused) {
        (true, _) => "neon",
        (false, true) => "avx2",
        (false, false) => "sse2",
    }
}

fn form<K, E, D, A, C>(all: &mut Vec<Asked>, subnormals: &'static str)
where
    K: Offers,
    E: Element,
    D: Division,
    A: Rounding,
    C: Tests,
{
    type Of<K, D, A, C> = Form<Early, D, A, Tuv, TwoSided, C, <K as Offers>::Native, Between>;
    let axes = Axes {
        output: if K::UV { "tuv" } else { "t" },
        subnormals,
        ..Axes::of::<K, Of<K, D, A, C>>(E::NAME, level(A::NAME == Fused::NAME))
    };
    let ask = ask::<K, Of<K, D, A, C>, E>;
    all.push(Asked { axes, about: &K::ABOUT, is_segment: K::ABOUT.id == "chirkov", ask });
}

fn ask<K: Offers, P: Policy, E: Element>(query: &Query) -> Answer {
    let (ray, corners) = posed::<E>(query);
    let met = K::meet::<P, E>((), &K::prepare(&corners));
    match K::test::<P, E>(&ray, &K::aim::<P, E>(&ray), &met) {
        Ok(found) if found.hit => answer(true, [found.t, found.u, found.v], 0),
        Ok(_) => answer(false, [E::ZERO; 3], u8::MAX),
        Err(miss) => answer(false, [E::ZERO; 3], miss.0),
    }
}

fn listing<K: Listing>(all: &mut Vec<Asked>, division: &'static str) {
    listed::<K, f32>(all, division, KEPT);
    listed::<K, f64>(all, division, KEPT);
    listed::<K, Flushed<f32>>(all, division, FLUSHED);
}

/// The place of a listing on every axis.
pub(super) fn listing_axes<K: Listing>(precision: &'static str, division: &'static str) -> Axes {
    Axes {
        division,
        leading: "inside",
        stored: K::ABOUT.stored,
        ..Axes::usual(K::ABOUT.id, precision, level(false))
    }
}

fn listed<K: Listing, E: Element>(
    all: &mut Vec<Asked>,
    division: &'static str,
    subnormals: &'static str,
) {
    fn ask<K: Listing, E: Element>(query: &Query) -> Answer {
        let (ray, corners) = posed::<E>(query);
        let (code, t, u, v) = K::run::<E, Literally, true>(&ray, &K::prepare(&corners));
        answer(code == 0, [t, u, v], code)
    }
    let axes = Axes { subnormals, ..listing_axes::<K>(E::NAME, division) };
    all.push(Asked { axes, about: &K::ABOUT, is_segment: false, ask: ask::<K, E> });
}

pub(crate) fn answer<E: Element>(hit: bool, [t, u, v]: [E; 3], code: u8) -> Answer {
    let (t, u, v) = (t.to_f64(), u.to_f64(), v.to_f64());
    Answer { triangle: hit.then_some(0), t, u, v, code, ..Answer::default() }
}

/// A query in the precision `E`: infinite bounds become the largest finite number; without an end
/// the segment ends at t = 1.
pub(crate) fn posed<E: Element>(query: &Query) -> (Ray<E>, Corners<E>) {
    let vector = |v: [f64; 3]| Vec3(v.map(E::from_f64));
    let bound = |t: f64| E::from_f64(t.clamp(-E::MAX.to_f64(), E::MAX.to_f64()));
    let (origin, direction) = (vector(query.origin), vector(query.direction));
    let ray = Ray {
        origin,
        direction,
        end: query.end.map_or(origin + direction, vector),
        t_min: bound(query.t_min),
        t_max: bound(query.t_max),
    };
    let [a, b, c] = query.triangle.map(vector);
    (ray, Corners { a, b, c })
}
