//! Making the processor forget what it has learned of a piece of code.

/// Something that takes the place of a kernel's code in the caches of instructions and of its
/// branches in the predictor.
pub trait Forget {
    /// Run before every cold call of the contestant `id`, outside of the timed window.
    fn forget(&mut self, id: &str);
}

/// Forgets nothing: for groups that are measured warm.
#[derive(Clone, Copy, Debug, Default)]
pub struct Remember;

impl Forget for Remember {
    fn forget(&mut self, _id: &str) {}
}
