//! THE list of kernels and of published listings. Whatever is made of every one of them (timed
//! forms, forms to be asked, counters, the tests of the laws) visits this one.

use crate::kernels::listings::{Badouel, ChirkovLine, Listing, Moller, Placement};
use crate::kernels::{
    AngleSum, BadouelCramer, BaldwinWeber, Chirkov, EmbreePlucker, ExactSign, Fallback,
    FromPositions, FromRows, HalfSpaces, Keidy, KenslerShirley, MollerTrumbore,
    MollerTrumboreInF64, NoFallback, PerpendicularPlanes, Plucker, Precomputed, Shevtsov,
    SignedAreas, Vertices, Wald, WithNormal, WoopAffine, WoopWatertight,
};
use crate::policy::{Division, First, Last};

use super::Offers;

/// What is done with each kernel.
pub trait KernelVisitor {
    /// With a kernel, or one of its stored forms.
    fn kernel<K: Offers>(&mut self);
    /// With a kernel that keeps the signs of its edge functions in another way than by default.
    fn other_edges<K: Offers>(&mut self) {
        self.kernel::<K>();
    }
}

/// Visits every kernel.
pub fn visit_kernels(visitor: &mut impl KernelVisitor) {
    visitor.kernel::<MollerTrumbore>();
    // Parsers are fuzzed: to them one kernel is like another, and all of them are hours of building.
    if cfg!(fuzzing) {
        return;
    }
    visitor.kernel::<KenslerShirley<Vertices>>();
    visitor.kernel::<Wald>();
    visitor.kernel::<PerpendicularPlanes>();
    visitor.kernel::<Chirkov>();
    visitor.kernel::<AngleSum>();
    visitor.kernel::<WoopWatertight<Fallback>>();
    // The library's own tests need a kernel of each kind; those in `tests` have every one.
    if cfg!(test) {
        return;
    }
    visitor.kernel::<KenslerShirley<WithNormal>>();
    visitor.kernel::<KenslerShirley<Precomputed>>();
    visitor.kernel::<Shevtsov>();
    visitor.kernel::<BadouelCramer>();
    visitor.kernel::<Keidy<Vertices>>();
    visitor.kernel::<Keidy<WithNormal>>();
    visitor.kernel::<Plucker>();
    visitor.kernel::<HalfSpaces>();
    visitor.kernel::<SignedAreas>();
    visitor.other_edges::<WoopWatertight<NoFallback>>();
    visitor.other_edges::<WoopWatertight<ExactSign>>();
    visitor.kernel::<EmbreePlucker>();
    visitor.kernel::<BaldwinWeber<FromPositions>>();
    visitor.kernel::<BaldwinWeber<FromRows>>();
    visitor.kernel::<WoopAffine>();
    visitor.kernel::<MollerTrumboreInF64>();
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
