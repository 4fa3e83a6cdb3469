//! `ray_test check` from end to end.

mod answers;
mod classes;
mod kernels;
mod refusals;
mod support;
