//! How close to the limit: the fewest cycles that a test's own operations need on this machine.
//!
//! What an optimiser must leave of a test is [noted](crate::number::Traced) while it runs, as
//! [`Work`]. What an operation costs where nothing waits is measured by [streams](crate::batch::Stream)
//! of it, as [`Costs`]. The bound is the largest, over the resources of the machine, of what the
//! work asks of them. Dependences, loop control, spills and broadcasts of computed numbers are not in
//! it, so nothing can be faster, and what is slower waits for one of these.

mod costs;
mod work;

pub use costs::{Bound, Costs};
pub use work::{Work, shared_work, work};
