//! `ray_test render` from end to end: small pictures, what is counted, and what is refused.

mod compared;
mod pictures;
mod refusals;
mod support;
