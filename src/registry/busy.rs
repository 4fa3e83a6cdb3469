//! The kernel that a core is looked at with, to see whether somebody else uses it.

use super::variants;
use crate::job::Job;
use crate::workload::{PairSpec, Pairs};

/// Pairs of it: near, and its whole time.
const PAIRS: usize = 64;

/// The reference's algorithm at the lowest level that there is, computing everything, over a few
/// pairs; `None` on a processor without that level.
pub fn busy_kernel() -> Option<Box<dyn Job>> {
    let pairs = Pairs::draw(PairSpec::new(PAIRS, 0.5, 1)).ok()?;
    let full = variants().iter().find(|variant| {
        let axes = &variant.axes;
        let drive = axes.drive == "single" && axes.exit == "full" && axes.output == "tuv";
        axes.kernel == "moller-trumbore" && drive && (variant.available)()
    })?;
    full.pairs.as_ref().map(|bind| bind(&pairs.rays, &pairs.triangles))
}
