//! Other ways to drive a kernel than single rays and packets over an array of structures: groups of
//! triangles, bundles of single rays, and memory layouts. A few kernels stand for all.

use crate::batch::{Aos, Aosoa, Bundle, Group, Layout, Nearest, NearestLoop, Shape, Soa, Storing};
use crate::level::{self, Level, On};
use crate::number::{Element, Real};
use crate::policy::{
    Compare, Early, Exit, First, Form, Full, Last, Nearer, Plain, Policy, Rounding, Tuv, TwoSided,
};

use super::forms::{drive, numbers};
use super::{
    Axes, KernelVisitor, Offers, Variant, bind_nearest, bind_tiles, preparing, registers,
    visit_kernels,
};

/// Every kernel that is driven in other ways.
pub fn all(v: &mut Vec<Variant>) {
    visit_kernels(&mut Driven(v));
}

struct Driven<'a>(&'a mut Vec<Variant>);

impl KernelVisitor for Driven<'_> {
    fn kernel<K: Offers>(&mut self) {
        if K::GROUPS {
            all_groups::<K>(self.0);
        }
        if K::BUNDLES {
            bundle::<K, Of<K, Early, Last, Plain>, 4>(self.0);
            bundle::<K, Of<K, Early, Last, Plain>, 8>(self.0);
        }
        if K::LAYOUTS {
            layouts::<K>(self.0);
        }
    }
    fn variation<K: Offers>(&mut self) {}
}

/// A form of `K` with t, u and v.
pub type Of<K, E, D, A> = Form<E, D, A, Tuv, TwoSided, Compare, <K as Offers>::Native, Nearer>;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
type Base = level::Sse2;
#[cfg(target_arch = "aarch64")]
type Base = level::Neon;

/// One ray against as many triangles as a register of the level has numbers. Of sixteen in `full` only:
/// leaving early, Möller-Trumbore's test has one register more than there are.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn all_groups<K: Offers>(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512, Sse2};
    use crate::policy::Fused;

    groups::<K, registers::Four, Sse2, Plain, 4>(v);
    groups::<K, registers::Eight, Avx2, Fused, 8>(v);
    group::<K, Full, registers::Sixteen, Avx512, Fused, 16>(v);
}

/// One ray against as many triangles as a register of the level has numbers.
#[cfg(target_arch = "aarch64")]
fn all_groups<K: Offers>(v: &mut Vec<Variant>) {
    groups::<K, registers::Four, level::Neon, crate::policy::Fused, 4>(v);
}

/// Early and full, divided last where the kernel can be.
fn groups<K, R, L, A, const WIDTH: usize>(v: &mut Vec<Variant>)
where
    K: Offers,
    R: Real + On<L>,
    L: Level,
    A: Rounding,
{
    group::<K, Early, R, L, A, WIDTH>(v);
    group::<K, Full, R, L, A, WIDTH>(v);
}

fn group<K, E, R, L, A, const WIDTH: usize>(v: &mut Vec<Variant>)
where
    K: Offers,
    E: Exit,
    R: Real + On<L>,
    L: Level,
    A: Rounding,
{
    if K::LAST {
        one_group::<K, Of<K, E, Last, A>, R, L, WIDTH>(v);
    } else {
        one_group::<K, Of<K, E, First, A>, R, L, WIDTH>(v);
    }
}

/// In the one layout that a group's loop reads. `WIDTH` is the number of lanes.
fn one_group<K, P, R, L, const WIDTH: usize>(v: &mut Vec<Variant>)
where
    K: Offers,
    P: Policy,
    R: Real + On<L>,
    L: Level,
{
    let run = L::enter::<Group<K, P, R>, 0>;
    push::<K, P, R::Element, L, Aosoa<WIDTH>>(v, format!("group{WIDTH}"), [1, 1, WIDTH], run);
}

/// At the baseline: what sharing gains without wide registers.
fn bundle<K: Offers, P: Policy, const N: usize>(v: &mut Vec<Variant>) {
    let run = Base::enter::<Bundle<K, P, f32, N>, 0>;
    push::<K, P, f32, Base, Aos>(v, format!("bundle{N}"), [1, N, N], run);
}

/// Single rays at the baseline, and the widest packets.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn layouts<K: Offers>(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512};
    use crate::policy::Fused;

    stored::<K, Of<K, Early, Last, Plain>, f32, Base>(v);
    stored::<K, Of<K, Early, Last, Fused>, registers::Eight, Avx2>(v);
    stored::<K, Of<K, Full, Last, Fused>, registers::Eight, Avx2>(v);
    stored::<K, Of<K, Early, Last, Fused>, registers::Sixteen, Avx512>(v);
    stored::<K, Of<K, Full, Last, Fused>, registers::Sixteen, Avx512>(v);
}

/// Single rays.
#[cfg(target_arch = "aarch64")]
fn layouts<K: Offers>(v: &mut Vec<Variant>) {
    stored::<K, Of<K, Early, Last, Plain>, f32, Base>(v);
}

/// The two layouts that are not the usual one.
fn stored<K: Offers, P: Policy, R: Real + On<L>, L: Level>(v: &mut Vec<Variant>) {
    let soa = L::enter::<Nearest<K, P, R, Soa>, 0>;
    push::<K, P, R::Element, L, Soa>(v, drive::<R>(), [R::LANES; 3], soa);
    let aosoa = L::enter::<Nearest<K, P, R, Aosoa<16>>, 0>;
    push::<K, P, R::Element, L, Aosoa<16>>(v, drive::<R>(), [R::LANES; 3], aosoa);
}

/// One variant over all triangles: rays side by side, rays of an item, tests side by side.
pub fn push<K: Offers, P: Policy, E: Element, L: Level, Y: Layout>(
    v: &mut Vec<Variant>,
    drive: String,
    [lanes, rays, tests]: [usize; 3],
    run: NearestLoop<E>,
) {
    v.push(driven::<K, P, E, L, Y>(drive, [lanes, rays, tests], run));
}

/// That variant, its work not counted.
pub fn driven<K: Offers, P: Policy, E: Element, L: Level, Y: Layout>(
    drive: String,
    [lanes, rays, tests]: [usize; 3],
    run: NearestLoop<E>,
) -> Variant {
    let axes = Axes { drive, layout: Y::NAME, ..Axes::of::<K, P>(E::NAME, L::NAME) };
    let shape = Shape { lanes, rays, outputs: numbers::<P::Output>() };
    Variant {
        axes,
        about: &K::ABOUT,
        bytes_per_triangle: size_of::<K::Record<E>>(),
        available: level::available::<L>,
        pairs: None,
        nearest: Some(bind_nearest(shape, K::prepare::<E>, Storing::of::<Y>(), run)),
        tiles: Some(bind_tiles(shape, K::prepare::<E>, Storing::of::<Y>(), run)),
        preparing: Some(preparing::<K, E>),
        rays,
        lanes: tests,
        work: None,
    }
}
