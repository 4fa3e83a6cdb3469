//! How Wald's test, which stands for all that project, knows the axis of a triangle's projection.

use crate::batch::{Batches, Shape, Storing};
use crate::kernels::{Fixed, Kernel, OneIndex, ThreeIndices, Wald};
use crate::level::{self, Level, On};
use crate::number::{Element, Twice};
use crate::policy::{
    Between, Compare, Distance, Early, Exit, First, Form, Full, Fused, Last, Nearer, Output, Plain,
    Policy, Rounding, T, Tuv, TwoSided,
};

use super::forms::{drive, numbers, variant};
use super::{Axes, Offers, Variant, bind_nearest, preparing, registers};

/// Three stored indices; one axis for all, of which a terrain needs the last; three sorted batches.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
pub fn all(v: &mut Vec<Variant>) {
    use crate::level::{Avx2, Avx512, Sse2};
    use registers::{Eight, Sixteen};

    ways::<f32, Sse2, Early, Plain>(v);
    ways::<Eight, Avx2, Early, Fused>(v);
    ways::<Eight, Avx2, Full, Fused>(v);
    ways::<Sixteen, Avx512, Early, Fused>(v);
    ways::<Sixteen, Avx512, Full, Fused>(v);
    at_once::<Wald<Fixed<2>>, Sixteen, Avx512, Tuv>(v);
    at_once::<Wald<Fixed<2>>, Twice<Sixteen>, Avx512, Tuv>(v);
    at_once::<Wald<Fixed<2>>, Twice<Sixteen>, Avx512, T>(v);
    at_once::<Wald<OneIndex>, Twice<Sixteen>, Avx512, T>(v);
}

/// Divided at once: how little a test can do. No axis is looked up, and where only t is wanted no
/// weights are kept.
fn at_once<K: Offers, R: On<L>, L: Level, O: Output>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    type Of<O, S> = Form<Full, First, Fused, O, TwoSided, Compare, Distance, S>;
    variant::<K, Of<O, Between>, Of<O, Nearer>, R, L, 0>(v);
}

/// Three stored indices; one axis for all, of which a terrain needs the last; three sorted batches.
#[cfg(target_arch = "aarch64")]
pub fn all(v: &mut Vec<Variant>) {
    ways::<f32, level::Neon, Early, Plain>(v);
    ways::<registers::Four, level::Neon, Early, Fused>(v);
    ways::<registers::Four, level::Neon, Full, Fused>(v);
    at_once::<Wald<Fixed<2>>, registers::Four, level::Neon, Tuv>(v);
    at_once::<Wald<Fixed<2>>, Twice<registers::Four>, level::Neon, Tuv>(v);
    at_once::<Wald<Fixed<2>>, Twice<registers::Four>, level::Neon, T>(v);
    at_once::<Wald<OneIndex>, Twice<registers::Four>, level::Neon, T>(v);
}

type Of<E, A, S> = Form<E, Last, A, Tuv, TwoSided, Compare, Distance, S>;

fn ways<R: On<L>, L: Level, E: Exit, A: Rounding>(v: &mut Vec<Variant>)
where
    R::Element: On<L>,
{
    variant::<Wald<ThreeIndices>, Of<E, A, Between>, Of<E, A, Nearer>, R, L, 0>(v);
    variant::<Wald<Fixed<2>>, Of<E, A, Between>, Of<E, A, Nearer>, R, L, 0>(v);
    batches::<Of<E, A, Nearer>, R, L>(v);
}

fn batches<P: Policy, R: On<L>, L: Level>(v: &mut Vec<Variant>) {
    type Loop<P, R> = Batches<Wald<Fixed<0>>, Wald<Fixed<1>>, Wald<Fixed<2>>, P, R>;
    type Stored<E> = <Wald as Kernel>::Record<E>;
    let run = L::enter::<Loop<P, R>, 0>;
    let axes = Axes {
        drive: drive::<R>(),
        projection: "batches",
        ..Axes::of::<Wald, P>(R::Element::NAME, L::NAME)
    };
    let shape = Shape { lanes: R::LANES, rays: R::LANES, outputs: numbers::<P::Output>() };
    let prepare = Wald::<OneIndex>::prepare::<R::Element>;
    v.push(Variant {
        axes,
        about: &<Wald as Kernel>::ABOUT,
        bytes_per_triangle: size_of::<Stored<R::Element>>(),
        available: level::available::<L>,
        pairs: None,
        nearest: Some(bind_nearest(shape, prepare, Storing::batches(), run)),
        tiles: None,
        preparing: Some(preparing::<Wald, R::Element>),
        rays: R::LANES,
        lanes: R::LANES,
        work: None,
    });
}
