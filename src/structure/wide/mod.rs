//! The fast path: a hierarchy as wide as a register, whose leaves are groups of triangles that one test
//! answers for; a whole batch of rays to a call (Ernst and Greiner, "Multi Bounding Volume Hierarchies",
//! 2008; Wald, Benthin, Boulos, "Getting Rid of Packets", 2008; Embree).
//!
//! The tree is that of the crate `obvhs`, with nodes merged until they are full, and subtrees of no more
//! triangles than lanes to a leaf. Its answers are those of a list of the same groups by the same test,
//! under the promise of [`super`].
//!
//! **Why no box is missed.** Planes are kept relative to the middle of the scene; S is the largest of
//! their magnitudes. Rays are walked in f32 whose origin is within 64 S of the middle, and whose numbers,
//! and S, are far from the limits of f32; others are walked in f64, by the same test as everywhere. A
//! plane p is met at `p * i - o * i`, with i the inverse of the direction: roundings of o, of i, of o * i,
//! of the product and of the difference move that by no more than a plane does that is moved by
//! (64 + 64 + 65 + 65 + 65) u S < 2^-15 S, u being 2^-24. So all planes are moved outwards by that much when
//! the tree is made. Inverses are cut off at 2^100 / S: a ray that is so nearly parallel to a plane moves by
//! less than 2^-54 S towards it until it leaves the scene (S and the direction's largest component are
//! between 2^-20 and 2^20), and one that lies in a plane of a box is 2^-16 S and more away from where the
//! plane is thought to be, so that it leaves at a t of 2^84, beyond the scene. So there is no infinity and
//! no NaN, and both zeros are alike.

mod build;
mod group;
mod pose;
mod tree;
mod walk;
mod wide_job;

pub use tree::Wide;
pub use walk::{Batches, Through};
pub use wide_job::{WideJob, WideLoop};

#[cfg(test)]
mod tests;
