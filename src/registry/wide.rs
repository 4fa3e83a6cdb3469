//! The fast path through a hierarchy, at every level, with the kernels that groups are fastest with and
//! one that is watertight.
//!
//! Meshes have triangles that are small beside their coordinates, and the published fourth column of
//! Baldwin and Weber loses u and v there (see the kernel's weakness): here it is the one from rows, which
//! costs a test nothing.

use crate::kernels::{About, BaldwinWeber, Fallback, FromRows, MollerTrumbore, WoopWatertight};
use crate::level::{self, Level, On};
use crate::number::Extremes;
use crate::policy::{Between, Compare, Early, Form, Last, Rounding, Tuv, TwoSided};
use crate::structure::SearchJob;
use crate::structure::wide::{Through, WideJob};
use crate::workload::{Ray, Triangle};

use super::{Axes, Offers, registers};

/// Makes a job of nearest hits, or with `true` of any hit, of rays among triangles.
pub type SearchBinder = fn(&[Triangle], &[Ray], bool) -> Box<dyn SearchJob>;

/// One kernel in groups at the leaves of a hierarchy as wide as a register.
pub struct WideForm {
    /// Its place on every axis, as of a group.
    pub axes: Axes,
    /// The kernel.
    pub about: &'static About,
    /// Whether this processor has the level.
    pub available: fn() -> bool,
    /// Builds the hierarchy and prepares its leaves.
    pub bind: SearchBinder,
}

/// All of them.
pub fn wide_forms() -> Vec<WideForm> {
    let mut all = Vec::new();
    kernel::<MollerTrumbore>(&mut all);
    kernel::<BaldwinWeber<FromRows>>(&mut all);
    kernel::<WoopWatertight<Fallback>>(&mut all);
    all
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn kernel<K: Offers>(all: &mut Vec<WideForm>) {
    use crate::level::{Avx2, Avx512, Sse2};
    use crate::policy::{Fused, Plain};

    all.push(form::<K, registers::Four, Sse2, Plain, 4>());
    all.push(form::<K, registers::Eight, Avx2, Fused, 8>());
    all.push(form::<K, registers::Sixteen, Avx512, Fused, 16>());
}

#[cfg(target_arch = "aarch64")]
fn kernel<K: Offers>(all: &mut Vec<WideForm>) {
    all.push(form::<K, registers::Four, level::Neon, crate::policy::Fused, 4>());
}

type Of<K, A> = Form<Early, Last, A, Tuv, TwoSided, Compare, <K as Offers>::Native, Between>;

/// `W` is the number of lanes.
fn form<K, R, L, A, const W: usize>() -> WideForm
where
    K: Offers,
    R: Extremes<Element = f32> + On<L>,
    L: Level,
    A: Rounding,
{
    fn bind<K, R, L, A, const W: usize>(
        triangles: &[Triangle],
        rays: &[Ray],
        any: bool,
    ) -> Box<dyn SearchJob>
    where
        K: Offers,
        R: Extremes<Element = f32> + On<L>,
        L: Level,
        A: Rounding,
    {
        let run = L::enter::<Through<K, Of<K, A>, R, W>, 0>;
        Box::new(WideJob::<W>::new::<K>(triangles, rays, any, run))
    }
    let axes = Axes {
        drive: format!("group{W}"),
        layout: "aosoa",
        ..Axes::of::<K, Of<K, A>>("f32", L::NAME)
    };
    WideForm {
        axes,
        about: &K::ABOUT,
        available: level::available::<L>,
        bind: bind::<K, R, L, A, W>,
    }
}
