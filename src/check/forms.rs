//! Which form of a kernel stands for it.

use crate::number::Precision;
use crate::registry::{Asked, asked};

/// The ids of all kernels that can be asked, in the order of the registry.
pub fn kernels() -> Vec<&'static str> {
    let mut ids: Vec<&'static str> = Vec::new();
    for form in asked() {
        if !ids.contains(&form.about.id) {
            ids.push(form.about.id);
        }
    }
    ids
}

/// A kernel in its own form: plain rounding, signs compared, what it stores first and its own order
/// of tests, divided last where it can be. `None` if the kernel has no form in the precision.
pub fn form(kernel: &str, precision: Precision) -> Option<&'static Asked> {
    let of_kernel =
        |form: &&Asked| form.axes.kernel == kernel && form.axes.precision == precision.name();
    asked().iter().filter(of_kernel).min_by_key(|form| {
        let axes = &form.axes;
        (
            axes.rounding != "plain",
            axes.tests != "compare",
            !axes.stored_is_native,
            !axes.leading_is_native,
            axes.division != "last",
        )
    })
}
