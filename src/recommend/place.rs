//! Where a row stands, in words.

use crate::table::Row;

/// `h-7, nearest-random, reshuffled`, with the density where there is one: what finds the row in
/// `rows.csv`, together with its id.
pub(super) fn place(row: &Row) -> String {
    let mut parts = vec![row.experiment.clone(), setting(row)];
    parts.retain(|part| !part.is_empty());
    parts.join(", ")
}

/// The same without the experiment.
pub(super) fn setting(row: &Row) -> String {
    let mut parts = vec![row.workload.clone(), row.order.clone()];
    parts.extend(row.density.map(|density| format!("density {density}")));
    parts.extend(row.set_bytes.map(|bytes| format!("{bytes} bytes of triangles")));
    parts.extend(row.spread.map(|spread| format!("spread {spread}")));
    parts.retain(|part| !part.is_empty());
    parts.join(", ")
}

/// Three significant digits, which is what intervals here support.
pub(super) fn figure(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e6).contains(&value.abs()) {
        return format!("{value:.1e}");
    }
    let digits = 2 - value.abs().max(1e-3).log10().floor() as i32;
    format!("{value:.*}", digits.clamp(0, 6) as usize)
}

/// A share as percent with a sign: `+3.1 %`.
pub(super) fn percent(share: f64) -> String {
    format!("{:+.1} %", share * 100.0)
}

/// `1 form`, `2 forms`
pub(super) fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}
