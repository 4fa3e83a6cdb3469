//! What each kernel offers of each axis.

use crate::kernels::{
    AngleSum, BadouelCramer, BaldwinWeber, Chirkov, Column, Edges, EmbreePlucker, HalfSpaces,
    Keidy, KenslerShirley, Kernel, MollerTrumbore, MollerTrumboreInF64, PerpendicularPlanes,
    Plucker, Precomputed, Projection, Shevtsov, SignedAreas, Stored, Triple, Vertices, Wald,
    WithNormal, WoopAffine, WoopWatertight,
};
use crate::policy::{Distance, Inside, Leading};

/// What a kernel offers of each axis.
pub trait Offers: Kernel {
    /// It can divide first.
    const FIRST: bool = true;
    /// It can divide last.
    const LAST: bool = true;
    /// The test that comes first in its published form.
    type Native: Other;
    /// Its tests can come in the other order.
    const BOTH_ORDERS: bool = false;
    /// Thesis H's sign-bit form.
    const SIGN_BITS: bool = false;
    /// Comparisons of products beside those of signs.
    const PRODUCTS: bool = false;
    /// It can cull.
    const CULLS: bool = false;
    /// It runs in packets.
    const PACKETS: bool = true;
    /// It runs on f64 as well.
    const F64: bool = true;
    /// How its edge functions keep their signs; empty where it has no such choice.
    const EDGES: &'static str = "";
    /// How it knows the axis of its projection; empty where it has no such choice.
    const PROJECTION: &'static str = "";
    /// Which cross product its triple products are computed by; empty for its own.
    const CROSS: &'static str = "";
    /// It stands for the others where triangles come in groups.
    const GROUPS: bool = false;
    /// It stands for the others in bundles: something is computed of a triangle alone, or, as with
    /// Wald's, nothing is.
    const BUNDLES: bool = false;
    /// It stands for the others in memory layouts.
    const LAYOUTS: bool = false;
    /// Its test is written in vectors alone, whose numbers may lie in one register.
    const VECTORS: bool = false;
    /// It stands for the others where reciprocals and branches are compared.
    const TECHNIQUES: bool = false;
    /// It can ask for the inside first, and stands for those that do, all signs of it in one question.
    const INSIDE_FIRST: bool = false;
    /// It yields u and v.
    const UV: bool = true;
    /// Its record is the first, or only, that the kernel has.
    const NATIVE_RECORD: bool = true;
}

impl Offers for MollerTrumbore {
    type Native = Inside;
    const VECTORS: bool = true;
    const GROUPS: bool = true;
    const BUNDLES: bool = true;
    const TECHNIQUES: bool = true;
    const LAYOUTS: bool = true;
    const INSIDE_FIRST: bool = true;
    const BOTH_ORDERS: bool = true;
    const SIGN_BITS: bool = true;
    const CULLS: bool = true;
}
impl<S: Stored + IsVertices, O: Triple> Offers for KenslerShirley<S, O> {
    const CROSS: &'static str = O::NAME;
    type Native = Distance;
    const VECTORS: bool = true;
    const GROUPS: bool = S::IS_PRECOMPUTED;
    const BUNDLES: bool = S::IS_VERTICES;
    const LAYOUTS: bool = S::IS_PRECOMPUTED;
    const TECHNIQUES: bool = S::IS_PRECOMPUTED;
    const INSIDE_FIRST: bool = S::IS_PRECOMPUTED;
    const BOTH_ORDERS: bool = S::IS_VERTICES;
    const SIGN_BITS: bool = S::IS_VERTICES && O::NAME.is_empty();
    const CULLS: bool = S::IS_VERTICES;
    const NATIVE_RECORD: bool = S::IS_VERTICES;
}
impl Offers for Shevtsov {
    type Native = Distance;
    const GROUPS: bool = true;
    const SIGN_BITS: bool = true;
    const CULLS: bool = true;
}
impl Offers for BadouelCramer {
    type Native = Distance;
    const SIGN_BITS: bool = true;
}
impl<X: Projection> Offers for Wald<X> {
    const PROJECTION: &'static str = X::NAME;
    type Native = Distance;
    const GROUPS: bool = true;
    const BUNDLES: bool = true;
    const TECHNIQUES: bool = true;
    const LAYOUTS: bool = true;
    const SIGN_BITS: bool = true;
}
impl<S: Stored + IsVertices> Offers for Keidy<S> {
    type Native = Distance;
    const BUNDLES: bool = S::IS_VERTICES;
    const BOTH_ORDERS: bool = S::IS_VERTICES;
    const SIGN_BITS: bool = S::IS_VERTICES;
    const NATIVE_RECORD: bool = S::IS_VERTICES;
}
impl Offers for PerpendicularPlanes {
    type Native = Distance;
    const GROUPS: bool = true;
    const TECHNIQUES: bool = true;
    const LAYOUTS: bool = true;
    const SIGN_BITS: bool = true;
}
impl Offers for Chirkov {
    type Native = Inside;
    const FIRST: bool = false;
    const PRODUCTS: bool = true;
}
impl Offers for Plucker {
    type Native = Inside;
    const BUNDLES: bool = true;
    const FIRST: bool = false;
}
impl Offers for HalfSpaces {
    type Native = Inside;
    const FIRST: bool = false;
}
impl Offers for SignedAreas {
    type Native = Distance;
    const LAST: bool = false;
}
impl Offers for AngleSum {
    type Native = Distance;
    const LAST: bool = false;
    const PACKETS: bool = false;
    const UV: bool = false;
}
impl<E: Edges> Offers for WoopWatertight<E> {
    type Native = Inside;
    const GROUPS: bool = true;
    const EDGES: &'static str = E::NAME;
}
impl Offers for EmbreePlucker {
    type Native = Inside;
    const GROUPS: bool = true;
    const LAST: bool = false;
}
impl<C: Column> Offers for BaldwinWeber<C> {
    type Native = Distance;
    const GROUPS: bool = C::AS_PUBLISHED;
    const NATIVE_RECORD: bool = C::AS_PUBLISHED;
}
impl Offers for WoopAffine {
    type Native = Distance;
    const GROUPS: bool = true;
}
impl Offers for MollerTrumboreInF64 {
    type Native = Inside;
    const PACKETS: bool = false;
    const F64: bool = false;
}

/// Which record of several is the kernel's first.
pub trait IsVertices {
    /// Three vertices, nothing prepared.
    const IS_VERTICES: bool = false;
    /// Edges and normal.
    const IS_PRECOMPUTED: bool = false;
}
impl IsVertices for Vertices {
    const IS_VERTICES: bool = true;
}
impl IsVertices for WithNormal {}
impl IsVertices for Precomputed {
    const IS_PRECOMPUTED: bool = true;
}

/// The other order of tests.
pub trait Other: Leading {
    /// Distance for inside, inside for distance.
    type Other: Leading;
}
impl Other for Distance {
    type Other = Inside;
}
impl Other for Inside {
    type Other = Distance;
}
