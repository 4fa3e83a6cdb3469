//! What the rays of a packet have in common (thesis H, 4.2: packets of a common origin).

/// What is the same in all rays of a packet. The loop reads it once per packet; what follows from it
/// and a triangle alone is then the same in all registers of the packet, and computed once.
pub trait Sharing: Copy + 'static {
    /// What the column `drive` says behind the number of rays.
    const SUFFIX: &'static str;
    /// The origin. Kernels that can gain by it multiply in another order: what depends on the triangle
    /// and the origin comes first.
    const ORIGIN: bool;
    /// The direction.
    const DIRECTION: bool;
}

/// Nothing.
#[derive(Clone, Copy)]
pub struct General;
/// The origin: a camera's rays, or those to a point light.
#[derive(Clone, Copy)]
pub struct CommonOrigin;
/// The direction: rays to the sun.
#[derive(Clone, Copy)]
pub struct Parallel;

impl Sharing for General {
    const SUFFIX: &'static str = "";
    const ORIGIN: bool = false;
    const DIRECTION: bool = false;
}

impl Sharing for CommonOrigin {
    const SUFFIX: &'static str = "-common-origin";
    const ORIGIN: bool = true;
    const DIRECTION: bool = false;
}

impl Sharing for Parallel {
    const SUFFIX: &'static str = "-parallel";
    const ORIGIN: bool = false;
    const DIRECTION: bool = true;
}
