//! What the program knows of its variants, beyond what rows tell: for recommendations.

use crate::kernels::listings::Listing;
use crate::kernels::{Edges, ExactSign, Fallback, OneIndex, Projection, ThreeIndices};
use crate::policy::{Plain, Rounding, SignBits, Tests};
use crate::recommend::KnownVariant;
use crate::registry::{ListingVisitor, Variant, asked, variants, visit_listings};

/// All of them.
pub fn known_variants() -> Vec<KnownVariant> {
    struct Listed(Vec<&'static str>);
    impl ListingVisitor for Listed {
        fn listing<K: Listing>(&mut self, _division: &'static str) {
            self.0.push(K::ABOUT.id);
        }
    }
    let mut listed = Listed(Vec::new());
    visit_listings(&mut listed);
    let variant = |variant: &Variant| KnownVariant {
        id: variant.id(),
        available: (variant.available)(),
        watertight: is_watertight(variant),
        limits: limits(variant, &listed.0).to_owned(),
        call: variant.call(),
    };
    variants().iter().map(variant).collect()
}

/// Whether the form keeps what makes its kernel watertight: sums of products that are not fused, or
/// signs that are exact whatever the rounding.
fn is_watertight(variant: &Variant) -> bool {
    let axes = &variant.axes;
    let is_plain = axes.edges == Fallback::NAME && axes.rounding == Plain::NAME;
    variant.about.watertight && (is_plain || axes.edges == ExactSign::NAME)
}

/// What a form does not do for any ray and triangle; empty if there is nothing.
fn limits(variant: &Variant, listings: &[&str]) -> &'static str {
    let axes = &variant.axes;
    let is_segment =
        asked().iter().any(|form| form.is_segment && form.about.id == variant.about.id);
    if listings.contains(&axes.kernel) {
        "answer for the line, without a distance test (published listings)"
    } else if is_segment {
        "answer for the segment to an end point"
    } else if axes.query != "ray" {
        "answer for points"
    } else if variant.is_peer() {
        "are of other crates"
    } else if axes.cull == "on" {
        "see front faces only"
    } else if !["", OneIndex::NAME, ThreeIndices::NAME].contains(&axes.projection) {
        "want triangles of one axis, or sorted by it"
    } else if axes.tests == SignBits::NAME {
        "lose hits on boundaries (sign bits as printed)"
    } else {
        ""
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_keeps_its_signs_is_watertight_and_listings_are_limited() {
        let known = known_variants();
        let find = |id: &str| known.iter().find(|variant| variant.id == id).expect(id);
        assert!(find("woop-watertight/f32/single/sse2/early/last/plain/tuv").watertight);
        assert!(!find("woop-watertight/f32/single/avx2/early/last/fused/tuv").watertight);
        assert!(!find("wald/f32/single/sse2/early/last/plain/tuv").watertight);
        assert!(find("wald/f32/single/sse2/early/last/plain/tuv").limits.is_empty());
        for limited in [
            "moller1/f32/single/sse2/early/last/plain/t",
            "chirkov/f32/single/sse2/early/last/plain/tuv",
        ] {
            assert!(!find(limited).limits.is_empty(), "{limited}");
        }
    }
}
