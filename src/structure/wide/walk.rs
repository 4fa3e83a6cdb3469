//! Rays through a wide tree.

use std::marker::PhantomData;

use super::pose::{Pose, is_plain, meet_in_f64};
use super::tree::{LEAF, Wide};
use crate::batch::{Packed, align_frame, everywhere, places};
use crate::kernels::Kernel;
use crate::level::{Batch, Level, On};
use crate::number::Extremes;
use crate::policy::{Policy, Ray};
use crate::structure::{Beam, Best, Hit};
use crate::workload;

/// The loop over a batch of rays: nearest hits, or any. `W` is the number of lanes of `R`, and the span of
/// `P` has to be [`crate::policy::Between`].
pub struct Through<K, P, R, const W: usize>(PhantomData<(K, P, R)>);

/// What the loop reads and writes.
pub struct Batches<'a, const W: usize> {
    /// The tree.
    pub tree: &'a Wide<W>,
    /// The records of its groups.
    pub records: &'a [f32],
    /// Rays, as drawn.
    pub drawn: &'a [workload::Ray],
    /// The same, as kernels see them.
    pub rays: &'a [Ray<f32>],
    /// A search ends at the first hit.
    pub any: bool,
    /// An answer for each ray.
    pub answers: &'a mut [Option<Hit>],
    /// Memory for nodes that wait.
    pub stack: &'a mut Vec<Waiting>,
}

/// A child that was met, and where it is entered.
#[derive(Clone, Copy, Debug)]
pub struct Waiting {
    near: f32,
    child: u32,
}

impl<L, K, P, R, const W: usize> Batch<L> for Through<K, P, R, W>
where
    L: Level,
    K: Kernel,
    P: Policy,
    R: Extremes<Element = f32> + On<L>,
{
    type Data<'a> = Batches<'a, W>;
    type Yield = ();

    #[inline(always)]
    fn run(token: L::Token, data: Batches<'_, W>) {
        let token = R::token_on(token);
        align_frame::<R>();
        let Batches { tree, records, drawn, rays, any, answers, stack } = data;
        for ((ray, drawn), answer) in rays.iter().zip(drawn).zip(answers) {
            let everywhere = everywhere::<R>(token, ray);
            let leaves =
                Leaves::<K, R, W> { token, tree, records, any, aim: K::aim::<P, R>(&everywhere) };
            let best = if tree.nodes.is_empty() {
                Best::nothing(ray.t_max)
            } else if is_plain(tree, ray) {
                let pose = Pose::<R>::new(token, tree, ray);
                leaves.walk::<P>(&pose, everywhere, ray.t_max, stack)
            } else {
                leaves.walk_in_f64::<P>(drawn, everywhere, ray.t_max, stack)
            };
            *answer = best.hit();
        }
    }
}

/// The groups of a tree, for one ray.
struct Leaves<'a, K: Kernel, R: Extremes, const W: usize> {
    token: R::Token,
    tree: &'a Wide<W>,
    records: &'a [f32],
    any: bool,
    aim: K::Aim<R>,
}

impl<K: Kernel, R: Extremes<Element = f32>, const W: usize> Leaves<'_, K, R, W> {
    #[inline(always)]
    fn walk<P: Policy>(
        &self,
        pose: &Pose<R>,
        mut ray: Ray<R>,
        t_max: f32,
        stack: &mut Vec<Waiting>,
    ) -> Best {
        let mut best = Best::nothing(t_max);
        stack.clear();
        let mut node = 0;
        loop {
            let opened = &self.tree.nodes[node as usize];
            let (near, bits) = pose.meet::<P, W>(self.token, opened, ray.t_max);
            if bits != 0 {
                let mut nears = [0.0; W];
                near.store(&mut nears);
                push(stack, &nears, &opened.children, bits);
            }
            match self.next_node::<P>(&mut ray, &mut best, stack) {
                Some(next) => node = next,
                None => return best,
            }
        }
    }

    /// The same, with boxes in f64.
    #[inline(always)]
    fn walk_in_f64<P: Policy>(
        &self,
        drawn: &workload::Ray,
        mut ray: Ray<R>,
        t_max: f32,
        stack: &mut Vec<Waiting>,
    ) -> Best {
        let mut best = Best::nothing(t_max);
        let Some(mut beam) = Beam::of_ray(drawn) else { return best };
        for axis in 0..3 {
            beam.origin[axis] -= f64::from(self.tree.middle[axis]);
        }
        stack.clear();
        let mut node = 0;
        loop {
            let opened = &self.tree.nodes[node as usize];
            let (nears, bits) = meet_in_f64(&beam, opened, best.bound());
            push(stack, &nears, &opened.children, bits);
            match self.next_node::<P>(&mut ray, &mut best, stack) {
                Some(next) => node = next,
                None => return best,
            }
        }
    }

    /// The nearest node that waits; leaves before it are tested. `None` at the end of the search.
    #[inline(always)]
    fn next_node<P: Policy>(
        &self,
        ray: &mut Ray<R>,
        best: &mut Best,
        stack: &mut Vec<Waiting>,
    ) -> Option<u32> {
        while let Some(Waiting { near, child }) = stack.pop() {
            if near > best.limit() {
                continue;
            }
            if child & LEAF == 0 {
                return Some(child);
            }
            self.test::<P>((child & !LEAF) as usize, ray, best);
            if self.any && best.hit().is_some() {
                return None;
            }
        }
        None
    }

    #[inline(always)]
    fn test<P: Policy>(&self, group: usize, ray: &mut Ray<R>, best: &mut Best) {
        let length = places::<K, f32>() * R::LANES;
        let numbers = &self.records[group * length..][..length];
        let met = K::read::<P, R, _>(&Packed { token: self.token, numbers });
        let Ok(found) = K::test::<P, R>(ray, &self.aim, &met) else { return };
        let mut bits = R::bits(found.hit);
        if bits == 0 {
            return;
        }
        let (mut t, mut u, mut v) = ([0.0; W], [0.0; W], [0.0; W]);
        found.t.store(&mut t);
        found.u.store(&mut u);
        found.v.store(&mut v);
        while bits != 0 {
            let lane = bits.trailing_zeros() as usize % W;
            bits &= bits - 1;
            let triangle = self.tree.groups[group][lane];
            best.offer(Hit { triangle, t: t[lane], u: u[lane], v: v[lane] });
        }
        ray.t_max = R::splat(self.token, best.limit());
    }
}

/// Children that are met, the nearest on top.
#[inline(always)]
fn push<const W: usize>(
    stack: &mut Vec<Waiting>,
    nears: &[f32; W],
    children: &[u32; W],
    mut bits: u64,
) {
    let begin = stack.len();
    while bits != 0 {
        let lane = bits.trailing_zeros() as usize % W;
        bits &= bits - 1;
        stack.push(Waiting { near: nears[lane], child: children[lane] });
    }
    let pushed = &mut stack[begin..];
    for end in 1..pushed.len() {
        let mut place = end;
        while place > 0 && pushed[place - 1].near < pushed[place].near {
            pushed.swap(place - 1, place);
            place -= 1;
        }
    }
}
