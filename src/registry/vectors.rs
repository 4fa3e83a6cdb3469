//! Single rays with a vector in a register, of kernels whose tests are written in vectors alone: dot
//! products are sums across the lanes, or an instruction where the level has one.

use crate::batch::{InRegisters, Shape, Storing};
use crate::level::{self, Level, On};
use crate::number::{Element, Horizontal, Instruction, Real, Summing, Xyz};
use crate::policy::{Early, Full, Last, Plain, Policy};

use super::drives::Of;
use super::forms::numbers;
use super::{
    Axes, EVERY_FORM, KernelVisitor, Offers, Variant, bind_nearest, preparing, visit_kernels,
};

/// Every kernel that can.
pub fn all(v: &mut Vec<Variant>) {
    visit_kernels(&mut InVectors(v));
}

struct InVectors<'a>(&'a mut Vec<Variant>);

impl KernelVisitor for InVectors<'_> {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn kernel<K: Offers>(&mut self) {
        use crate::level::{Avx2, Sse2, Sse42};

        if !K::VECTORS {
            return;
        }
        exits::<K, Sse2, Horizontal>(self.0);
        if EVERY_FORM {
            exits::<K, Sse42, Horizontal>(self.0);
            exits::<K, Sse42, Instruction>(self.0);
            exits::<K, Avx2, Horizontal>(self.0);
            exits::<K, Avx2, Instruction>(self.0);
        }
    }
    /// Registers of four numbers are shuffled by instructions of x86.
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    fn kernel<K: Offers>(&mut self) {}
    fn other_edges<K: Offers>(&mut self) {}
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn exits<K: Offers, L: Level, D: Summing<L::Token>>(v: &mut Vec<Variant>)
where
    Xyz<L::Token, D>: Real<Element = f32> + On<L>,
{
    form::<K, Of<K, Early, Last, Plain>, L, D>(v);
    form::<K, Of<K, Full, Last, Plain>, L, D>(v);
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn form<K: Offers, P: Policy, L: Level, D: Summing<L::Token>>(v: &mut Vec<Variant>)
where
    Xyz<L::Token, D>: Real<Element = f32> + On<L>,
{
    let run = L::enter::<InRegisters<K, P, Xyz<L::Token, D>>, 0>;
    let shape = Shape { lanes: 1, rays: 1, outputs: numbers::<P::Output>() };
    v.push(Variant {
        axes: Axes {
            drive: "single-vector".into(),
            dot: D::NAME,
            ..Axes::of::<K, P>(f32::NAME, L::NAME)
        },
        about: &K::ABOUT,
        bytes_per_triangle: size_of::<K::Record<f32>>(),
        available: level::available::<L>,
        pairs: None,
        nearest: Some(bind_nearest(shape, K::prepare::<f32>, Storing::with_one_more(), run)),
        tiles: None,
        preparing: Some(preparing::<K, f32>),
        rays: 1,
        lanes: 1,
        work: None,
    });
}
