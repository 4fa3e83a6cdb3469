//! The laws that every kernel obeys, without any tolerance.
//!
//! 1. *Policies agree* (`policies`): in exact arithmetic early and full, first and last, plain and
//!    fused, and both orders of the tests give the same hits and the same t, u and v.
//! 2. *Kernels agree* (`kernels`, `listings`, `points`): in exact arithmetic every kernel gives the
//!    answer of elimination on the ray's linear system, which itself gives the oracle's class;
//!    edges and vertices included. Published conventions that differ are stated one by one.
//! 3. *Lanes agree* (the test `lanes`, apart because it takes long to build): lane i of a packet is
//!    the scalar kernel, bit for bit.
//!
//! So whatever error is measured elsewhere is rounding.

mod cases;
mod exact;
mod forms;
mod kernels;
mod listings;
mod points;
mod policies;
mod reference;
