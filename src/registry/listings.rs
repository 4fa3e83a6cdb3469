//! The published listings: single, early and plain; two outputs; and the forms that price their
//! operations.

use crate::batch::{Listed, PairsLoop};
use crate::kernels::listings::{
    Badouel, ChirkovLine, Listing, Literally, Moller, Placement, Priced, Script,
};
use crate::level::{self, Level, On, enter};
use crate::number::Element;
use crate::policy::Ray;

use super::{Axes, Variant, bind_pairs};

#[cfg(target_arch = "x86_64")]
type Base = level::Sse2;
#[cfg(target_arch = "aarch64")]
type Base = level::Neon;

/// Every listing.
pub fn all(v: &mut Vec<Variant>) {
    levels::<Moller<0>>(v, Placement::AtOnce.division());
    levels::<Moller<1>>(v, Placement::AtTheEnd.division());
    levels::<Moller<2>>(v, Placement::BeforeTheBranch.division());
    levels::<Moller<3>>(v, Placement::BeforeTheBranchWithQ.division());
    levels::<Badouel>(v, "first");
    levels::<ChirkovLine>(v, "last");
    prices::<Moller<1>>(v, "last");
    prices::<Badouel>(v, "first");
    prices::<ChirkovLine>(v, "last");
}

fn levels<K: Listing>(v: &mut Vec<Variant>, division: &'static str) {
    outputs::<K, f32, Base>(v, division);
    outputs::<K, f64, Base>(v, division);
    #[cfg(target_arch = "x86_64")]
    {
        outputs::<K, f32, level::Avx2>(v, division);
        outputs::<K, f64, level::Avx2>(v, division);
    }
}

fn outputs<K: Listing, E: Element + On<L>, L: Level>(v: &mut Vec<Variant>, division: &'static str) {
    form::<K, E, L, Literally, false>(v, division);
    form::<K, E, L, Literally, true>(v, division);
}

/// Each kind of operation twice, and its control (thesis B, 4.4).
fn prices<K: Listing>(v: &mut Vec<Variant>, division: &'static str) {
    price::<K, 0>(v, division);
    price::<K, 1>(v, division);
    price::<K, 2>(v, division);
    price::<K, 3>(v, division);
    price::<K, 4>(v, division);
}

fn price<K: Listing, const KIND: usize>(v: &mut Vec<Variant>, division: &'static str) {
    form::<K, f32, Base, Priced<KIND, true>, false>(v, division);
    form::<K, f32, Base, Priced<KIND, false>, false>(v, division);
}

fn form<K, E, L, S, const UV: bool>(v: &mut Vec<Variant>, division: &'static str)
where
    K: Listing,
    E: Element + On<L>,
    L: Level,
    S: Script,
{
    fn exit_code<K: Listing, E: Element>(ray: &Ray<E>, record: &K::Record<E>) -> u8 {
        K::run::<E, Literally, true>(ray, record).0
    }
    let run: PairsLoop<E, K::Record<E>> = enter::<L, Listed<K, S, E, UV>, 0>;
    let axes = Axes {
        kernel: K::ABOUT.id,
        precision: E::NAME,
        drive: "single".into(),
        level: L::NAME,
        exit: "early",
        division,
        rounding: "plain",
        output: if UV { "tuv" } else { "t" },
        cull: "off",
        layout: "aos",
        leading: "inside",
        leading_is_native: true,
        priced: S::NAME,
        query: "ray",
        stored: K::ABOUT.stored,
        stored_is_native: true,
        tests: "compare",
        copy: 0,
    };
    v.push(Variant {
        axes,
        about: &K::ABOUT,
        bytes_per_triangle: size_of::<K::Record<E>>(),
        available: level::available::<L>,
        pairs: Some(bind_pairs(K::prepare::<E>, run, exit_code::<K, E>)),
        nearest: None,
        lanes: 1,
    });
}
