//! Every kernel as the leaf of a structure: one form each, that of single rays at the baseline in f32,
//! early, divided last where the kernel can be, with t, u and v; and every published listing.

use crate::kernels::About;
use crate::kernels::listings::Listing;
use crate::policy::{Between, Compare, Division, Early, First, Form, Last, Plain, Tuv, TwoSided};
use crate::structure::{KernelLeaf, Leaf, ListingLeaf};
use crate::workload::Triangle;

use super::asked::listing_axes;
use super::{Axes, KernelVisitor, ListingVisitor, Offers, visit_kernels, visit_listings};

/// One kernel, or one of its stored forms, as a leaf.
pub struct LeafForm {
    /// Its place on every axis: that of the timed form of the same id.
    pub axes: Axes,
    /// The kernel.
    pub about: &'static About,
    /// It answers about the segment from origin to end, not about the ray.
    pub is_segment: bool,
    /// Prepares triangles.
    pub prepare: fn(&[Triangle]) -> Box<dyn Leaf>,
}

/// All of them, in the order of the registry.
pub fn leaves() -> Vec<LeafForm> {
    let mut all = Vec::new();
    visit_kernels(&mut Leaves(&mut all));
    visit_listings(&mut Leaves(&mut all));
    all
}

struct Leaves<'a>(&'a mut Vec<LeafForm>);

impl KernelVisitor for Leaves<'_> {
    fn kernel<K: Offers>(&mut self) {
        if K::LAST {
            self.0.push(form::<K, Last>());
        } else {
            self.0.push(form::<K, First>());
        }
    }
}

impl ListingVisitor for Leaves<'_> {
    fn listing<K: Listing>(&mut self, division: &'static str) {
        let axes = listing_axes::<K>("f32", division);
        let prepare = |triangles: &[Triangle]| -> Box<dyn Leaf> {
            Box::new(ListingLeaf::<K>::new(triangles))
        };
        self.0.push(LeafForm { axes, about: &K::ABOUT, is_segment: false, prepare });
    }
}

/// The baseline of the processor's architecture.
const LEVEL: &str = if cfg!(target_arch = "aarch64") { "neon" } else { "sse2" };

/// Kernels that are judged on (origin, end).
fn is_segment<K: Offers>() -> bool {
    K::ABOUT.id == "chirkov"
}

type Of<K, D> = Form<Early, D, Plain, Tuv, TwoSided, Compare, <K as Offers>::Native, Between>;

fn form<K: Offers, D: Division>() -> LeafForm {
    fn prepare<K: Offers, D: Division>(triangles: &[Triangle]) -> Box<dyn Leaf> {
        Box::new(KernelLeaf::<K, Of<K, D>>::new(triangles, is_segment::<K>()))
    }
    let axes =
        Axes { output: if K::UV { "tuv" } else { "t" }, ..Axes::of::<K, Of<K, D>>("f32", LEVEL) };
    LeafForm { axes, about: &K::ABOUT, is_segment: is_segment::<K>(), prepare: prepare::<K, D> }
}
