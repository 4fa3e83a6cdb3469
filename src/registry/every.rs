//! THE list of kernels and of published listings. Whatever is made of every one of them (timed
//! forms, forms to be asked, counters, the tests of the laws) visits this one.

use crate::kernels::listings::{Badouel, ChirkovLine, Listing, Moller, Placement};
use crate::kernels::{
    AngleSum, BadouelCramer, BaldwinWeber, Chirkov, EmbreePlucker, ExactSign, Fallback,
    FromPositions, FromRows, HalfSpaces, Keidy, KenslerShirley, MollerTrumbore,
    MollerTrumboreInF64, NoFallback, PerpendicularPlanes, Plucker, Precomputed, Shevtsov,
    SignedAreas, Vertices, Wald, WithEdges, WithNormal, WoopAffine, WoopWatertight,
};
use crate::policy::{Division, First, Last};

use super::Offers;

/// What is done with each kernel.
pub trait KernelVisitor {
    /// With a kernel, or one of its stored forms.
    fn kernel<K: Offers>(&mut self);
    /// With a kernel that keeps the signs of its edge functions, or multiplies triple products, in another
    /// way than by default.
    fn variation<K: Offers>(&mut self) {
        self.kernel::<K>();
    }
}

/// The library's own tests need a kernel of each kind; those in `tests` have every one.
const EVERY_KERNEL: bool = cfg!(not(test));

/// Visits every kernel.
pub fn visit_kernels(visitor: &mut impl KernelVisitor) {
    visitor.kernel::<MollerTrumbore>();
    // Parsers are fuzzed: to them one kernel is like another, and all of them are hours of building.
    if cfg!(fuzzing) {
        return;
    }
    visitor.kernel::<KenslerShirley<Vertices>>();
    if EVERY_KERNEL {
        visitor.kernel::<KenslerShirley<WithNormal>>();
        visitor.kernel::<KenslerShirley<Precomputed>>();
        visitor.variation::<KenslerShirley<Vertices, WithEdges>>();
        visitor.kernel::<Shevtsov>();
        visitor.kernel::<BadouelCramer>();
    }
    visitor.kernel::<Wald>();
    if EVERY_KERNEL {
        visitor.kernel::<Keidy<Vertices>>();
        visitor.kernel::<Keidy<WithNormal>>();
    }
    visitor.kernel::<PerpendicularPlanes>();
    visitor.kernel::<Chirkov>();
    if EVERY_KERNEL {
        visitor.kernel::<Plucker>();
        visitor.kernel::<HalfSpaces>();
        visitor.kernel::<SignedAreas>();
    }
    visitor.kernel::<AngleSum>();
    visitor.kernel::<WoopWatertight<Fallback>>();
    if EVERY_KERNEL {
        visitor.variation::<WoopWatertight<NoFallback>>();
        visitor.variation::<WoopWatertight<ExactSign>>();
        visitor.kernel::<EmbreePlucker>();
        visitor.kernel::<BaldwinWeber<FromPositions>>();
        visitor.kernel::<BaldwinWeber<FromRows>>();
        visitor.kernel::<WoopAffine>();
        visitor.kernel::<MollerTrumboreInF64>();
    }
}

/// What is done with each published listing.
pub trait ListingVisitor {
    /// With a listing that divides `first` or `last`.
    fn listing<K: Listing>(&mut self, division: &'static str);
}

/// Visits every listing.
pub fn visit_listings(visitor: &mut impl ListingVisitor) {
    visitor.listing::<Moller<0>>(Placement::AtOnce.division());
    visitor.listing::<Moller<1>>(Placement::AtTheEnd.division());
    visitor.listing::<Moller<2>>(Placement::BeforeTheBranch.division());
    visitor.listing::<Moller<3>>(Placement::BeforeTheBranchWithQ.division());
    visitor.listing::<Badouel>(First::NAME);
    visitor.listing::<ChirkovLine>(Last::NAME);
}
