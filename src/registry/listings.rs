//! The published listings: single, early and plain; two outputs; and the forms that price their
//! operations.

use crate::batch::{Listed, PairsLoop};
use crate::kernels::listings::{
    Badouel, ChirkovLine, Listing, Literally, Moller, Placement, Priced, Script,
};
use crate::level::{self, Level, On};
use crate::number::Element;
use crate::policy::Ray;

use super::{Axes, ListingVisitor, Variant, bind_pairs, visit_listings};

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
type Base = level::Sse2;
#[cfg(target_arch = "aarch64")]
type Base = level::Neon;

struct Timed<'a>(&'a mut Vec<Variant>);

impl ListingVisitor for Timed<'_> {
    fn listing<K: Listing>(&mut self, division: &'static str) {
        levels::<K>(self.0, division);
    }
}

/// Every listing.
pub fn all(v: &mut Vec<Variant>) {
    visit_listings(&mut Timed(v));
    price::<Moller<1>, DOT>(v, "last");
    price::<Moller<1>, CROSS>(v, "last");
    price::<Moller<1>, DIFFERENCE>(v, "last");
    price::<Moller<1>, DIVISION>(v, "last");
    price::<Moller<1>, CONDITION>(v, "last");
    price::<Badouel, DOT>(v, "first");
    price::<Badouel, DIVISION>(v, "first");
    price::<Badouel, CONDITION>(v, "first");
    price::<ChirkovLine, DOT>(v, "last");
    price::<ChirkovLine, DIVISION>(v, "last");
    price::<ChirkovLine, CONDITION>(v, "last");
}

/// Indices into the kinds of [`Priced`]; each listing is priced for those that it has.
const DOT: usize = 0;
const CROSS: usize = 1;
const DIFFERENCE: usize = 2;
const DIVISION: usize = 3;
const CONDITION: usize = 4;

/// Three copies of thesis B's `moller`, the reference of its experiments.
pub fn placebos(v: &mut Vec<Variant>) {
    form::<Moller<1>, f32, Base, Literally, false, 1>(v, Placement::AtTheEnd.division());
    form::<Moller<1>, f32, Base, Literally, false, 2>(v, Placement::AtTheEnd.division());
    form::<Moller<1>, f32, Base, Literally, false, 3>(v, Placement::AtTheEnd.division());
}

fn levels<K: Listing>(v: &mut Vec<Variant>, division: &'static str) {
    outputs::<K, f32, Base>(v, division);
    outputs::<K, f64, Base>(v, division);
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        outputs::<K, f32, level::Avx2>(v, division);
        outputs::<K, f64, level::Avx2>(v, division);
    }
}

fn outputs<K: Listing, E: Element + On<L>, L: Level>(v: &mut Vec<Variant>, division: &'static str) {
    form::<K, E, L, Literally, false, 0>(v, division);
    form::<K, E, L, Literally, true, 0>(v, division);
}

/// A kind of operation twice, and its control (thesis B, 4.4).
fn price<K: Listing, const KIND: usize>(v: &mut Vec<Variant>, division: &'static str) {
    form::<K, f32, Base, Priced<KIND, true>, false, 0>(v, division);
    form::<K, f32, Base, Priced<KIND, false>, false, 0>(v, division);
}

fn form<K, E, L, S, const UV: bool, const COPY: usize>(v: &mut Vec<Variant>, division: &'static str)
where
    K: Listing,
    E: Element + On<L>,
    L: Level,
    S: Script,
{
    fn exit_code<K: Listing, E: Element>(ray: &Ray<E>, record: &K::Record<E>) -> u8 {
        K::run::<E, Literally, true>(ray, record).0
    }
    let run: PairsLoop<E, K::Record<E>> = L::enter::<Listed<K, S, E, UV>, COPY>;
    let axes = Axes {
        division,
        output: if UV { "tuv" } else { "t" },
        leading: "inside",
        priced: S::NAME,
        stored: K::ABOUT.stored,
        copy: COPY,
        ..Axes::usual(K::ABOUT.id, E::NAME, L::NAME)
    };
    v.push(Variant {
        axes,
        about: &K::ABOUT,
        bytes_per_triangle: size_of::<K::Record<E>>(),
        available: level::available::<L>,
        pairs: Some(bind_pairs(K::prepare::<E>, run, exit_code::<K, E>)),
        nearest: None,
        tiles: None,
        preparing: None,
        rays: 1,
        lanes: 1,
        work: None,
    });
}
