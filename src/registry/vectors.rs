//! Single rays with a vector in a register, of kernels whose tests are written in vectors alone: dot
//! products are sums across the lanes, or an instruction where the level has one. On x86, whose
//! shuffles these are.

use crate::batch::{
    Aos, InRegisters, LoopOver, PairsInRegisters, PairsJob, RAY_NUMBERS, Shape, Storing, load,
    ray_numbers, widened,
};
use crate::kernels::Kernel;
use crate::level::{self, Avx2, Level, On, Sse2, Sse42};
use crate::number::{Element, Horizontal, Instruction, Real, Summing, Xyz};
use crate::policy::{
    Between, Compare, Division, Early, Exit, First, Form, Full, Inside, Last, Leading, Nearer,
    Once, Plain, SignBitsSafe, Tests, Tuv, TwoSided,
};

use super::exit_code::exit_code;
use super::forms::numbers;
use super::{
    Axes, Binder, EVERY_FORM, KernelVisitor, Offers, Variant, bind_nearest, corners, preparing,
    visit_kernels,
};

/// Every kernel that can.
pub fn all(v: &mut Vec<Variant>) {
    visit_kernels(&mut InVectors(v));
}

struct InVectors<'a>(&'a mut Vec<Variant>);

impl KernelVisitor for InVectors<'_> {
    fn kernel<K: Offers>(&mut self) {
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
        if K::INSIDE_FIRST && EVERY_FORM {
            techniques::<K, Avx2, Horizontal>(self.0);
        }
    }
    fn variation<K: Offers>(&mut self) {}
}

/// Of the kernels that stand for the others, what asks once: behind everything, or for the inside before
/// anything else, by signs.
fn techniques<K: Offers, L: Level, D: Summing<L::Token>>(v: &mut Vec<Variant>)
where
    Xyz<L::Token, D>: Real<Element = f32> + On<L>,
{
    form::<K, L, D, Early, First, Compare, K::Native>(v);
    form::<K, L, D, Once, First, Compare, K::Native>(v);
    form::<K, L, D, Once, Last, Compare, K::Native>(v);
    form::<K, L, D, Early, First, SignBitsSafe, Inside>(v);
    form::<K, L, D, Early, Last, SignBitsSafe, Inside>(v);
}

fn exits<K: Offers, L: Level, D: Summing<L::Token>>(v: &mut Vec<Variant>)
where
    Xyz<L::Token, D>: Real<Element = f32> + On<L>,
{
    form::<K, L, D, Early, Last, Compare, K::Native>(v);
    form::<K, L, D, Full, Last, Compare, K::Native>(v);
}

/// A form with t, u and v, over pairs and over all triangles.
fn form<K, L, D, E, V, C, Q>(v: &mut Vec<Variant>)
where
    K: Offers,
    L: Level,
    D: Summing<L::Token>,
    E: Exit,
    V: Division,
    C: Tests,
    Q: Leading,
    Xyz<L::Token, D>: Real<Element = f32> + On<L>,
{
    type Of<E, V, C, Q, S> = Form<E, V, Plain, Tuv, TwoSided, C, Q, S>;
    let axes = Axes {
        drive: "single-vector".into(),
        dot: D::NAME,
        ..Axes::of::<K, Of<E, V, C, Q, Nearer>>(f32::NAME, L::NAME)
    };
    let nearest = L::enter::<InRegisters<K, Of<E, V, C, Q, Nearer>, Xyz<L::Token, D>>, 0>;
    let pairs = L::enter::<PairsInRegisters<K, Of<E, V, C, Q, Between>, Xyz<L::Token, D>>, 0>;
    let shape = Shape { lanes: 1, rays: 1, outputs: numbers::<Tuv>() };
    v.push(Variant {
        axes,
        about: &K::ABOUT,
        bytes_per_triangle: size_of::<K::Record<f32>>(),
        available: level::available::<L>,
        pairs: Some(bind_pairs::<K>(pairs)),
        nearest: Some(bind_nearest(shape, K::prepare::<f32>, Storing::of::<Aos>(), nearest)),
        tiles: None,
        preparing: Some(preparing::<K, f32>),
        rays: 1,
        lanes: 1,
        work: None,
    });
}

/// A ray's numbers in a row, and a record.
type Pair<K> = ([f32; RAY_NUMBERS], <K as Kernel>::Record<f32>);

/// A binder over such pairs.
fn bind_pairs<K: Offers>(run: LoopOver<Pair<K>>) -> Binder {
    fn code<K: Offers>(ray: &[f32; RAY_NUMBERS], record: &K::Record<f32>) -> u8 {
        exit_code::<K, f32>(&load::<f32>((), ray), record)
    }
    Box::new(move |rays, triangles| {
        let pairs = rays.iter().zip(triangles);
        let pairs = pairs.map(|(ray, triangle)| {
            (ray_numbers(&widened::<f32>(ray)), K::prepare(&corners::<f32>(triangle)))
        });
        Box::new(PairsJob::<f32, _, _>::new(pairs.collect(), run, code::<K>))
    })
}
