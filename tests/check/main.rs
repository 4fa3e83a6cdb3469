//! `ray_test check` from end to end.

mod answers;
mod classes;
mod refusals;
mod support;
