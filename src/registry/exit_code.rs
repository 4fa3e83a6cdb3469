//! Where one test ends.

use crate::number::Element;
use crate::policy::{
    Between, Compare, Early, First, Form, Last, Plain, Policy, Ray, Tuv, TwoSided,
};

use super::Offers;

/// The exit of one test, in the kernel's own order.
pub fn exit_code<K: Offers, E: Element>(ray: &Ray<E>, record: &K::Record<E>) -> u8 {
    fn exit<K: Offers, P: Policy, E: Element>(ray: &Ray<E>, record: &K::Record<E>) -> u8 {
        let (aim, met) = (K::aim::<P, E>(ray), K::meet::<P, E>((), record));
        K::test::<P, E>(ray, &aim, &met).map_or_else(|miss| miss.0, |_| 0)
    }
    if K::LAST {
        exit::<K, Form<Early, Last, Plain, Tuv, TwoSided, Compare, K::Native, Between>, E>(
            ray, record,
        )
    } else {
        exit::<K, Form<Early, First, Plain, Tuv, TwoSided, Compare, K::Native, Between>, E>(
            ray, record,
        )
    }
}
